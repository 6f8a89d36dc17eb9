"""The two painters put the same discs at the same places."""

import numpy as np
import pytest

from warpsph.pictures import paint_matplotlib
from warpsph.pictures.graphics import graphics_available
from warpsph.pictures.view import GROUND, View

RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


@pytest.fixture(params=["vtk", "matplotlib"])
def paint(request):
    """Each painter in turn."""
    if request.param == "matplotlib":
        return paint_matplotlib.paint
    if not graphics_available():
        pytest.skip("VTK cannot draw here, so only the painter of matplotlib can be tested")
    from warpsph.pictures import paint_vtk

    return paint_vtk.paint


def test_discs_are_where_and_as_large_as_they_should_be(paint):
    """If it failed, particles would be drawn at wrong places or with wrong gaps between them."""
    view = View(left=0.0, right=2.0, bottom=-1.0, top=3.0, spacing=0.4)
    points = np.array([[0.5, 2.5, 0.0], [1.5, -0.5, 0.0]])
    image = paint(points, np.array([RED, BLUE]), np.full(2, 0.4), view, (200, 400)).astype(int)
    assert image.shape == (400, 200, 3)
    assert np.all(image[5, 195] == 255)
    for colour, (row, column) in ((0, (50, 50)), (2, (350, 150))):
        others = [c for c in range(3) if c != colour]
        assert image[row, column, colour] > 240
        assert np.all(image[row, column, others] < 10)
        rows, columns = np.nonzero(image[:, :, colour] - image[:, :, others].max(axis=2) > 60)
        assert rows.mean() == pytest.approx(row, abs=1)
        assert columns.mean() == pytest.approx(column, abs=1)
        # the disc has 40 pixels, the darker ground behind it some more
        assert 38 <= np.ptp(rows) + 1 <= 40 * GROUND + 2
        assert np.ptp(rows) == pytest.approx(np.ptp(columns), abs=2)


def test_the_nearer_particle_hides_the_farther(paint):
    """If it failed, sprays on the shell, or the front of a block, would be covered by what is behind."""
    view = View(left=-1.0, right=1.0, bottom=-1.0, top=1.0, spacing=0.5)
    for order in ([0, 1], [1, 0]):
        points = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.2]])[order]
        image = paint(points, np.array([RED, BLUE])[order], np.full(2, 0.5), view, (100, 100)).astype(int)
        assert image[50, 50, 2] > 200
        assert image[50, 50, 0] < 50


def test_perspective_agrees_with_the_view(paint, tmp_path):
    """If it failed, a three-dimensional picture would be cropped at a wrong place."""
    from warpsph.files.output import ResultWriter
    from warpsph.files.results import ResultFile
    from warpsph.pictures.view import make_view

    points = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]])
    with ResultWriter(tmp_path / "run.vtkhdf", {}, {"spacing": 0.1, "dimension": 3}) as writer:
        writer.write_frame(0.0, points, {"role": np.zeros(4, "i4")})
    result = ResultFile(tmp_path / "run.vtkhdf")
    view = make_view(result, [result.frame(0)])
    height = 400
    width = round(height * view.aspect)
    for point, (x, y, _) in zip(points, view.project(points), strict=True):
        image = paint(point[None], np.array([RED]), np.array([0.1]), view, (width, height)).astype(int)
        rows, columns = np.nonzero(image[:, :, 1] < 128)
        assert columns.mean() == pytest.approx((x - view.left) / (view.right - view.left) * width, abs=2)
        assert rows.mean() == pytest.approx((view.top - y) / (view.top - view.bottom) * height, abs=2)


def test_no_particles(paint):
    """If it failed, a frame without particles would end a movie."""
    view = View(left=0.0, right=1.0, bottom=0.0, top=1.0, spacing=0.1)
    image = paint(np.empty((0, 3)), np.empty((0, 3)), np.empty(0), view, (40, 30))
    assert image.shape == (30, 40, 3)
    assert np.all(image == 255)
