"""Freezing under pressure, and the pressure that a solid shows to the fluid."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, ContinuityDensity, Elasticity, Fluid, PhaseChange, SummedDensity

SPACING, STEEL = 0.01, thesis_steel()


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize(("place", "error"), [(0.0, 1e-3), (50.0, 5e-3)])
def test_freezing_is_no_blow(device, dimension, place, error):
    """What freezes would lose its pressure at once, and shake a shell that grows: 0.5 m/s in a casting mould.

    At 50 m the fluid's distances are rounded to 4e-4 of the spacing, those of the bonds are not.
    """
    squeezed = 0.99 * SPACING
    x = lattice((0.0,) * dimension, (10 * squeezed,) * dimension, squeezed)
    particles = Particles()
    particles.add(x + np.array([place, 0.0, 0.0]), Role.FREE, temperature=STEEL.liquidus + 100.0)
    terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
    simulation = Simulation(
        Executor(device), Model(dimension, SPACING, (STEEL,), terms, gravity=(0.0, 0.0, 0.0)), particles
    )
    simulation.prepare()
    fluid = simulation.state.numpy("acceleration")
    scale = np.abs(fluid).max()
    assert scale > 10.0
    centre = x.mean(axis=0)
    simulation.state.solid_fraction.assign((x[:, 0] > centre[0]).astype(np.float32))
    for moment in ("change_phases", "sum_forces", "add_forces"):
        simulation.state.acceleration.zero_() if moment == "sum_forces" else None
        simulation.solver.act(moment)
    solid = simulation.state.numpy("phase") == 2
    assert 0.4 < solid.mean() < 0.6
    assert simulation.state.bonds.count.numpy()[solid].min() > 2
    assert np.abs(simulation.state.numpy("acceleration") - fluid).max() < error * scale


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("density", [SummedDensity, ContinuityDensity])
def test_a_strained_solid_presses_on_the_fluid_as_before(device, dimension, density):
    """Bonded pairs do not press on each other; if they pressed on others the harder the closer they are, that pressure
    would do work out of nothing, and a thin shell would flutter at its mould."""
    x = lattice((0.0,) * dimension, (6 * SPACING,) * dimension, SPACING)
    particles = Particles()
    particles.add(x, Role.FREE, temperature=STEEL.solidus - 100.0, velocity=-x)
    terms = (Fluid(2100.0, 10.0), density(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
    simulation = Simulation(
        Executor(device), Model(dimension, SPACING, (STEEL,), terms, gravity=(0.0, 0.0, 0.0)), particles
    )
    simulation.prepare()
    state, solver = simulation.state, simulation.solver
    before = state.numpy("density")
    state.position.assign(0.97 * state.numpy("position"))
    solver.set_steps(0.01, 0.01)
    solver.act("find_density")
    assert np.allclose(state.numpy("density"), before, rtol=1e-5)
