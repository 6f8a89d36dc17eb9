"""A particle whose every step is below single precision."""

import pytest

from warpsph.scenarios.compensated_drift import CompensatedDrift


@pytest.mark.parametrize(("start", "speed"), [(2.0, 1e-3), (-2.0, -1e-3), (2.0, -1e-3)])
def test_lands_where_it_should(start, speed, device):
    """Otherwise a strand withdrawn at a centimetre a second would stand still."""
    scenario = CompensatedDrift(start=start, speed=speed, duration=0.1)
    (check,) = scenario.checks(scenario.run(device=device))
    assert check.passed
    assert check.measured != start
