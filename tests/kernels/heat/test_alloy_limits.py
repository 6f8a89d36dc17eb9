"""Where the model of an alloy ends: what is refused at the start, what stops a run, and with which words."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import DivergenceError, InputError
from warpsph.run.simulation import Simulation
from warpsph.scenarios import SodiumNitrate
from warpsph.terms import Alloy, HeatWall, Liquidus, Solute

LIQUIDUS = Liquidus.straight(273.15, 42.28, 255.65)
ICE = solid_material("ice", 917.0, conductivity=2.408, heat_capacity=2006.0)
SOLUTION = fluid_material("solution", 1097.0, conductivity=0.498, heat_capacity=4180.0)
SPACING, ROWS = 0.02, 10


def column(device="cpu", cold=None, diffusivity=0.0, **given):
    """Particles along x, with the wall at x = 0 of a given temperature."""
    size = (ROWS * SPACING, 4 * SPACING)
    walls = [HeatWall.insulated(n, at) for n, at in (((-1, 0, 0), -size[0]), ((0, 1, 0), 0.0), ((0, -1, 0), -size[1]))]
    if cold is not None:
        walls.append(HeatWall.at_temperature((1, 0, 0), 0.0, cold))
    particles = Particles()
    particles.add(lattice((0.0, 0.0), size, SPACING), Role.FREE, **({"temperature": 280.0, "solute": 0.14} | given))
    alloy = Alloy(ICE, 334.4e3, LIQUIDUS, walls)
    model = Model(2, SPACING, (SOLUTION,), (Solute(diffusivity, walls), alloy), 2.0, gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device, 1), model, particles)


SOME_PURE = np.where(np.arange(4 * ROWS) < 3, 0.0, 0.14)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"temperature": 150.0}, r"'temperature' = 150 at .* of 40 particles: below the end of the liquidus, 255.65 K"),
        ({"temperature": -100.0}, "'temperature' was given -100 K: must not be below 0 K"),
        ({"ice_temperature": -1.0}, "'ice_temperature' was given -1 K: must not be below 0 K"),
        ({"ice_mass": 5.0}, "'ice_mass' = 5 at .* more than there is room for"),
        ({"ice_mass": -0.1}, "'ice_mass' was given -0.1 kg: must not be below 0 kg"),
        ({"liquid_mass": -0.1}, "'liquid_mass' was given -0.1 kg: must not be below 0 kg"),
        ({"liquid_mass": 0.0, "solute_mass": 0.1}, "'liquid_mass' = 0 at .* must be positive"),
        ({"solute": 0.5}, "'solute' = 0.5 at .* beyond the end of the liquidus, 0.413"),
        ({"solute": 0.0}, "'solute' = 0 at .* of 40 particles: there is none: all of a pure solvent .* PhaseChange or"),
        ({"solute": SOME_PURE}, "'solute' = 0 at .* of 3 particles: there is none"),
        ({"solute": 0.01, "cold": 260.0}, "ice would fill 1.16 of the room at the wall of 260 K"),
    ],
)
def test_starts_that_the_model_has_no_way_for_are_refused(given, message):
    """If it failed, mass would be made, or a run would end in numbers that are none, or freeze nothing."""
    with pytest.raises(InputError, match=message) as caught:
        column(**given)
    assert "\n" not in str(caught.value)


def test_a_place_without_liquid_is_reported():
    """If it failed, ice would fill more than all of its room, and later end in numbers that are none."""
    case = SodiumNitrate(diffusivity=1e-4, columns=4, rows=20)
    with pytest.raises(DivergenceError, match=r"no liquid is left: ice would fill 1.* of the room; the model leaves"):
        case.run(device="cpu")


def test_liquid_beyond_the_end_of_the_liquidus_is_reported(device):
    """If it failed, a body would freeze below the eutectic as if there were no other solid than ice."""
    simulation = column(device, solute=0.3)
    simulation.prepare()
    mass = simulation.state.numpy("liquid_mass")
    simulation.state.liquid_heat.assign(mass * 4180.0 * (200.0 - 273.15))
    simulation.solver.act("after_heat")
    simulation.solver.act("find_temperature")
    with pytest.raises(DivergenceError, match=r"the liquid holds .* beyond the end of the liquidus, 0.4139; the model"):
        simulation.solver.check()


def test_even_all_but_pure_solvent_keeps_its_numbers(device):
    """If it failed, liquid without room for its solute would divide zero by zero before anybody looks."""
    simulation = column(device, solute=1e-12)
    simulation.prepare()
    mass = simulation.state.numpy("liquid_mass")
    simulation.state.liquid_heat.assign(mass * -5e5)  # more than all latent heat
    for _ in range(20):
        simulation.solver.act("after_heat")
        simulation.solver.act("find_temperature")
    for name in ("temperature", "ice_temperature", "solid_fraction", "liquid_heat", "ice_heat"):
        assert np.all(np.isfinite(simulation.state.numpy(name))), name
    with pytest.raises(DivergenceError, match="no liquid is left"):
        simulation.solver.check()


def test_a_wall_at_the_end_of_the_liquidus_is_no_step_beyond_it(device):
    """If it failed, rounding would end a run that comes to rest exactly where the model ends."""
    result = column(device, cold=255.65).run(1e6, 1e6)
    assert result.fields["solute"].max() == pytest.approx(17.5 / 42.28, rel=1e-3)
