"""A periodic box in pictures: it is seen whole, and its border is drawn."""

import numpy as np
import pytest

from warpsph.core.periodic import PeriodicBox
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile
from warpsph.pictures.drawing import Drawing
from warpsph.pictures.periodic_outline import outline
from warpsph.pictures.view import View, make_view


@pytest.fixture
def result_of(tmp_path):
    """A result with a block of particles from 0 to 1 m in a box."""

    def result(dimension: int, box: PeriodicBox | None) -> ResultFile:
        path = tmp_path / "run.vtkhdf"
        edges = (11, 11, 11 if dimension == 3 else 1)
        points = 0.1 * np.stack([axis.ravel() for axis in np.indices(edges)], axis=1)
        facts = {"dimension": dimension, "spacing": 0.1} | (box.facts() if box else {})
        with ResultWriter(path, {}, facts, overwrite=True) as writer:
            zeros = np.zeros(len(points), "i4")
            writer.write_frame(0.0, points, {"role": zeros, "phase": zeros, "material": zeros})
        return ResultFile(path)

    return result


def view_of(result: ResultFile) -> View:
    return make_view(result, [result.frame(0)])


def test_the_file_tells_the_box(result_of):
    """Whoever reads the file could not tell which particles are neighbours."""
    box = PeriodicBox((0.3, -1.0, 0.0), (0.7, 0.0, 0.1))
    assert PeriodicBox.of_facts(result_of(3, box).provenance) == box
    assert PeriodicBox.of_facts(result_of(3, None).provenance) is None


def test_the_box_is_seen_whole(result_of):
    """A box that is half empty would look full, and its border would be out of sight."""
    view = view_of(result_of(2, PeriodicBox((-0.5, -2.0, 0.0), (3.0, 0.0, 0.0))))
    np.testing.assert_allclose((view.left, view.right, view.bottom, view.top), (-0.6, 2.6, -0.1, 1.1), atol=1e-6)
    camera = view_of(result_of(3, PeriodicBox((-0.5, 0.0, 0.0), (3.0, 0.0, 0.0)))).camera
    assert camera is not None
    np.testing.assert_allclose((camera.low, camera.high), ((-0.5, 0.0, 0.0), (2.5, 1.0, 1.0)), atol=1e-6)


def test_the_border_is_drawn_where_the_box_is_periodic(result_of):
    """A line along an axis that is not periodic would be a wall that is not there."""
    lines = outline(view_of(result_of(2, PeriodicBox((-0.05, 0.0, 0.0), (1.1, 0.0, 0.0)))))
    np.testing.assert_allclose(np.sort(lines[:, 0, 0]), (-0.05, 1.05), atol=1e-6)
    assert np.all(np.ptp(lines, axis=1)[:, 0] == 0.0)
    assert len(outline(view_of(result_of(2, PeriodicBox((-0.05, -0.05, 0.0), (1.1, 1.1, 0.0)))))) == 4
    assert len(outline(view_of(result_of(3, PeriodicBox((-0.05,) * 3, (1.1,) * 3))))) == 9
    assert len(outline(view_of(result_of(3, None)))) == 0


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_picture_with_a_border_can_be_drawn(result_of, dimension):
    """A picture of a periodic case would fail, or look like one that is not."""

    def pixels(box: PeriodicBox | None) -> np.ndarray:
        drawing = Drawing(result_of(dimension, box), [0], "role", 1, 3.0, 60)
        drawing.draw(0, 0)
        return drawing.sheet.pixels()

    plain, periodic = pixels(None), pixels(PeriodicBox((0.0,) * 3, (1.0, 0.0, 0.0)))
    assert plain.shape == periodic.shape
    assert np.any(plain != periodic)
