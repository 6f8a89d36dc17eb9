"""Ends and ticks of colour bars."""

import numpy as np
import pytest

from warpsph.pictures.scales import colour_range, ticks_around


def test_the_few_may_leave_the_colours_to_the_many():
    """If it failed, one wild value would hide all others, or a clipped end would not be marked."""
    values = np.concatenate([np.linspace(0, 1, 1000), [50.0]])
    low, high, extend = colour_range(values, whole=False)
    assert low == 0.0
    assert 0.9 < high < 1.1
    assert extend == "max"
    assert colour_range(values, whole=True) == (0.0, 50.0, "neither")


def test_ordinary_values_are_not_clipped():
    """If it failed, the ends of every smooth field would be cut off for nothing."""
    assert colour_range(np.linspace(-3, 7, 5000), whole=False) == (-3.0, 7.0, "neither")


@pytest.mark.parametrize("ends", [(1000.0, 1720.0, 1830.0), (1719.0, 1720.0, 1721.0), (300.0, 1720.3, 1722.0)])
def test_ticks_stand_on_both_sides_and_apart(ends):
    """If it failed, the temperature of freezing would be unlabelled, or labels would overlap."""
    low, middle, high = ends
    ticks = ticks_around(*ends)
    assert round(middle) in ticks
    assert ticks == sorted(ticks)
    assert ticks[0] >= low - 0.5
    assert ticks[-1] <= high + 0.5
    below = [tick for tick in ticks if tick < middle - 0.5]
    assert all(middle - tick > 0.1 * (middle - low) for tick in below)


def test_ticks_of_a_narrow_range_are_told_apart():
    """Temperatures of about 1 K, as in problems without dimensions, would all be labelled 0 or 1."""
    ticks = ticks_around(0.19, 0.91, 1.2)
    assert 0.91 in ticks
    assert len({f"{tick:g}" for tick in ticks}) == len(ticks) > 3
