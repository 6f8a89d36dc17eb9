"""The neighbour list against brute force."""

import numpy as np
import pytest

from warpsph.core.composition import compose
from warpsph.core.executor import Executor
from warpsph.core.initial import initial_state
from warpsph.core.labels import Role
from warpsph.core.launch import Launch
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.neighbours import Neighbours
from warpsph.core.particles import Particles
from warpsph.core.state import State

SPACING = 0.1
RADIUS = 0.26 + 0.03


def points(kind: str, dimension: int) -> np.ndarray:
    generator = np.random.default_rng(7)
    n = 300 if dimension == 2 else 500
    box = generator.uniform(0.0, 2.0 if dimension == 2 else 0.9, (n, 3))
    if kind == "lattice":
        edge = 17 if dimension == 2 else 8
        axes = np.meshgrid(*[np.arange(edge) * SPACING] * dimension, indexing="ij")
        box = np.zeros((edge**dimension, 3))
        box[:, :dimension] = np.stack(axes, -1).reshape(-1, dimension)
    if kind == "coincident":
        box[10:15] = box[10]
    if kind == "negative":
        box -= 1.0
    if kind == "outside the grid":
        box[::7] *= 30.0
    if dimension == 2:
        box[:, 2] = 0.0
    return box.astype(np.float32)


def renewed(executor: Executor, x: np.ndarray, role: Role | np.ndarray = Role.FREE) -> State:
    """The state of particles at ``x`` (n, 3) [m] that have just been sorted and listed."""
    particles = Particles()
    particles.add(x, role)
    dimension = 2 if np.all(x[:, 2] == 0.0) else 3
    model = compose(Model(dimension, SPACING, (fluid_material("fluid", 1000.0),)))
    state = initial_state(model, particles, executor.device)
    launch = Launch(executor, state.count, state.arrays, state.values, state.lists, state.scratch)
    lower, upper = np.percentile(x, 5, axis=0), np.percentile(x, 95, axis=0)
    Neighbours(launch, model, state, 0.26, 0.03, lower, upper).renew_if_outdated()
    return state


def pairs_of(state: State) -> set[tuple[int, int]]:
    rows = state.neighbours
    entry, count = rows.entry.numpy(), rows.count.numpy()
    return {
        (i, int(entry[i * rows.row_stride + k * rows.entry_stride])) for i in range(len(count)) for k in range(count[i])
    }


def brute_force(x: np.ndarray) -> set[tuple[int, int]]:
    d = x[:, None, :] - x[None, :, :]
    near = np.sum(d * d, axis=2) < np.float32(RADIUS) ** 2
    np.fill_diagonal(near, False)
    return set(zip(*(indices.tolist() for indices in np.nonzero(near)), strict=True))


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("kind", ["random", "lattice", "coincident", "negative", "outside the grid"])
def test_list_is_what_brute_force_finds(device, kind, dimension):
    """A missing or doubled pair would make forces one-sided and densities wrong."""
    state = renewed(Executor(device), points(kind, dimension))
    assert pairs_of(state) == brute_force(state.numpy("position"))
    assert state.longest_row.numpy()[0] == 0


def test_particles_keep_their_data_when_sorted(device):
    """Arrays that did not move together would exchange the properties of particles."""
    x = points("random", 2)
    state = renewed(Executor(device), x)
    assert np.array_equal(state.numpy("position"), x[state.numpy("id")])
    assert np.array_equal(np.sort(state.numpy("id")), np.arange(len(x)))


def test_reservoir_stands_last_and_has_no_neighbours(device):
    """A parked particle that still acts on others, or that the inlet cannot find, would break the mass ledger."""
    x = points("lattice", 2)
    role = np.where(np.arange(len(x)) % 5 == 0, Role.RESERVOIR, Role.FREE)
    state = renewed(Executor(device), x, role)
    start, end = state.reservoir_start.numpy()
    assert np.all(state.numpy("role")[start:end] == Role.RESERVOIR)
    assert np.all(state.numpy("role")[:start] == Role.FREE)
    assert end == len(x)
    assert all(i < start and j < start for i, j in pairs_of(state))


def test_a_row_that_overflows_is_reported(device):
    """A silently shortened list would lose forces without anyone knowing."""
    x = points("random", 2)
    x[:200] *= 0.05
    state = renewed(Executor(device), x)
    assert state.longest_row.numpy()[0] > state.neighbours.capacity


def test_the_plane_has_one_layer_of_cells(device):
    """If it failed, a box given as a cube would cost a thousand times the cells, and half a second a renewal."""
    x = points("lattice", 2)
    particles = Particles()
    particles.add(x, Role.FREE)
    model = compose(Model(2, SPACING, (fluid_material("fluid", 1000.0),)))
    executor = Executor(device)
    state = initial_state(model, particles, executor.device)
    launch = Launch(executor, state.count, state.arrays, state.values, state.lists, state.scratch)
    neighbours = Neighbours(launch, model, state, 0.26, 0.03, np.full(3, -30.0), np.full(3, 30.0))
    neighbours.renew_if_outdated()
    assert (neighbours.grid.nx, neighbours.grid.nz) == (207, 1)
    assert pairs_of(state) == brute_force(state.numpy("position"))
