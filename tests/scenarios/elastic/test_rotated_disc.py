"""A solid disc that has been turned."""

import pytest

from warpsph.scenarios.elastic.rotated_disc import RotatedDisc


@pytest.mark.parametrize("angle", [90.0, -33.0, 180.0])
def test_rotated_disc_feels_no_force(angle, device):
    """Otherwise a shell that tilts would be torn or squeezed by nothing."""
    scenario = RotatedDisc(angle=angle, spacing=4e-3, duration=0.005)
    (check,) = scenario.checks(scenario.run(device=device))
    assert check.passed


def test_published_form_feels_the_turn(device):
    """Otherwise the option for the published form would not be the published form."""
    scenario = RotatedDisc(spacing=4e-3, duration=0.002, corrected=False)
    (check,) = scenario.checks(scenario.run(device=device))
    assert check.measured > 0.01


def test_momentum(device):
    """Otherwise elastic forces would push the strand along."""
    scenario = RotatedDisc(spacing=4e-3, stretch=0.02, drift=1.0, duration=0.01)
    result = scenario.run(device=device)
    (check,) = scenario.checks(result)
    assert check.passed
    assert result.diagnostics["largest_force"][1:].min() > 1e-3 * scenario.youngs_modulus * scenario.spacing
