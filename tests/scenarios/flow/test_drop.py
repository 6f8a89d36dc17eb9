"""Drops, coarse."""

import numpy as np
import pytest

from warpsph.scenarios.flow.drop import Drop
from warpsph.scenarios.flow.drop_shape import ellipse, shape_mode, swing_of


def test_modes_of_an_outline():
    """Otherwise amplitudes of the drop would be measured in another unit than the theory has."""
    x = ellipse(1.0, 0.05, 0.01)
    assert shape_mode(x, 1.0, 2) == pytest.approx(0.05, rel=0.05)
    assert shape_mode(x, 1.0, 4) == pytest.approx(2.0 * 0.05**2, rel=0.1)


def test_swing_is_found():
    """Otherwise the period would hold the damping too."""
    time = np.linspace(0.0, 5.0, 200)
    swing = swing_of(time, 0.1 * np.exp(-0.3 * time) * np.cos(2.4 * time) + 0.01, 2.5)
    assert swing.damping == pytest.approx(0.3, rel=1e-4)
    assert swing.period == pytest.approx(2.0 * np.pi / np.hypot(2.4, 0.3), rel=1e-4)


def test_elliptic_drop_swings(device):
    """Otherwise surface tension would be too strong or too weak."""
    scenario = Drop(shape="ellipse", rows=12, duration=4.0)
    assert all(check.passed for check in scenario.checks(scenario.run(device=device)))


def test_square_drop_becomes_round(device):
    """Otherwise corners would stay, or fly off and take the drop along."""
    scenario = Drop(rows=12)
    result = scenario.run(device=device)
    assert all(check.passed for check in scenario.checks(result))
    assert result.diagnostics["fourth_mode"].min() < -0.1 < 0.05 < result.diagnostics["fourth_mode"].max()


def test_drop_without_viscosity_stays_in_one_piece(device):
    """Otherwise it would be viscosity alone that holds the particles of a surface in place."""
    result = Drop(shape="ellipse", rows=12, viscosity=0.0, duration=2.0).run(device=device)
    assert result.diagnostics["lost"][-1] == 0.0
