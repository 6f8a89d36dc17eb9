"""Surface tension, ours and the published form, on lattices whose curvature is known."""

import numpy as np
import pytest
import warp as wp
from scipy.spatial import cKDTree

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.launch import Launch
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError
from warpsph.kernels.flow.colour_field_tension import add_colour_field_tension
from warpsph.kernels.flow.surface_tension import add_surface_tension, find_surface_normal
from warpsph.kernels.neighbours.pairs import NeighbourList
from warpsph.run.simulation import Simulation
from warpsph.terms import ColourFieldTension, CorrectedFluid, Fluid, SurfaceTension

SPACING = 0.01
TENSION = 1.7
DENSITY = 7000.0


def neighbour_list(x: np.ndarray, support: float, device: str) -> NeighbourList:
    rows = [[j for j in row if j != i] for i, row in enumerate(cKDTree(x).query_ball_point(x, 1.1 * support))]
    capacity = max(map(len, rows))
    neighbours = NeighbourList()
    neighbours.count = wp.array([len(row) for row in rows], dtype=int, device=device)
    neighbours.entry = wp.array(
        [j for row in rows for j in row + [0] * (capacity - len(row))], dtype=int, device=device
    )
    neighbours.capacity, neighbours.row_stride, neighbours.entry_stride = capacity, capacity, 1
    return neighbours


def launch_of(
    term: Term, x: np.ndarray, dimension: int, support_ratio: float, device: str, role=None, phase=None
) -> Launch:
    """Launches kernels of a term over liquid particles, free unless said otherwise, at rest at ``x`` (n, 3) [m]."""
    executor, n = Executor(device, 1), len(x)
    model = Model(dimension, SPACING, (fluid_material("liquid", DENSITY),), (Fluid(DENSITY, 10.0), term), support_ratio)
    roles = np.full(n, Role.FREE) if role is None else role
    phases = np.full(n, Phase.LIQUID) if phase is None else phase
    arrays = {
        "neighbours": neighbour_list(x, model.support, device),
        "position": wp.array(x, dtype=wp.vec3, device=device),
        "fluid_mass": wp.full(n, DENSITY * SPACING**dimension, dtype=float, device=device),
        "density": wp.full(n, DENSITY, dtype=float, device=device),
        "volume": wp.full(n, SPACING**dimension, dtype=float, device=device),
        "role": wp.array(roles, dtype=int, device=device),
        "phase": wp.array(phases, dtype=int, device=device),
        "surface_normal": wp.zeros(n, dtype=wp.vec3, device=device),
        "acceleration": wp.zeros(n, dtype=wp.vec3, device=device),
    }
    return Launch(executor, n, term.constants(model, State(n, executor.device)), arrays)


def force_of(x: np.ndarray, dimension: int, device: str, role=None, phase=None) -> np.ndarray:
    """Force (n, 3) [N] on each particle of a lattice (per metre of depth in 2D)."""
    launch = launch_of(SurfaceTension(TENSION), x, dimension, 3.0, device, role, phase)
    launch(find_surface_normal)
    launch(add_surface_tension)
    return DENSITY * SPACING**dimension * launch.find("acceleration").numpy().astype(float)


def published_acceleration_of(
    x: np.ndarray, dimension: int, device: str, role=None, support_ratio: float = 2.6
) -> np.ndarray:
    """Acceleration (n, 3) [m/s^2] by Vijaykumar (2.10)."""
    launch = launch_of(ColourFieldTension(TENSION, threshold=0.2), x, dimension, support_ratio, device, role)
    launch(add_colour_field_tension)
    return launch.find("acceleration").numpy().astype(float)


def lattice(dimension: int, cells: int) -> np.ndarray:
    ticks = (np.arange(cells) - (cells - 1) / 2) * SPACING
    axes = [ticks] * dimension + [np.zeros(1)] * (3 - dimension)
    return np.stack([a.ravel() for a in np.meshgrid(*axes)], axis=1)


def rings(count: int) -> np.ndarray:
    """A disc of concentric rings, for a lattice has steps where a disc has none."""
    points = []
    for k in range(count):
        radius = (k + 0.5) * SPACING
        n = round(2.0 * np.pi * radius / SPACING)
        angle = 2.0 * np.pi * (np.arange(n) + 0.5 * (k % 2)) / n
        points.append(radius * np.stack([np.cos(angle), np.sin(angle), np.zeros(n)], axis=1))
    return np.concatenate(points)


def ball(rows: int) -> np.ndarray:
    x = lattice(3, 2 * rows + 2)
    return x[np.linalg.norm(x, axis=1) < rows * SPACING]


@pytest.mark.parametrize(
    ("x", "dimension", "rows", "tolerance"),
    [(rings(10), 2, 10, 0.06), (rings(20), 2, 20, 0.04), (ball(10), 3, 10, 0.1)],
)
def test_round_drop(x, dimension, rows, tolerance, device):
    """Otherwise the pressure in a drop would not be (d - 1) sigma / R, or a drop would push itself along.

    The ball is cut from a lattice, so its surface has steps.
    """
    force, radius = force_of(x, dimension, device), rows * SPACING
    distance = np.linalg.norm(x, axis=1)
    inward = -np.sum(force * x, axis=1) / distance
    area = 2.0 * np.pi * distance if dimension == 2 else 4.0 * np.pi * distance**2
    assert np.sum(inward / area) == pytest.approx((dimension - 1) * TENSION / radius, rel=tolerance)
    assert np.linalg.norm(force.sum(axis=0)) < 1e-3 * np.linalg.norm(force, axis=1).sum()


