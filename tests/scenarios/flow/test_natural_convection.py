"""Natural convection, coarse."""

import numpy as np
import pytest

from warpsph.scenarios.flow.natural_convection import NaturalConvection, fitted


def test_size_follows_from_the_rayleigh_number():
    """Otherwise the box would turn over faster or slower than the one it is compared with."""
    box = NaturalConvection(rayleigh=3e4)
    assert box.lift * box.length**3 / (box.viscosity * box.diffusivity) == pytest.approx(3e4)


def test_fit_is_exact_for_parabolas():
    """Otherwise the highest speed on a midline would be cut off, by more on fewer rows."""
    points = np.random.default_rng(1).uniform(0.0, 1.0, (400, 2))
    values = 1.0 + points[:, 0] - 2.0 * points[:, 1] ** 2
    np.testing.assert_allclose(fitted(points, values, np.array([[0.5, 0.5], [0.0, 1.0]]), 0.1), [1.0, -1.0], atol=1e-6)


def test_heat_carried_across(device):
    """Otherwise the air would turn at the wrong speed, lose heat, or keep it from the walls."""
    scenario = NaturalConvection(rows=20, duration=5.0, output_interval=0.25)
    checks = scenario.checks(scenario.run(device=device))
    assert len(checks) == 4  # 20 rows: within 3.2 % of the source, of second order from 0.25 to 1 % at 40 rows
    assert [f"{check.quantity}: {check.measured:.4g}" for check in checks if not check.passed] == []


@pytest.mark.slow
@pytest.mark.parametrize(("rayleigh", "rows", "duration"), [(1e3, 40, 2.0), (1e5, 60, 25.0)])
def test_other_rayleigh_numbers(rayleigh, rows, duration, device):
    """Otherwise one Rayleigh number alone would be right, by luck."""
    scenario = NaturalConvection(rayleigh=rayleigh, rows=rows, duration=duration, output_interval=duration / 20.0)
    checks = scenario.checks(scenario.run(device=device))
    assert [f"{check.quantity}: {check.measured:.4g}" for check in checks if not check.passed] == []
