"""The compressible column at rest."""

import numpy as np
import pytest

from warpsph.core.hydrostatics import column_pressure, row_heights


def test_the_thesis_column():
    """The figure of the thesis, 43.8 kPa, is only consistent with this column (c_s = 22.4 m/s)."""
    assert column_pressure(2.05, 2100.0, 9.81, 22.4) == pytest.approx(43_027.0, rel=1e-4)


def test_rows_carry_the_weight_above_them():
    """Rows that start out of balance fall, and the fall takes seconds to die away."""
    rows, dx, g, c = 200, 0.01, 9.81, 22.4
    heights = row_heights(rows, dx, g, c)
    assert np.all(np.diff(heights) > 0.0)
    assert 0.0 < heights[0] < 0.5 * dx
    density = 2100.0 * dx / np.diff(heights)
    pressure = c**2 * 2100.0 / 7.0 * ((density / 2100.0) ** 7 - 1.0)
    weight = 2100.0 * dx * g * np.arange(rows - 1, 0, -1)
    assert np.allclose(pressure, weight, rtol=1e-3)


def test_an_incompressible_column_is_a_lattice():
    """At a high speed of sound the rows must fall on the regular grid."""
    assert np.allclose(row_heights(20, 0.1, 9.81, 1e4), (np.arange(20) + 0.5) * 0.1, atol=1e-5)
