"""Parts of a machine, each alone on a few particles."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import COPPER, WATER, thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.machine import (
    Inlet,
    LevelGauge,
    OscillatingMould,
    Outflow,
    Settling,
    ShellSpeedometer,
    Spray,
    SprayZone,
    SymmetryPlane,
)
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, SummedDensity

SPACING = 0.01
SPEED = 0.05
TOP, MOUTH = 0.2, 0.15


def simulation_of(device: str, particles: Particles, parts) -> Simulation:
    model = Model(
        2,
        SPACING,
        (thesis_steel(), COPPER, WATER),
        (Fluid(2100.0, 10.0), SummedDensity(), Conduction({("water", "water"): 0.0})),
        gravity=(0.0, -1e-12, 0.0),
    )
    return Simulation(Executor(device), model, particles, parts=parts)


def gauge() -> LevelGauge:
    return LevelGauge((0.0, 0.0, -1.0), (1.0, 1.0, 1.0), 0.1, SPEED, area_ratio=1.0, gain=0.0, response=1e9)


def test_mould_moves_as_a_sine(device):
    """Negative strip and friction depend on the stroke and its phase."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.03, 0.05), SPACING), Role.WALL, "copper")
    simulation = simulation_of(device, particles, [OscillatingMould(stroke=0.006, frequency=1.5)])
    start = particles.position[:, 1]
    for until in (0.1, 1.0 / 6.0, 0.5):
        simulation.run(until - simulation.time, until - simulation.time)
        s = simulation.snapshot()
        angle = 2.0 * np.pi * 1.5 * (simulation.time - 0.0)
        assert np.allclose(s["position"][:, 1] - start, 0.003 * np.sin(angle), atol=2e-5)
        assert np.allclose(s["velocity"][:, 1], 0.003 * 3.0 * np.pi * np.cos(angle), atol=3e-4)


def test_symmetry_plane_reflects(device):
    """What leaks through the axis of the strand is lost."""
    particles = Particles()
    particles.add(np.array([[0.004, 0.0, 0.0]]), Role.FREE, "steel", temperature=1900.0, velocity=(-0.5, 0.1, 0.0))
    simulation = simulation_of(device, particles, [SymmetryPlane((1.0, 0.0, 0.0), 0.0)])
    simulation.run(0.02, 0.02)
    s = simulation.snapshot()
    assert s["position"][0] == pytest.approx([0.006, 0.002, 0.0], abs=1e-6)
    assert s["velocity"][0] == pytest.approx([0.5, 0.1, 0.0], abs=1e-6)


def test_a_solid_slides_along_its_plane_of_symmetry(device):
    """A shell whose edge leaves the plane lets melt through; its mirror image would hold it."""
    particles = Particles()
    particles.add(
        np.array([[0.005, 0.0, 0.0], [0.015, 0.1, 0.0]]),
        Role.FREE,
        "steel",
        temperature=300.0,
        velocity=(0.5, 0.1, 0.0),
        phase=Phase.SOLID,
    )
    simulation = simulation_of(device, particles, [SymmetryPlane((1.0, 0.0, 0.0), 0.0)])
    simulation.run(0.02, 0.02)
    s = simulation.snapshot()
    assert s["position"] == pytest.approx(np.array([[0.005, 0.002, 0.0], [0.025, 0.102, 0.0]]), abs=1e-6)
    assert s["velocity"] == pytest.approx(np.array([[0.0, 0.1, 0.0], [0.5, 0.1, 0.0]]), abs=1e-6)


def nozzle_and_strand(device: str, reserve: int = 60, strand_rows: int = 4) -> Simulation:
    """A nozzle over an outflow zone, both kinematic, with nothing between: what enters falls through and leaves."""
    particles = Particles()
    row = lattice((0.0, 0.0), (3 * SPACING, SPACING), SPACING)
    row[:, 1] = TOP
    filling = np.concatenate([row - np.array([0.0, k * SPACING, 0.0]) for k in range(5)])
    particles.add(filling, Role.INFLOW, "steel", temperature=1933.0)
    strand = lattice((0.0, -strand_rows * SPACING), (3 * SPACING, 0.0), SPACING)
    particles.add(strand, Role.OUTFLOW, "steel", temperature=1700.0)
    particles.add(np.tile([[0.0, TOP, 0.0]], (reserve, 1)), Role.RESERVOIR, "steel", temperature=1933.0)
    level = gauge()
    return simulation_of(
        device,
        particles,
        [
            level,
            Outflow(level, 0.0, -4 * SPACING, 1.0),
            Inlet(level, row, (0.0, -1.0, 0.0), TOP - MOUTH, 1933.0, "steel"),
        ],
    )


def test_inlet_and_outflow_keep_the_ledger(device):
    """A particle that is lost or doubled is mass from nowhere."""
    simulation = nozzle_and_strand(device)
    before = simulation.snapshot()
    inside = np.sum(before["role"] != Role.RESERVOIR)
    simulation.run(4.0, 1.0)
    s = simulation.snapshot()
    entries, exits = int(s["entries"].sum()), int(s["exits"].sum())
    assert np.sum(s["role"] != Role.RESERVOIR) == inside + entries - exits
    assert np.array_equal(s["id"], np.arange(len(s["id"])))
    assert entries == pytest.approx(3 * 4.0 * SPEED / SPACING, abs=4)
    assert exits >= 12
    assert s["heat_entered"].sum() == pytest.approx(entries * s["mass"][0] * thesis_steel().enthalpy(1933.0), rel=1e-6)
    content = lambda state: np.sum((state["mass"].astype(float) * state["enthalpy"])[state["role"] != Role.RESERVOIR])  # noqa: E731
    change = content(s) - content(before)
    assert change == pytest.approx(s["heat_entered"].sum() - s["heat_left"].sum(), rel=1e-5)


