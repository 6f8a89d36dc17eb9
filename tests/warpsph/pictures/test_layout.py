"""Where the panels of a series lie."""

from itertools import combinations

import pytest

from warpsph.pictures.layout import KEY, PAGE, arrange


@pytest.mark.parametrize("aspect", [0.2, 0.5, 1.0, 1.5, 4.0])
@pytest.mark.parametrize("panels", [1, 2, 3, 4, 5, 6, 9, 12])
def test_everything_is_on_the_page(aspect, panels):
    """If it failed, a series would be too wide to be read on a page, or panels would lie over each other."""
    layout = arrange(aspect, panels, 4.5, 3.0)
    width, height = layout.total
    assert width <= PAGE[0] + 1e-9
    assert height <= PAGE[1] + 1e-9
    assert len(layout.panels) == panels
    for left, bottom, across, up in layout.panels:
        assert across == pytest.approx(aspect * up)
        assert left > 0.0 < bottom
        assert left + across < width
        assert bottom + up < height
    for (left, bottom, across, up), (other_left, other_bottom, _, _) in combinations(layout.panels, 2):
        assert other_left > left + across or other_bottom + up < bottom or other_left + across < left


def test_the_key_takes_the_place_that_is_left_over():
    """If it failed, a sheet of five panels would have an empty corner and a stripe beside it."""
    layout = arrange(0.5, 5, 4.5, 3.0)
    assert (layout.rows, layout.columns) == (2, 3)
    left, top = layout.key
    assert left < layout.total[0] - KEY
    assert top < 0.5 * layout.total[1]
    assert left > layout.panels[4][0] + layout.panels[4][2]


def test_a_key_that_is_too_tall_stands_beside_the_panels():
    """If it failed, the key would run into the panel above it, or out of the picture."""
    layout = arrange(1.5, 3, 4.5, 6.0)
    assert layout.key[0] > max(left + width for left, _, width, _ in layout.panels)
    assert layout.room >= 4.5
