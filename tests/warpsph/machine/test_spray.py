"""Water on the strand: outside of it, beside the rolls, and away with it."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import WATER, thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.machine import Rolls, Spray, SprayZone
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, PhaseChange, SummedDensity

SPACING, FACE = 0.004, 0.04


def sprayed(device: str, *, velocity=(0.0, 0.0, 0.0), rate: float = 0.0, drops=(), rolls=None, end=-1.0) -> Simulation:
    """A solid block of cool steel, its face at ``FACE``, and drops of water that are there from the start."""
    particles = Particles()
    block = lattice((0.0, 0.0), (FACE, 0.1), SPACING)
    particles.add(block, Role.FREE, "steel", temperature=350.0, velocity=velocity)
    volume = 1e-3 / WATER.density
    drops = np.reshape(drops, (-1, 3))
    particles.add(drops, Role.SPRAY, "water", temperature=300.0, flows=False, volume=volume)
    parked = np.tile([[0.08, 0.0, 0.0]], (30, 1))
    particles.add(parked, Role.RESERVOIR, "water", temperature=300.0, flows=False, volume=volume)
    heat = Conduction({("water", "water"): 0.0})
    terms = (Fluid(2100.0, 10.0), SummedDensity(), heat, PhaseChange(), Elasticity(4e5, 0.3))
    model = Model(2, SPACING, (thesis_steel(), WATER), terms, gravity=(0.0, 0.0, 0.0))
    water = Spray(
        [SprayZone(0.02, 0.08, rate)], 0.08, 0.2, near=1.2 * SPACING, lost=-1.0, temperature=300.0, boiled=374.15,
        material="water", end=end, rolls=rolls,
    )  # fmt: skip
    return Simulation(Executor(device), model, particles, parts=[water, *([rolls] if rolls else [])])


def test_water_stays_outside_of_a_face_that_comes_towards_it(device):
    """Water inside the steel would cool it from within."""
    simulation = sprayed(device, velocity=(0.05, 0.0, 0.0), rate=60.0)
    for _ in range(5):
        simulation.run(0.1, 0.1)
        state = simulation.snapshot()
        water, steel = state["role"] == Role.SPRAY, state["phase"] == Phase.SOLID
        surface = state["position"][steel, 0].max()
        assert state["position"][water, 0].min() > surface + 0.3 * SPACING
    assert np.sum(water) > 15
    assert simulation.model.the(Spray).caught.numpy()[0] == 0


def test_water_that_is_inside_is_caught_and_counted(device):
    """What nobody can see would be heat that nobody can explain."""
    simulation = sprayed(device, drops=[[FACE - 2.2 * SPACING, 0.05, 0.0], [FACE + 0.7 * SPACING, 0.05, 0.0]])
    simulation.run(0.02, 0.01)
    state = simulation.snapshot()
    assert simulation.model.the(Spray).caught.numpy()[0] == 1
    assert np.sum(state["role"] == Role.SPRAY) == 1
    assert np.sum(state["exits"]) == 1


@pytest.mark.parametrize("velocity", [(0.0, -0.02, 0.0), (0.01, -0.02, 0.0)])
def test_water_stands_in_the_nip_of_a_roll(device, velocity):
    """The strand would drag it through between roll and steel, where there is no room."""
    rolls = Rolls(FACE + 0.012, [0.03], 0.01)
    simulation = sprayed(device, velocity=velocity, drops=[[FACE + 0.8 * SPACING, 0.06, 0.0]], rolls=rolls)
    for _ in range(20):
        simulation.run(0.05, 0.05)
        state = simulation.snapshot()
        drop = state["position"][state["role"] == Role.SPRAY]
        if len(drop):
            gap = np.hypot(drop[:, 0] - FACE - 0.022, drop[:, 1] - 0.03) - 0.01
            assert gap.min() > 0.3 * SPACING
        surface = state["position"][state["phase"] == Phase.SOLID, 0].max()
        assert np.all(drop[:, 0] > surface + 0.3 * SPACING)


def test_water_leaves_with_the_strand(device):
    """Below the lower end nothing would hold it, and it would fly in under the steel."""
    simulation = sprayed(device, velocity=(0.0, -0.1, 0.0), drops=[[FACE + 0.8 * SPACING, 0.05, 0.0]], end=0.02)
    simulation.run(0.2, 0.1)
    assert np.sum(simulation.snapshot()["role"] == Role.SPRAY) == 1
    simulation.run(0.2, 0.1)
    assert np.sum(simulation.snapshot()["role"] == Role.SPRAY) == 0
