"""The warm spot against the fundamental solution."""

import numpy as np

from warpsph.scenarios.conduction.heat_gaussian import BACKGROUND, HeatGaussian


def test_fundamental_solution(device):
    """Otherwise heat would spread too fast, too slowly, or get lost."""
    scenario = HeatGaussian(spacing=0.02)
    result = scenario.run(device=device)
    error = np.abs(result.fields["temperature"] - scenario.exact(result.positions, result.time)).max()
    assert error < 0.015 * (scenario.exact(np.zeros((1, 3)), result.time)[0] - BACKGROUND)
    assert scenario.checks(result)[1].passed


def test_second_order(device):
    """Otherwise a finer plate would not come nearer to the exact temperature as it should."""
    assert all(check.passed for check in HeatGaussian.verify(lambda scenario: scenario.run(device=device), slow=False))


def test_exact_solution_solves_the_heat_equation():
    """Otherwise the reference itself would be wrong."""
    scenario = HeatGaussian()
    place, time, step, tick = np.array([[0.1, 0.05, 0.0]]), 3.0, 1e-3, 1e-3
    rate = (scenario.exact(place, time + tick) - scenario.exact(place, time - tick)) / (2 * tick)
    shifts = step * np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
    laplacian = sum(scenario.exact(place + shift, time) - scenario.exact(place, time) for shift in shifts) / step**2
    np.testing.assert_allclose(rate, scenario.diffusivity * laplacian, rtol=1e-3)
