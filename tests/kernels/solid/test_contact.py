"""Contact of bodies: momentum, energy, and silence within a body."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Contact, Elasticity
from warpsph.terms.contact import contact_constants

DX = 0.01
E = 1.0e6


def two_blocks(device: str, bodies: tuple[int, int] = (0, 1)) -> Simulation:
    """Two blocks, bonded far apart from each other."""
    particles = Particles()
    for body, left in zip(bodies, (0.0, 1.0), strict=True):
        block = lattice((left, 0.0), (left + 4 * DX, 4 * DX), DX)
        particles.add(block, Role.FREE, phase=Phase.SOLID, body=body)
    model = Model(2, DX, (solid_material("rubber", 1000.0),), (Elasticity(E, 0.3), Contact()), support_ratio=1.7)
    simulation = Simulation(Executor(device), model, particles)
    simulation.prepare()
    return simulation


def force(simulation: Simulation, x: np.ndarray) -> np.ndarray:
    """Contact forces (n, 3) in the order of the ids, for positions in that order."""
    state, solver = simulation.state, simulation.solver
    state.position.assign(x[state.numpy("id")].astype(np.float32))
    state.outdated.fill_(1)
    solver.neighbours.renew_if_outdated()
    state.acceleration.zero_()
    ((contact, launch),) = [act for act in solver._acts["add_forces"] if isinstance(act[0], Contact)]
    contact.add_forces(launch)
    order = np.argsort(state.numpy("id"))
    return (state.numpy("acceleration").astype(float) * state.numpy("mass")[:, None])[order]


def moved_together(simulation: Simulation, gap: float) -> np.ndarray:
    x = simulation.state.numpy("position")[np.argsort(simulation.state.numpy("id"))].astype(float)
    x[16:] += [gap + 3.0 * DX - 1.0, 0.3 * DX, 0.0]
    return x


def test_contact_pushes_apart_and_keeps_momentum(device):
    """Contact that does not cancel would move both bodies by itself; contact that pulls would make them stick."""
    simulation = two_blocks(device)
    f = force(simulation, moved_together(simulation, 1.2 * DX))
    assert f[:16, 0].sum() < 0.0 < f[16:, 0].sum()
    assert np.max(np.abs(f.sum(axis=0))) < 1e-5 * np.abs(f).sum()


def test_contact_has_an_energy(device):
    """The work of pressing two bodies together must come back when they part."""
    simulation = two_blocks(device)
    contact = contact_constants(simulation.model)

    def energy(x: np.ndarray) -> float:
        r = np.linalg.norm(x[:16, None] - x[None, 16:], axis=2)
        return contact.strength * contact.reach / 5.0 * np.sum(np.maximum(1.0 - r / contact.reach, 0.0) ** 5)

    x, step = moved_together(simulation, 1.1 * DX), 1e-4 * DX
    f = force(simulation, x)
    touching = np.argsort(-np.abs(f[:, 0]))[:4]
    for i in touching:
        for axis in range(2):
            shift = np.zeros_like(x)
            shift[i, axis] = step
            slope = (energy(x + shift) - energy(x - shift)) / (2.0 * step)
            assert f[i, axis] == pytest.approx(-slope, abs=1e-3 * np.abs(f).max())


def test_a_body_does_not_feel_itself(device):
    """A compressed body would otherwise be stiffer than its material."""
    simulation = two_blocks(device, (0, 0))
    assert np.all(force(simulation, moved_together(simulation, 0.8 * DX)) == 0.0)


def test_bodies_out_of_reach_do_not_touch(device):
    """Bodies must fly freely until they meet."""
    simulation = two_blocks(device)
    assert np.all(force(simulation, moved_together(simulation, 2.7 * DX)) == 0.0)
