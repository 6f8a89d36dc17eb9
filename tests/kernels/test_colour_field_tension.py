"""The published form of surface tension on drops whose force is known by symmetry."""

import numpy as np
import pytest
import warp as wp
from scipy.spatial import cKDTree

from warpsph.kernels.colour_field_tension import ColourField, add_colour_field_tension
from warpsph.kernels.pairs import NeighbourList
from warpsph.kernels.smoothing import normalisation

SPACING = 0.01
SUPPORT = 2.6 * SPACING
TENSION = 1.7
DENSITY = 7000.0


class Launcher:
    """The part of an executor that a launcher of kernels needs."""

    def __init__(self, device: str):
        self.device = device

    def __call__(self, kernel, dim, inputs):
        wp.launch(kernel, dim=dim, inputs=[0, *inputs], device=self.device)


def neighbour_list(x: np.ndarray, support: float, device: str) -> NeighbourList:
    rows = [[j for j in row if j != i] for i, row in enumerate(cKDTree(x).query_ball_point(x, 1.2 * support))]
    capacity = max(map(len, rows))
    neighbours = NeighbourList()
    neighbours.count = wp.array([len(row) for row in rows], dtype=int, device=device)
    neighbours.entry = wp.array(
        [j for row in rows for j in row + [0] * (capacity - len(row))], dtype=int, device=device
    )
    neighbours.capacity, neighbours.row_stride, neighbours.entry_stride = capacity, capacity, 1
    return neighbours


def acceleration_of(x: np.ndarray, dimension: int, device: str, role=None, support=SUPPORT) -> np.ndarray:
    field = ColourField()
    field.support, field.dimension, field.tension = support, dimension, TENSION
    field.scale = normalisation("poly6", dimension, support)
    field.threshold = 0.2 / support
    n = len(x)
    labels = np.zeros(n, dtype=np.int32)
    acceleration = wp.zeros(n, dtype=wp.vec3, device=device)
    add_colour_field_tension(
        Launcher(device),
        field,
        neighbour_list(x, support, device),
        wp.array(x, dtype=wp.vec3, device=device),
        wp.full(n, DENSITY, dtype=float, device=device),
        wp.full(n, SPACING**dimension, dtype=float, device=device),
        wp.array(labels if role is None else role, dtype=int, device=device),
        wp.array(labels, dtype=int, device=device),
        acceleration,
    )
    return acceleration.numpy().astype(float)


def lattice(dimension: int, cells: int) -> np.ndarray:
    ticks = (np.arange(cells) - (cells - 1) / 2) * SPACING
    axes = [ticks] * dimension + [np.zeros(1)] * (3 - dimension)
    return np.stack([a.ravel() for a in np.meshgrid(*axes)], axis=1)


@pytest.mark.parametrize("dimension", [2, 3])
def test_square_drop(dimension, device):
    """Otherwise a drop would tear itself apart, push itself along, or feel a surface in its middle."""
    x = lattice(dimension, 21 if dimension == 2 else 13)
    a = acceleration_of(x, dimension, device)
    depth = np.abs(x[:, :dimension]).max(axis=1).max() - np.abs(x[:, :dimension]).max(axis=1)
    assert np.all(a[depth > 2 * SPACING] == 0.0)
    assert np.all(np.sum(a * x, axis=1)[depth < 0.5 * SPACING] < 0.0)
    assert np.linalg.norm(a.sum(axis=0)) < 1e-4 * np.linalg.norm(a, axis=1).sum()


def test_pull_of_a_flat_surface(device):
    """Otherwise the coefficient would not be sigma: the pull adds up to sigma times the steepness of the colour field.

    Through a flat surface at x = 0 the colour field has the slope c'(0) = integral of W along the surface, and the sum
    of -sigma c'' over the fluid is sigma c'(0). It does not vanish with the curvature (docs/errata.md).
    """
    support = 6.0 * SPACING
    x = lattice(2, 61)
    a = acceleration_of(x, 2, device, support=support)
    column = (np.abs(x[:, 0]) < 0.5 * SPACING) & (x[:, 1] > 0.0)
    pull = -a[column, 1].sum() * DENSITY * SPACING
    slope = 4.0 / (np.pi * support**8) * 32.0 / 35.0 * support**7
    assert pull == pytest.approx(TENSION * slope, rel=0.05)


def test_no_surface_at_a_wall(device):
    """Otherwise the melt would be drawn off the mould by a surface that is not there."""
    x = lattice(2, 21)
    wall = x[:, 1] < 0.0
    beside_wall = (np.abs(x[:, 1] - 0.0) < SPACING) & (np.abs(x[:, 0]) < 5 * SPACING) & ~wall
    a = acceleration_of(x, 2, device, role=np.where(wall, 1, 0))
    assert np.all(a[beside_wall] == 0.0)
    assert np.all(a[wall] == 0.0)
