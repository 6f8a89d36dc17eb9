"""The neighbour list against all pairs, while particles drift and the list is renewed on the way."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.kernels.neighbours.pairs import NeighbourList
from warpsph.run.simulation import Simulation

SPACING = 0.01
SPEED = 0.01  # standard deviation of the velocities on each axis


def places(arrangement: str, dimension: int, centre: float, count: int, random: np.random.Generator) -> np.ndarray:
    """About ``count`` places (n, 3) [m] in a square or a cube; coincident: every tenth one is that of another."""
    cells = max(round(count ** (1.0 / dimension)), 1)
    low, high = centre - 0.5 * cells * SPACING, centre + 0.5 * cells * SPACING
    x = lattice((low,) * dimension, (high,) * dimension, SPACING)
    if arrangement == "random":
        x[:, :dimension] = random.uniform(low, high, (len(x), dimension))
    if arrangement == "coincident":
        doubled = x[1::10]
        doubled[:] = x[:-1:10][: len(doubled)]
    return x


def compared_on_the_way(
    device: str, arrangement: str, dimension: int, centre: float, count: int
) -> dict[str, np.ndarray]:
    """Time series of the comparison of the list with all pairs, of particles that drift for 0.3 s."""
    random = np.random.default_rng(1)
    x = places(arrangement, dimension, centre, count, random)
    velocity = SPEED * random.standard_normal(x.shape)
    velocity[:, dimension:] = 0.0
    particles = Particles()
    particles.add(x, Role.FREE, velocity=velocity)
    model = Model(dimension, SPACING, (fluid_material("marker", 1000.0),), gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(
        Executor(device), model, particles, dt=0.01, observe=lambda state, time: comparison(simulation)
    )
    return simulation.run(0.3, 0.05).diagnostics


def comparison(simulation: Simulation) -> dict[str, float]:
    """Count pairs inside the support that the list misses, and entries that are not as brute force finds them.

    A list holds the pairs that were closer than its radius when it was made; it must hold each of them once, and until
    it is renewed, every pair inside the support.
    """
    state, neighbours = simulation.state, simulation.solver.neighbours
    neighbours.renew_if_outdated()
    listed = as_matrix(state.neighbours)
    oneself = np.eye(len(listed), dtype=bool)
    reference = state.numpy("reference")
    now, then = distances(state.numpy("position")), distances(reference)
    rounding = 4.0 * np.spacing(np.abs(reference).max())
    needed = (now < simulation.model.support - rounding) & ~oneself
    surely_in = (then < neighbours.radius - rounding) & ~oneself
    surely_out = (then > neighbours.radius + rounding) | oneself
    return {
        "pairs": float(np.sum(needed)),
        "missing": float(np.sum((needed | surely_in) & (listed == 0))),
        "wrong": float(np.sum(listed > 1) + np.sum(surely_out & (listed > 0))),
        "renewals": float(state.numpy("renewals")[0]),
    }


def as_matrix(rows: NeighbourList) -> np.ndarray:
    """How often each particle (row) lists each other one (column)."""
    count = rows.count.numpy()
    i = np.repeat(np.arange(len(count)), count)
    k = np.concatenate([np.arange(m) for m in count])
    listed = np.zeros((len(count),) * 2, int)
    np.add.at(listed, (i, rows.entry.numpy()[i * rows.row_stride + k * rows.entry_stride]), 1)
    return listed


def distances(x: np.ndarray) -> np.ndarray:
    x = x.astype(float)
    return np.sqrt(sum((x[:, None, axis] - x[None, :, axis]) ** 2 for axis in range(3)))


@pytest.mark.parametrize("centre", [-3.0, 0.0, 50.0])
@pytest.mark.parametrize("arrangement", ["random", "lattice", "coincident"])
@pytest.mark.parametrize("dimension", [2, 3])
def test_list_equals_brute_force(dimension, arrangement, centre, device):
    """Otherwise forces between some neighbours would be missing or counted twice."""
    series = compared_on_the_way(device, arrangement, dimension, centre, count=700)
    assert len(series["time"]) == 7
    assert series["missing"].sum() == 0.0
    assert series["wrong"].sum() == 0.0
    assert series["pairs"].min() > 1000
    assert series["renewals"][-1] > 2


def test_two_particles_alone(device):
    """Otherwise a list of next to nothing would fail."""
    series = compared_on_the_way(device, "random", 2, -3.0, count=2)
    assert series["missing"].sum() == 0.0
    assert series["wrong"].sum() == 0.0
