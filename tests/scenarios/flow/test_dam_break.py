"""The dam break, coarse, in the plane and in space."""

import numpy as np
import pytest

from warpsph.scenarios.flow.dam_break import DamBreak, published_front


@pytest.mark.parametrize(("dimension", "columns", "duration"), [(2, 18, 0.45), (3, 6, 0.1)])
def test_front(dimension, columns, duration, device):
    """Otherwise the liquid would fall or run at the wrong speed."""
    scenario = DamBreak(dimension=dimension, columns=columns, duration=duration)
    checks = scenario.checks(scenario.run(device=device))
    assert len(checks) >= 2
    assert all(check.passed for check in checks)


def test_heat_goes_from_liquid_to_wall(device):
    """Otherwise the cold wall would not warm, or heat would be lost or made."""
    scenario = DamBreak(columns=12, duration=0.5)
    result = scenario.run(device=device)
    check = scenario.checks(result)[-1]
    assert "heat" in check.quantity
    assert check.passed
    assert check.reference > 0.0
    T, liquid = result.fields["temperature"], result.made_of("liquid")
    assert T[liquid].min() < 1990.0
    assert T[liquid].max() <= 2000.5
    assert T[result.made_of("cold wall")].min() >= 1499.5


def test_nothing_leaves_the_tank(device):
    """Otherwise walls would leak."""
    scenario = DamBreak(columns=12, duration=0.6)
    result = scenario.run(device=device)
    x = result.positions[result.fields["role"] == 0] / scenario.width
    assert np.all((x[:, 0] > -0.05) & (x[:, 0] < 4.05) & (x[:, 1] > -0.05))


def test_published_front_is_whole():
    """Otherwise the reference data would not be the published points."""
    front = published_front()
    assert front[0] == (0.0, 1.0)
    assert len(front) == 9
    assert np.all(np.diff(front, axis=0) > 0.0)
