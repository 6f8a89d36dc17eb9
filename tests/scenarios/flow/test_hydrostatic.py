"""The column at rest, coarse."""

import numpy as np
import pytest

from warpsph.scenarios.flow.hydrostatic import Hydrostatic


def test_exact_column():
    """Otherwise the reference would not be the column of (1.3) and (1.5), or not that of the thesis."""
    column = Hydrostatic()
    y, step = np.linspace(0.1, 1.9, 10), 1e-4
    slope = (column.exact_pressure(y + step) - column.exact_pressure(y - step)) / (2.0 * step)
    np.testing.assert_allclose(slope, -9.81 * column.exact_density(y), rtol=1e-5)
    assert column.exact_pressure(0.0) == pytest.approx(43027.0, abs=1.0)
    assert column.exact_density(0.0) == pytest.approx(2176.8, abs=0.1)


def test_arrangement_carries_its_weight():
    """Otherwise the hydrostatic start would have rows where the pressure does not fit the weight above."""
    column = Hydrostatic(rows=50)
    edges = column.settled(np.arange(51) * column.spacing)
    weight = 9.81 * column.column_mass * (1.0 - np.arange(51) / 50)
    np.testing.assert_allclose(column.exact_pressure(edges), weight, atol=1e-6 * weight[0])
    assert edges[0] == pytest.approx(0.0, abs=1e-9)
    assert edges[-1] == pytest.approx(column.height)


@pytest.mark.parametrize("start", ["hydrostatic", "regular"])
def test_column_at_rest(start, device):
    """Otherwise the melt would stand too high, press too little on its mould, or never calm down."""
    scenario = Hydrostatic(rows=40, columns=20, start=start)
    result = scenario.run(device=device)
    last = {name: values[-1] for name, values in result.diagnostics.items()}
    assert last["bottom_pressure"] == pytest.approx(float(scenario.exact_pressure(0.0)), rel=0.03)
    assert last["profile_error"] < 0.03
    assert last["mean_speed"] < 2e-3 * np.sqrt(9.81 * scenario.height)
    assert last["level"] == pytest.approx(scenario.height, rel=0.02)