@pytest.mark.parametrize("dimension", [2, 3])
def test_flat_surface(dimension, device):
    """Otherwise a pool at rest would be pressed by the tension of its level surface, and a drop by its inside."""
    x = lattice(dimension, 25 if dimension == 2 else 17)
    force = force_of(x, dimension, device)
    edge = np.sort(np.abs(x[:, :dimension]), axis=1)
    depth, to_corner = edge[0, -1] - edge[:, -1], edge[0, -1] - edge[:, -2]
    scale = np.linalg.norm(force, axis=1).max()
    assert np.abs(force[(depth > 3.5 * SPACING)]).max() == 0.0
    assert np.abs(force[to_corner > 7.0 * SPACING]).max() < 1e-5 * scale
    assert np.all(np.sum(force * x, axis=1)[to_corner < 0.5 * SPACING] < 0.0)


def test_hollow_is_drawn_out(device):
    """Otherwise curvature would have lost its sign: a bubble must be drawn shut and a notch filled."""
    x = lattice(2, 41)
    x = x[np.linalg.norm(x, axis=1) > 8 * SPACING]
    beside = np.linalg.norm(x, axis=1) < 10 * SPACING
    force = force_of(x, 2, device)
    assert np.sum(force * x, axis=1)[beside].sum() < 0.0


@pytest.mark.parametrize("other", ["wall", "shell"])
def test_no_surface_at_a_wall(other, device):
    """Otherwise the melt would be drawn off its mould or its shell by a surface that is not there."""
    x = lattice(2, 21)
    below = x[:, 1] < 0.0
    role = np.where(below & (other == "wall"), int(Role.WALL), int(Role.FREE))
    phase = np.where(below & (other == "shell"), int(Phase.SOLID), int(Phase.LIQUID))
    beside = (np.abs(x[:, 1]) < SPACING) & (np.abs(x[:, 0]) < 5 * SPACING) & ~below
    force = force_of(x, 2, device, role, phase)
    assert np.all(force[beside] == 0.0)
    assert np.all(force[below] == 0.0)


@pytest.mark.parametrize("dimension", [2, 3])
def test_published_form_on_a_square_drop(dimension, device):
    """Otherwise a drop would tear itself apart, push itself along, or feel a surface in its middle."""
    x = lattice(dimension, 21 if dimension == 2 else 13)
    a = published_acceleration_of(x, dimension, device)
    depth = np.abs(x[:, :dimension]).max(axis=1).max() - np.abs(x[:, :dimension]).max(axis=1)
    assert np.all(a[depth > 2 * SPACING] == 0.0)
    assert np.all(np.sum(a * x, axis=1)[depth < 0.5 * SPACING] < 0.0)
    assert np.linalg.norm(a.sum(axis=0)) < 1e-4 * np.linalg.norm(a, axis=1).sum()


def test_published_form_pulls_on_a_flat_surface(device):
    """Otherwise the coefficient would not be sigma: the pull adds up to sigma times the steepness of the colour field.

    Through a flat surface at x = 0 the colour field has the slope c'(0) = integral of W along the surface, and the sum
    of -sigma c'' over the fluid is sigma c'(0). It does not vanish with the curvature (docs/errata.md).
    """
    support = 6.0 * SPACING
    x = lattice(2, 61)
    a = published_acceleration_of(x, 2, device, support_ratio=6.0)
    column = (np.abs(x[:, 0]) < 0.5 * SPACING) & (x[:, 1] > 0.0)
    pull = -a[column, 1].sum() * DENSITY * SPACING
    slope = 4.0 / (np.pi * support**8) * 32.0 / 35.0 * support**7
    assert pull == pytest.approx(TENSION * slope, rel=0.05)


def test_published_form_sees_no_surface_at_a_wall(device):
    """Otherwise the melt would be drawn off the mould by a surface that is not there."""
    x = lattice(2, 21)
    wall = x[:, 1] < 0.0
    beside_wall = (np.abs(x[:, 1] - 0.0) < SPACING) & (np.abs(x[:, 0]) < 5 * SPACING) & ~wall
    a = published_acceleration_of(x, 2, device, role=np.where(wall, 1, 0))
    assert np.all(a[beside_wall] == 0.0)
    assert np.all(a[wall] == 0.0)


def test_another_density_is_refused():
    """The force on a light fluid would be less than that on a heavy one, and together they would begin to travel."""
    fluids = (fluid_material("heavy", 1000.0), fluid_material("light", 100.0))
    particles = Particles()
    for height, fluid in enumerate(fluids):
        particles.add(np.array([[0.05, 0.1 * height, 0.0], [0.15, 0.1 * height, 0.0]]), Role.FREE, fluid.name)
    flow = CorrectedFluid(1000.0, 20.0, free_surface=True)
    with pytest.raises(InputError, match=r"light of 100 kg/m\^3 flows"):
        Simulation(Executor("cpu"), Model(2, 0.1, fluids, (flow, SurfaceTension(1.0))), particles)
    Simulation(Executor("cpu"), Model(2, 0.1, fluids, (flow, ColourFieldTension(1.0))), particles)
