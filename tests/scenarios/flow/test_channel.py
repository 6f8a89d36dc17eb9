"""Fluid between two plates, coarse: its exact series, and what comes out."""

import numpy as np
import pytest

from warpsph.scenarios.flow.channel_series import Channel
from warpsph.scenarios.flow.couette import Couette
from warpsph.scenarios.flow.poiseuille import Poiseuille

PLATES = [(0.0, 0.0), (-1.0, 2.0), (1.0, None), (None, 1.0)]


@pytest.mark.parametrize(("lower", "upper"), PLATES)
def test_the_series_solves_its_equation(lower, upper):
    """If it failed, the reference would be that of other plates, or of another push."""
    channel = Channel(0.5, 0.1, 3.0, lower, upper)
    y, time, d, dt = np.linspace(0.1, 0.4, 7), 0.3, 1e-3, 1e-4
    bend = (channel.velocity(y + d, time) - 2.0 * channel.velocity(y, time) + channel.velocity(y - d, time)) / d**2
    rate = (channel.velocity(y, time + dt) - channel.velocity(y, time - dt)) / (2.0 * dt)
    np.testing.assert_allclose(rate, 0.1 * bend + 3.0, rtol=1e-4, atol=1e-4)
    for place, speed in ((0.0, lower), (0.5, upper)):
        inside = d if place == 0.0 else -d
        found = channel.velocity(np.array([place, place + inside]), time)
        assert found[0] == pytest.approx(speed) if speed is not None else abs(found[1] - found[0]) < 2e-4
    np.testing.assert_allclose(channel.velocity(y, 0.0), 0.0, atol=0.02)


@pytest.mark.parametrize(
    "case", [Couette(rows=10, lower=-1.0), Poiseuille(rows=10, slip="upper")], ids=lambda c: c.name
)
def test_start_and_end_are_those_of_the_series(case, device):
    """If it failed, walls would act elsewhere than at their faces, or rub where the fluid slips."""
    checks = case.checks(case.run(device=device))
    assert len(checks) == 5
    # 10 rows: four times the errors at 20, 0.2 to 0.9 % of U
    assert max(check.error for check in checks) < 0.012


def test_a_push_sets_the_fluid_in_motion_in_space(device):
    """If it failed, the channel in space would not be that of the plane."""
    case = Poiseuille(dimension=3, rows=8, duration=1.0, output_interval=0.5)
    checks = case.checks(case.run(device=device))
    assert [check.passed for check in checks] == [True, True]
