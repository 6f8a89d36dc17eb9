"""The sweeps of the corrected flow that leave out what lies across the plane."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.kernels.flow.corrected.forces import ADD_FLOW_FORCES
from warpsph.kernels.flow.corrected.gradients import FIND_GRADIENTS
from warpsph.run.simulation import Simulation
from warpsph.terms import corrected_fluid


@pytest.mark.parametrize("free_surface", [False, True])
def test_the_plane_is_space_with_zeros(free_surface, device, monkeypatch):
    """What is left out would be a term that acts in the plane as well, and every result in 2D would be wrong."""
    flat = _stirred_tank(free_surface, device)
    monkeypatch.setattr(corrected_fluid, "FIND_GRADIENTS", {2: FIND_GRADIENTS[3]})
    monkeypatch.setattr(corrected_fluid, "ADD_FLOW_FORCES", {2: ADD_FLOW_FORCES[3]})
    full = _stirred_tank(free_surface, device)
    assert np.abs(flat["shift_velocity"]).max() > 0.0
    for name in ("position", "velocity", "shift_velocity", "compression", "compression_slope"):
        scale = np.abs(full[name]).max()
        np.testing.assert_allclose(flat[name], full[name], rtol=0.0, atol=1e-4 * scale, err_msg=name)
    assert np.array_equal(flat["is_near"], full["is_near"])


def _stirred_tank(free_surface, device):
    """Fields after ten steps of a fluid that was stirred at random."""
    dx = 0.1
    materials = (fluid_material("fluid", 1.0, 0.01), solid_material("wall", 1.0, 0.01))
    model = Model(2, dx, materials, (corrected_fluid.CorrectedFluid(1.0, 10.0, free_surface),))
    random = np.random.default_rng(1)
    points = lattice((0.0, 0.0), (1.0, 0.8), dx)
    points[:, :2] += random.uniform(-0.1, 0.1, (len(points), 2)) * dx
    velocity = np.zeros_like(points)
    velocity[:, :2] = random.uniform(-0.5, 0.5, (len(points), 2))
    walls = tank((0.0, 0.0), (1.0, 1.2), dx)
    face = np.clip(walls, (0.0, 0.0, 0.0), (1.0, 10.0, 0.0))
    particles = Particles()
    particles.add(points, Role.FREE, "fluid", velocity=velocity)
    particles.add(walls, Role.DUMMY, "wall", to_surface=face - walls)
    simulation = Simulation(Executor(device), model, particles)
    simulation.run(10 * simulation.plan.longest, 10 * simulation.plan.longest)
    return simulation.snapshot()
