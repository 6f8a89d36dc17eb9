"""The tank at rest, coarse."""

import numpy as np
import pytest

from warpsph.scenarios.flow.still_tank import StillTank


@pytest.mark.parametrize("start", ["hydrostatic", "disordered"])
def test_pressure_is_calm(start, device):
    """Otherwise the pressure of a liquid at rest would be noise, or its particles would never come to rest."""
    scenario = StillTank(rows=16, duration=4.0, start=start)
    result = scenario.run(device=device)
    assert [check.quantity for check in scenario.checks(result) if not check.passed] == []


def test_a_surface_of_an_inviscid_liquid_calms_down(device):
    """Otherwise the change of corrected to plain sums under the surface would feed a motion that never ends."""
    result = StillTank(rows=16, duration=6.0).run(device=device)
    speed = result.diagnostics["speed"]
    third = len(speed) // 3
    assert speed[-third:].mean() < 0.8 * speed[1 : third + 1].mean()


def test_a_start_without_pressure_rings_and_calms(device):
    """Otherwise sound would be heard for ever where nothing rubs."""
    scenario = StillTank(rows=12, start="unpressed", duration=10.0)
    error = scenario.run(device=device).diagnostics["pressure_error"]
    assert np.max(error[1:9]) > 3.0 * np.mean(error[-8:])


def test_the_published_flow_scatters_more(device):
    """Otherwise the two formulations of the scenario would be one."""
    viscosity = StillTank(rows=12).viscosity_of_cell(10.0)
    error = [
        StillTank(rows=12, duration=2.0, viscosity=viscosity, formulation=name).run(device=device)
        for name in ("corrected", "published")
    ]
    assert 5.0 * error[0].diagnostics["pressure_error"][-1] < error[1].diagnostics["pressure_error"][-1]


@pytest.mark.slow
@pytest.mark.parametrize("rows", [16, 24])
def test_pressure_is_calm_in_space(rows, device):
    """Otherwise the third dimension would bring noise that the plane does not have."""
    scenario = StillTank(dimension=3, rows=rows)
    assert [check.quantity for check in scenario.checks(scenario.run(device=device)) if not check.passed] == []
