"""A plate of rubber that is clamped at one end and swings."""

import numpy as np
import pytest

from warpsph.core.labels import Role
from warpsph.scenarios.elastic.cantilever import Cantilever, first_mode, period


def test_a_coarse_plate_swings_as_it_should(device):
    """A wrong stiffness, mass or clamp would change the period."""
    scenario = Cantilever(layers=6, duration=0.3)
    result = scenario.run(device=device, threads=1)
    checks = scenario.checks(result)
    assert [check.unit for check in checks] == ["s", "m", ""]
    assert all(check.passed for check in checks)
    held = result.fields["role"] == Role.WALL
    assert np.all(result.fields["velocity"][held] == 0.0)
    assert result.positions[held, 0].max() < scenario.spacing


def test_other_plates_are_not_compared():
    """A plate of another shape has another period."""
    scenario = Cantilever(layers=4, thickness=0.04, duration=0.01)
    (energy,) = scenario.checks(scenario.run(device="cpu", threads=1))
    assert energy.passed


def test_period_comes_from_interpolated_zeros():
    """Otherwise the output interval would decide on the period."""
    time = np.arange(0.0, 1.0, 0.011)
    assert period(time, np.sin(2.0 * np.pi * time / 0.237)) == pytest.approx(0.237, rel=1e-3)


def test_first_mode_is_clamped_and_free():
    """A wrong sign in the mode would start the plate with a kink."""
    s = np.linspace(0.0, 1.0, 1001)
    curvature = np.gradient(np.gradient(first_mode(s), s), s)
    assert first_mode(0.0) == pytest.approx(0.0, abs=1e-12)
    assert first_mode(s)[1] < 1e-5
    assert abs(curvature[-3]) < 0.02 * abs(curvature[3])
