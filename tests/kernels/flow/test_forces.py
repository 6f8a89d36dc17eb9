"""Density, pressure and viscosity on lattices where the answer is known."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.run.simulation import Simulation
from warpsph.terms import Fluid, SummedDensity

SPACING = 0.05
DENSITY = 2100.0


def block(device: str, dimension: int, jitter: float = 0.0, viscosity: float = 3.0) -> Simulation:
    edge = 21 if dimension == 2 else 15
    axis = (np.arange(edge) - edge // 2) * SPACING
    x = np.stack(np.meshgrid(axis, axis, axis if dimension == 3 else [0.0], indexing="ij"), -1).reshape(-1, 3)
    noise = np.random.default_rng(1).uniform(-jitter, jitter, x.shape) * SPACING
    noise[:, dimension:] = 0.0
    particles = Particles()
    particles.add(x + noise, Role.FREE)
    model = Model(
        dimension,
        SPACING,
        (fluid_material("fluid", DENSITY, viscosity),),
        (Fluid(DENSITY, 10.0, tension=True), SummedDensity()),
        gravity=(0.0, 0.0, 0.0),
    )
    simulation = Simulation(Executor(device), model, particles)
    simulation.prepare()
    return simulation


def inner(simulation: Simulation) -> np.ndarray:
    x = simulation.state.numpy("position")
    return np.max(np.abs(x), axis=1) < np.max(np.abs(x)) - 5.3 * SPACING


@pytest.mark.parametrize("dimension", [2, 3])
def test_lattice_has_the_reference_density(device, dimension):
    """Half a percent too much would be a pressure of 1 kPa at c_s = 10 m/s."""
    simulation = block(device, dimension)
    density = simulation.state.numpy("density")[inner(simulation)]
    assert np.allclose(density, DENSITY, rtol=2e-6)


@pytest.mark.parametrize("dimension", [2, 3])
def test_linear_pressure_gives_its_gradient(device, dimension):
    """A wrong factor here is a wrong hydrostatic pressure."""
    simulation = block(device, dimension)
    x = simulation.state.numpy("position")
    slope = np.array([3.0e3, -2.0e3, 0.0])
    simulation.state.pressure.assign((1.0e4 + x @ slope).astype(np.float32))
    simulation.solver.act("sum_forces")
    acceleration = simulation.state.numpy("acceleration")[inner(simulation)]
    assert np.allclose(acceleration, -slope / DENSITY, atol=1e-4 * np.max(slope) / DENSITY)


def test_tait_equation(device):
    """Pressure must be c_s^2 (rho - rho_0) for small compressions, and the seventh power beyond."""
    simulation = block(device, 2, jitter=0.2)
    ratio = simulation.state.numpy("density").astype(float) / DENSITY
    expected = 100.0 * DENSITY / 7.0 * (ratio**7 - 1.0)
    assert np.allclose(simulation.state.numpy("pressure"), expected, atol=2.0, rtol=1e-5)


@pytest.mark.parametrize("dimension", [2, 3])
def test_viscosity_of_a_parabolic_profile(device, dimension):
    """The published Laplacian would give half the viscosity in 2D."""
    simulation = block(device, dimension)
    x = simulation.state.numpy("position")
    velocity = np.zeros_like(x)
    velocity[:, 0] = 0.5 * x[:, 1] ** 2
    simulation.state.velocity.assign(velocity)
    simulation.state.pressure.zero_()
    simulation.solver.act("sum_forces")
    acceleration = simulation.state.numpy("acceleration")[inner(simulation)]
    expected = 3.0 / DENSITY
    assert np.allclose(acceleration[:, 0], expected, rtol=1e-4)
    assert np.allclose(acceleration[:, 1:], 0.0, atol=1e-3 * expected)


@pytest.mark.parametrize("dimension", [2, 3])
def test_momentum_is_kept(device, dimension):
    """Pair forces that do not cancel would set a closed system in motion."""
    simulation = block(device, dimension, jitter=0.3)
    velocity = np.random.default_rng(2).normal(size=(simulation.state.count, 3))
    simulation.state.velocity.assign(velocity.astype(np.float32))
    simulation.solver.act("sum_forces")
    force = simulation.state.numpy("acceleration").astype(float) * simulation.state.numpy("mass")[:, None]
    assert np.max(np.abs(force.sum(axis=0))) < 1e-5 * np.sum(np.abs(force))