def test_rows_follow_without_a_gap(device):
    """A gap or an overlap of rows would be a pressure wave at the mouth of the nozzle."""
    simulation = nozzle_and_strand(device)
    simulation.run(1.93, 1.93)
    s = simulation.snapshot()
    heights = np.unique(np.round(s["position"][s["role"] == Role.INFLOW, 1], 5))
    assert np.allclose(np.diff(heights), SPACING, atol=2e-4)
    assert TOP - SPACING < heights[-1] <= TOP


def test_an_empty_reservoir_is_counted(device):
    """Melt that silently fails to arrive would look like a falling level."""
    simulation = nozzle_and_strand(device, reserve=4, strand_rows=0)
    simulation.run(0.9, 0.9)
    assert simulation.model.the(Inlet).missing.numpy()[0] > 0


def test_outflow_speed_is_proportional_to_the_level(device):
    """v = k p is what keeps the machine at its level."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.2, 0.05), SPACING), Role.FREE, "steel", temperature=1900.0)
    level = LevelGauge((0.0, 0.0, -1.0), (0.2, 1.0, 1.0), 0.1, SPEED, area_ratio=2.0, gain=10.0, response=1e-9)
    simulation = simulation_of(device, particles, [level])
    simulation.run(0.005, 0.005)
    height, out, inflow = level.speeds.numpy()
    assert height == pytest.approx(0.05, rel=1e-4)
    assert out == pytest.approx(0.5 * SPEED, rel=1e-4)
    assert inflow == pytest.approx(2.0 * out * (1.0 + 10.0 * 0.5), rel=1e-4)


def test_spray_boils_and_returns(device):
    """Water that never boils cools for nothing; water that is not counted is heat from nowhere."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.05, 0.2), SPACING), Role.WALL, "copper", temperature=600.0)
    wall_capacity = 387.0
    parked, volume = np.tile([[0.1, 0.0, 0.0]], (40, 1)), 1e-3 / WATER.density
    particles.add(parked, Role.RESERVOIR, "water", temperature=300.0, flows=False, volume=volume)
    zones = [SprayZone(0.0, 0.1, rate=20.0), SprayZone(0.1, 0.2, rate=20.0, off=1.0)]
    water = Spray(zones, 0.08, 0.2, near=1.3 * SPACING, lost=-0.1, temperature=300.0, boiled=374.15, material="water")
    simulation = simulation_of(device, particles, [water])
    simulation.run(2.0, 0.5)
    s = simulation.snapshot()
    sprayed = water.sprayed.numpy()
    assert list(sprayed) == pytest.approx([40, 20], abs=1)
    of_water = s["material"] == simulation.model.index_of("water")
    assert s["entries"][of_water].sum() == sprayed.sum()
    metal = s["material"] == simulation.model.index_of("copper")
    assert np.all(s["exits"][metal] == 0)
    lost_by_metal = np.sum(s["mass"][metal].astype(float) * (600.0 * wall_capacity - s["enthalpy"][metal]))
    present = of_water & (s["role"] == Role.SPRAY)
    in_water = np.sum((s["mass"].astype(float) * s["enthalpy"])[present])
    balance = in_water + s["heat_left"][of_water].sum() - s["heat_entered"][of_water].sum()
    assert lost_by_metal == pytest.approx(balance, rel=1e-3, abs=1.0)


def test_the_speedometer_does_not_forget(device):
    """A jump lasts a millisecond, and two frames are a hundred apart."""
    row = np.arange(-4, 5)[:, None] * [0.0, SPACING, 0.0]
    particles = Particles()
    particles.add(row, Role.FREE, "steel", temperature=600.0, velocity=(0.0, 0.3, 0.0), phase=Phase.SOLID)
    particles.add([[0.1, 0.0, 0.0]], Role.FREE, "steel", temperature=600.0, velocity=(0.0, 0.9, 0.0))
    meter, drag = ShellSpeedometer(), Settling(rate=500.0, until=1.0)
    simulation = simulation_of(device, particles, [Elasticity(4e5, 0.3), meter, drag])
    simulation.run(0.05, 0.05)
    assert 0.2 < meter.read()[0] <= 0.3
    assert meter.read() == (0.0, 0.0)
    simulation.run(0.05, 0.05)
    assert max(meter.read()) < 1e-6


def test_the_speedometer_tells_the_shell_from_grains_in_the_melt(device):
    """A grain that the melt carries would be taken for a shell that jumps."""
    row = np.arange(-4, 5)[:, None] * [0.0, SPACING, 0.0]
    particles = Particles()
    particles.add(row, Role.FREE, "steel", temperature=600.0, phase=Phase.SOLID)
    particles.add([[0.1, 0.0, 0.0]], Role.FREE, "steel", temperature=600.0, velocity=(0.0, 0.3, 0.0), phase=Phase.SOLID)
    meter = ShellSpeedometer()
    simulation_of(device, particles, [Elasticity(4e5, 0.3), meter]).run(0.01, 0.01)
    shell, grains = meter.read()
    assert shell < 0.01
    assert grains == pytest.approx(0.3, abs=0.01)
