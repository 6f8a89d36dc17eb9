"""What part of the world a picture shows."""

import numpy as np
import pytest

from warpsph.core.labels import Role
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile
from warpsph.pictures.view import make_view


@pytest.fixture
def look_at(tmp_path):
    """The view of some points."""

    def view(points, **provenance):
        path = tmp_path / "run.vtkhdf"
        with ResultWriter(path, {}, provenance, overwrite=True) as writer:
            writer.write_frame(0.0, points, {"role": np.zeros(len(points), "i4")})
        result = ResultFile(path)
        return make_view(result, [result.frame(0)])

    return view


def box(shape, spacing=0.1):
    """A block of particles (n, 3)."""
    return spacing * np.stack([axis.ravel() for axis in np.indices(shape)], axis=1)


def test_tight_crop(look_at):
    """If it failed, the strand would be a stripe in an empty picture, or be cut off."""
    view = look_at(box((11, 41, 1)), spacing=0.1, dimension=2)
    np.testing.assert_allclose((view.left, view.right, view.bottom, view.top), (-0.1, 1.1, -0.1, 4.1), atol=1e-6)
    assert view.camera is None
    assert view.aspect == pytest.approx(1.2 / 4.2)


def test_a_lost_particle_does_not_shrink_the_rest(look_at):
    """If it failed, one drop far away would make everything else invisible."""
    points = np.concatenate([box((30, 30, 1)), [[500.0, -300.0, 0.0]]])
    view = look_at(points, spacing=0.1, dimension=2)
    assert view.right < 4.0
    assert view.bottom > -1.0


def test_perspective_holds_all_particles_and_keeps_y_up(look_at):
    """If it failed, a three-dimensional case would be cut off, upside down or mirrored."""
    points = box((10, 20, 5))
    view = look_at(points, spacing=0.1, dimension=3)
    seen = view.project(points)
    assert np.all((seen[:, 0] > view.left) & (seen[:, 0] < view.right))
    assert np.all((seen[:, 1] > view.bottom) & (seen[:, 1] < view.top))
    assert np.all(seen[:, 2] > 0)
    origin, x, y, z = view.project(np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]))
    assert y[1] > origin[1]
    assert x[0] > origin[0]
    assert z[2] < origin[2]


@pytest.mark.parametrize("stored", [{}, {"spacing": None}, {"spacing": float("nan")}, {"spacing": -1.0}])
def test_spacing_is_guessed_where_none_is_stored(look_at, stored):
    """If it failed, a file of another origin would be drawn with dots that nobody can see."""
    assert look_at(box((20, 30, 1)), **stored).spacing == pytest.approx(0.1, rel=0.1)


@pytest.mark.parametrize("points", [np.empty((0, 3)), np.ones((1, 3)), np.ones((5, 3))])
def test_degenerate_frames(look_at, points):
    """If it failed, a frame with no, one or coinciding particles would end in a traceback."""
    view = look_at(points)
    assert view.right > view.left
    assert view.top > view.bottom
    assert view.spacing > 0


def test_discs_have_the_area_of_a_particle(look_at):
    """If it failed, the picture would show more or less steel than there is."""
    view = look_at(box((5, 5, 1)), spacing=0.1, dimension=2)
    diameters = view.diameters(np.array([Role.FREE, Role.WALL]))
    np.testing.assert_allclose(np.pi / 4 * diameters**2, 0.01)


def test_no_dots_of_a_wall_lie_over_the_rest(look_at):
    """If it failed, the shell of a billet could not be seen for the dots of its mould."""
    inside = box((6, 6, 6))
    sheet, aside = box((1, 6, 6)), np.array([0.8, 0.0, 0.0])
    wall = np.concatenate([sheet + aside, sheet - aside])
    points = np.concatenate([inside, wall])
    role = np.repeat([Role.FREE, Role.WALL], [len(inside), len(wall)])
    view = look_at(points, spacing=0.1, dimension=3)
    drawn = view.uncovered(points, role)
    assert np.all(drawn[role == Role.FREE])
    assert 0 < np.sum(drawn[role == Role.WALL]) < len(wall)
    radius = 0.4 * 0.1 / view.project(points)[:, 2].max()
    seen = view.project(points)[:, :2]
    for dot in seen[drawn & (role == Role.WALL)]:
        assert np.min(np.linalg.norm(seen[role == Role.FREE] - dot, axis=1)) > radius


def test_all_dots_are_drawn_in_the_plane(look_at):
    """If it failed, walls in two dimensions would have holes where melt touches them."""
    points = box((5, 5, 1))
    view = look_at(points, spacing=0.1, dimension=2)
    assert np.all(view.uncovered(points, np.repeat([Role.FREE, Role.WALL], [13, 12])))


def test_the_view_holds_the_axes(look_at):
    """If it failed, the axes of a picture in space would run out of it."""
    points = box((6, 12, 4))[5:]
    view = look_at(points, spacing=0.1, dimension=3)
    low, high = view.camera.low, view.camera.high
    corners = view.project(np.array([[low[0], low[1], high[2]], [high[0], low[1], high[2]], [high[0], low[1], low[2]]]))
    assert np.all((corners[:, 0] > view.left) & (corners[:, 0] < view.right) & (corners[:, 1] > view.bottom))
