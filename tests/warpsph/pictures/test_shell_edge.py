"""The line at the edge of the shell."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from warpsph.core.labels import Phase, Role
from warpsph.pictures.shell_edge import draw_edge, solid_share
from warpsph.pictures.view import View

VIEW = View(-0.1, 1.1, -0.1, 1.1, 0.02)


def half_frozen(edge):
    """A square of 1 m that has frozen where x > edge, and a wall at its right."""
    places = (np.arange(50) + 0.5) * 0.02
    points = np.stack([*(axis.ravel() for axis in np.meshgrid(places, places)), np.zeros(2500)], axis=1)
    fields = {
        "role": np.where(points[:, 0] > 0.9, Role.WALL, Role.FREE),
        "phase": np.where(points[:, 0] > edge, Phase.SOLID, Phase.LIQUID),
    }
    return points, fields


def test_the_line_is_where_the_phase_changes():
    """If it failed, the picture would show a shell that is thicker or thinner than it is."""
    line = draw_edge(Figure().add_subplot(), *half_frozen(0.6), VIEW)[0]
    x, y = line.allsegs[0][0].T
    inside = (y > 0.1) & (y < 0.9)
    np.testing.assert_allclose(x[inside], 0.6, atol=0.005)
    assert len(line.allsegs[0]) == 1


@pytest.mark.parametrize("edge", [-1.0, 2.0])
def test_no_line_where_all_is_one_phase(edge):
    """If it failed, a strand without shell would be drawn with an edge, or not at all."""
    assert draw_edge(Figure().add_subplot(), *half_frozen(edge), VIEW) == []


def test_nothing_is_said_of_where_nothing_is():
    """If it failed, a line would run along the free surface, or through the wall."""
    x, y, share = solid_share(*half_frozen(0.6), VIEW)
    assert np.all(np.isnan(share[:, x > 0.96]))
    assert np.all(np.isnan(share[:, x < -0.05]))
    assert share.shape == (len(y), len(x))
