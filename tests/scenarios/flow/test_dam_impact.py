"""The dam break against a wall, coarse."""

import numpy as np
import pytest

from warpsph.cases.case import Layer, resolve
from warpsph.errors import InputError
from warpsph.scenarios.flow.dam_impact import DamImpact, arrival, mean_between, top_of_water
from warpsph.scenarios.flow.lobovsky import GAUGES, SENSORS, published_level, published_pressure


def test_published_tables_are_whole():
    """Otherwise the reference would not be the experiment, or a column would be that of another sensor."""
    for sensor in SENSORS:
        time, _ = published_pressure(sensor)
        assert len(time) == 247
        assert np.all(np.diff(time) > 0.0)
    peaks = [published_pressure(sensor)[1].max() for sensor in SENSORS]
    assert peaks == pytest.approx([2.52, 1.91, 1.52, 0.81], abs=0.01)
    assert all(published_level(gauge)[1][0] == (gauge == "h1") for gauge in GAUGES)


def test_arrival_is_between_two_outputs():
    """Otherwise the arrival would be late by an interval of output."""
    assert arrival(np.array([1.0, 2.0, 3.0]), np.array([0.0, 0.05, 0.15])) == pytest.approx(2.5)
    assert arrival(np.array([1.0, 2.0]), np.array([0.0, 0.05])) is None


def test_level_is_that_of_the_water_on_the_bed():
    """Otherwise a single drop in flight would be a level of four times the height of the column."""
    assert top_of_water(np.array([0.35, 0.05, 0.15, 0.26]), 0.1) == pytest.approx(0.4)
    assert top_of_water(np.array([0.05, 0.15, 4.0]), 0.1) == pytest.approx(0.2)
    assert top_of_water(np.array([0.6]), 0.1) == 0.0
    assert top_of_water(np.array([]), 0.1) == 0.0


def test_wave_arrives_in_time_and_nothing_escapes(device):
    """Otherwise the water would rub, stick or leak at the walls."""
    scenario = DamImpact(rows=20, duration=0.6)
    result = scenario.run(device=device)
    assert result.diagnostics["escaped"].max() == 0.0
    time = result.diagnostics["time"] / scenario.moment
    first = arrival(*published_pressure("p1"))
    assert arrival(time, result.diagnostics["p1"]) == pytest.approx(first, rel=0.05)
    levels = [check for check in scenario.checks(result) if "level" in check.quantity]
    assert len(levels) == 4
    assert all(check.passed for check in levels)


def test_friction_takes_pressure_out_of_the_corner():
    """Water that kept its whole head along the bed would stop in the corner with a third more than the experiment."""
    pressures = []
    for viscosity in (8.9e-4, 0.0):
        scenario = DamImpact(rows=16, duration=0.97, viscosity=viscosity)
        series = scenario.run(device="cpu", threads=1).diagnostics
        time = series["time"] / scenario.moment
        pressures.append([mean_between(time, series[name]) for name in SENSORS])
    rubbed, slipped = pressures
    assert rubbed[0] < 0.95 * slipped[0]
    assert rubbed[3] > slipped[3]


@pytest.mark.parametrize("viscosity", [0.1, 1.0])
def test_viscous_water_survives_the_impact(viscosity):
    """Friction that acts on what hits a wall in the wrong direction would end in numbers that are none."""
    series = DamImpact(rows=12, duration=0.7, viscosity=viscosity).run(device="cpu", threads=1).diagnostics
    assert all(np.all(np.isfinite(values)) for values in series.values())
    assert series["p1"].max() > 1.0
    assert series["escaped"].max() == 0.0


@pytest.mark.parametrize("given", [{"width": 0.6, "length": 0.3}, {"width": 0.01, "height": 10.0}], ids=str)
def test_a_column_that_does_not_fit_is_refused(given):
    """Water beyond the end wall would stand in it, and fly apart at the first step."""
    with pytest.raises(InputError, match=r"width = .* m: must be at least a spacing"):
        resolve(DamImpact, [Layer("--set", given)])
