"""Density by the equation of continuity on a lattice that expands."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import ContinuityDensity, Fluid


@pytest.mark.parametrize("dimension", [2, 3])
def test_expansion(dimension, device):
    """Otherwise the density would not follow the volume, or a free surface would lower it."""
    rate, dt, cells = 3.0, 1e-3, 21 if dimension == 2 else 13
    terms = (Fluid(1000.0, 1.0), ContinuityDensity())
    model = Model(dimension, 0.01, (fluid_material("liquid", 1000.0),), terms, gravity=(0.0, 0.0, 0.0))
    x = lattice((-0.005 * cells,) * dimension, (0.005 * cells,) * dimension, 0.01)
    particles = Particles()
    particles.add(x, Role.FREE, velocity=rate * x)
    simulation = Simulation(Executor(device, 1), model, particles)
    simulation.run(dt, dt)
    state = simulation.snapshot()
    inside = np.abs(x[:, :dimension]).max(axis=1) < 0.005 * cells - 0.03
    change = state["density"].astype(float) - 1000.0
    np.testing.assert_allclose(change[inside], -dimension * rate * dt * 1000.0, rtol=1e-3)
    assert np.all(change[~inside] > -dimension * rate * dt * 1000.0 * 1.1)
    assert state["pressure"].max() == 0.0
