"""Point sources and sinks: all their heat arrives, around them, and is counted."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, HeatSources, PointSource

SPACING, SIZE = 0.01, 0.2
STUFF = solid_material("stuff", 1000.0, heat_capacity=1000.0, conductivity=10.0)
SMOOTHINGS = {"poly6": 2.6, "cubic_spline": 2.4}


def body(device: str, dimension: int, smoothing: str, *sources: PointSource) -> tuple[Simulation, HeatSources]:
    rng = np.random.default_rng(2)
    size = (SIZE,) * dimension if dimension == 2 else (0.5 * SIZE,) * 3
    x = lattice((0.0,) * dimension, size, SPACING)
    x[:, :dimension] += 0.2 * SPACING * rng.uniform(-1.0, 1.0, x[:, :dimension].shape)
    particles = Particles()
    particles.add(x, Role.FREE, temperature=300.0)
    conduction = Conduction(longest_interval=1e9, smoothing=smoothing, support_ratio=SMOOTHINGS[smoothing])
    term = HeatSources(sources)
    model = Model(dimension, SPACING, (STUFF,), (term, conduction), gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device), model, particles), term


def heat(simulation: Simulation) -> np.ndarray:
    s = simulation.state
    return s.numpy("mass").astype(float) * (s.numpy("enthalpy").astype(float) - s.numpy("enthalpy_carry"))


@pytest.mark.parametrize("smoothing", SMOOTHINGS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_what_sources_give_the_body_gains(device, dimension, smoothing):
    """A sink that took more or less than its strength would freeze too much or too little: Monaghan (2.12).

    One stands inside, one on a corner, where half and more of its surroundings are missing.
    """
    place = (0.05, 0.04, 0.0 if dimension == 2 else 0.05)
    inside, corner = PointSource(place, 4.0), PointSource((0.0, 0.0, 0.0), -10.0)
    simulation, term = body(device, dimension, smoothing, inside, corner)
    before = heat(simulation)
    simulation.run(20.0, 20.0)
    after = heat(simulation)
    assert after.sum() - before.sum() == pytest.approx(-6.0 * 20.0, rel=1e-4)
    assert term.heat_given.numpy() == pytest.approx([4.0 * 20.0, -10.0 * 20.0], rel=1e-6)
    order = np.argsort(simulation.state.numpy("id"))
    near = np.linalg.norm(simulation.state.numpy("position")[order], axis=1) < 1.5 * SPACING
    assert np.all(after[near] < before[near])


def test_heat_comes_in_where_the_source_is(device):
    """A source smeared wider than the smoothing kernel, or beside its place, would freeze another region."""
    simulation, _ = body(device, 2, "cubic_spline", PointSource((0.1, 0.12, 0.0), 1.0))
    simulation.prepare()
    simulation.solver.act("sum_heat")
    state = simulation.state
    rate, x = state.numpy("heat_rate"), state.numpy("position")
    assert rate.sum() == pytest.approx(1.0, rel=1e-5)
    assert rate @ x == pytest.approx([0.1, 0.12, 0.0], abs=0.1 * SPACING)
    assert np.all(rate[np.linalg.norm(x - [0.1, 0.12, 0.0], axis=1) > 2.4 * SPACING] == 0.0)


def test_strength_may_change_during_a_run(device):
    """Cooling that follows a programme needs it: the step is recorded once and replayed."""
    simulation, term = body(device, 2, "poly6", PointSource((0.1, 0.1, 0.0), 0.0))
    before = heat(simulation).sum()
    simulation.run(10.0, 10.0)
    assert heat(simulation).sum() == pytest.approx(before, rel=1e-7)
    term.strength.assign([-100.0])
    simulation.run(10.0, 10.0)
    assert heat(simulation).sum() - before == pytest.approx(-1000.0, rel=1e-3)


def test_a_source_without_particles_is_refused():
    """Its heat would go nowhere, and nobody would see why nothing freezes."""
    with pytest.raises(InputError, match=r"no particle within 0.024 m of the source at \(1, 0, 0\) m") as caught:
        body("cpu", 2, "cubic_spline", PointSource((1.0, 0.0, 0.0), 1.0))
    assert "\n" not in str(caught.value)
    with pytest.raises(InputError, match="a tuple of one PointSource or more"):
        HeatSources(())
