"""Rows of particles so thin that their bonds hardly span the space: no stiffer than the time step bears."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material, thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, PhaseChange, SummedDensity

SPACING, STEEL = 0.01, thesis_steel()
WAVE_SPEED = Elasticity(4e5, 0.3).wave_speed(STEEL.density)  # [m/s]


def frozen_on_a_row(
    device: str, dimension: int, width: float, squeeze: float, guest: tuple[float, float]
) -> Simulation:
    """A zigzag row along y, its ``width`` in spacings squeezed by a factor, to which a ``guest`` beside it freezes."""
    k = np.arange(-4, 5)
    x = np.stack([width * (k % 2 - 0.5), k, width * (k // 2 % 2 - 0.5) * (dimension - 2)], axis=1) * SPACING
    particles = Particles()
    particles.add(x, Role.FREE, temperature=STEEL.solidus - 100.0)
    particles.add(np.array([[*guest, 0.0]]) * SPACING, Role.FREE, temperature=STEEL.liquidus + 100.0)
    terms = (Fluid(STEEL.density, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
    model = Model(dimension, SPACING, (STEEL,), terms, gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor(device), model, particles)
    simulation.prepare()
    state = simulation.state
    in_row = (state.numpy("phase") == Phase.SOLID)[:, None] & np.array([True, False, True])
    state.position.assign(np.where(in_row, squeeze, 1.0).astype(np.float32) * state.numpy("position"))
    state.solid_fraction.fill_(1.0)
    simulation.solver.act("change_phases")
    assert np.all(state.numpy("phase") == Phase.SOLID)
    return simulation


@pytest.mark.parametrize(
    ("dimension", "width", "squeeze", "guest"),
    [
        (2, 0.5, 0.2, (1.2, 1.85)),
        (2, 0.6, 0.5, (1.2, 1.85)),
        (2, 0.4, 0.95, (1.2, 0.3)),
        (2, 0.8, 0.2, (1.2, 1.85)),
        (2, 1.0, 0.5, (1.2, 0.3)),
        (2, 1.0, 0.5, (1.2, 1.85)),
        (2, 1.1, 0.4, (0.9, 0.5)),
        (2, 1.4, -1.0, (1.2, 1.85)),
        (3, 0.6, 1.0, (1.2, 0.3)),
        (3, 0.7, 0.2, (1.2, 0.3)),
        (3, 0.8, 0.5, (1.2, 1.85)),
    ],
)
def test_what_freezes_on_a_thin_row_does_not_tear_it_apart(device, dimension, width, squeeze, guest):
    """A squeezed row whose bonds span the space only with the new one would be so stiff that a step throws it away."""
    simulation = frozen_on_a_row(device, dimension, width, squeeze, guest)
    solver, step = simulation.solver, simulation.plan.longest
    solver.set_steps(step, step)
    for _ in range(100):
        solver.step()
    speed = np.linalg.norm(simulation.state.numpy("velocity"), axis=1).max()
    assert speed < 1e-3 + (1.0 - squeeze) * WAVE_SPEED  # what a strain sets free


@pytest.mark.parametrize("dimension", [2, 3])
def test_what_freezes_at_a_surface_is_no_larger_than_its_cell(device, dimension):
    """A row, that has next to no neighbours, would be several times as large and as stiff as its matter is."""
    state = frozen_on_a_row(device, dimension, 0.0, 1.0, (1.2, 0.3)).state
    cell = state.numpy("mass") / STEEL.density
    assert np.all(state.numpy("density") < 0.7 * STEEL.density)
    assert np.allclose(state.numpy("body_volume"), cell, rtol=1e-6)


@pytest.mark.parametrize("support", [1.2, 1.5, 2.6])
@pytest.mark.parametrize("dimension", [2, 3])
def test_every_particle_of_a_lattice_is_corrected(device, dimension, support):
    """The corners, that have the fewest bonds, would feel it when a body turns."""
    particles = Particles()
    particles.add(lattice((0.0,) * dimension, (5 * SPACING,) * dimension, SPACING), Role.FREE, phase=Phase.SOLID)
    elasticity = Elasticity(1e6, 0.3, support_ratio=support)
    model = Model(dimension, SPACING, (solid_material("rubber", 1000.0),), (elasticity,), gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor(device), model, particles)
    simulation.prepare()
    state, bonds = simulation.state, simulation.state.bonds
    weight = (-bonds.slope.numpy() * SPACING**dimension).reshape(-1, bonds.capacity)
    weight[np.arange(bonds.capacity) >= bonds.count.numpy()[:, None]] = 0.0
    X = bonds.separation.numpy().reshape(-1, bonds.capacity, 3)
    moment = np.einsum("nb,nba,nbc->nac", weight, X, X)[:, :dimension, :dimension]
    correction = state.numpy("correction")[:, :dimension, :dimension]
    assert np.allclose(correction @ moment, np.eye(dimension), atol=1e-5)
