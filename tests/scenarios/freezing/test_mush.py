"""The exact mush beside a solution of another program, its equations, and its limits."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from warpsph.scenarios import SodiumNitrate
from warpsph.scenarios.freezing.mush import Mush

MUSH = SodiumNitrate().exact
TABLE = np.genfromtxt(Path(__file__).parent / "data" / "mush_fixed_mass.csv", delimiter=",", names=True, skip_header=1)


@pytest.mark.parametrize("time", [13200.0, 91800.0])
def test_another_program_finds_the_same(time):
    """If it failed, the reference itself would be wrong."""
    rows = TABLE[(TABLE["time_s"] == time) & (TABLE["height_m"] > 0.0)]
    height = rows["height_m"]
    np.testing.assert_allclose(MUSH.temperature(height, time) - 273.15, rows["temperature_C"], atol=0.03)
    np.testing.assert_allclose(MUSH.ice(height, time), rows["ice"], atol=3e-3)
    np.testing.assert_allclose(MUSH.solute(height, time), rows["brine"], atol=1e-3)


def test_thickness():
    """If it failed, the front would be somewhere else than the first ice."""
    assert MUSH.front(13200.0) == pytest.approx(0.0349, abs=1e-4)
    assert MUSH.front(91800.0) == pytest.approx(0.0920, abs=2e-4)
    assert float(MUSH.temperature(np.array([0.0]), 1e4)[0]) == pytest.approx(256.65, abs=1e-3)


def test_it_solves_the_equations():
    """If it failed, heat or solute would not be balanced; by differences, at a height in the mush and one ahead."""
    time, step, tick = 5e4, 2e-4, 50.0
    for y in (0.02, 0.05, 0.12):
        places = y + step * np.array([-1.0, 0.0, 1.0])
        T, ice, C = MUSH.temperature(places, time), MUSH.ice(places, time), MUSH.solute(places, time)
        conductivity = ice * MUSH.conductivity_ice + (1.0 - ice) * MUSH.conductivity_liquid
        flux = -0.5 * (conductivity[1:] + conductivity[:-1]) * np.diff(T) / step
        here = np.array([y])
        before, after = ((MUSH.temperature(here, t)[0], MUSH.ice(here, t)[0]) for t in (time - tick, time + tick))
        warms, frozen = (np.array(after) - np.array(before)) / (2.0 * tick)
        share = ice[1] * MUSH.density_ice / MUSH.density_liquid
        capacity = share * MUSH.capacity_ice + (1.0 - share) * MUSH.capacity_liquid
        gained = MUSH.density_liquid * capacity * warms - MUSH.density_ice * MUSH.latent_heat * frozen
        assert gained == pytest.approx(-np.diff(flux)[0] / step, rel=0.01)
        passed = -MUSH.diffusivity * (1.0 - 0.5 * (ice[1:] + ice[:-1])) * np.diff(C) / step

        def solute(t, here=here):
            share = MUSH.ice(here, t)[0] * MUSH.density_ice / MUSH.density_liquid
            return MUSH.density_liquid * (1.0 - share) * MUSH.solute(here, t)[0]

        change = (solute(time + tick) - solute(time - tick)) / (2.0 * tick)
        assert change == pytest.approx(-np.diff(passed)[0] / step, rel=0.05, abs=1e-6)


def test_limits():
    """If it failed, parameters of one's own would find a wrong front, or a search without end."""
    still = replace(MUSH, diffusivity=0.0)
    assert still.front(91800.0) == pytest.approx(0.0933, abs=1e-4)
    assert still.front_temperature == still.liquidus
    thin = replace(MUSH, far=310.0)
    assert thin.front(1e4) < MUSH.front(1e4) < replace(MUSH, wall=255.0).front(1e4)
    impossible: Mush = replace(MUSH, concentration=0.02, wall=250.0)
    assert np.isnan(impossible.front(1e4))
    assert np.all(np.isnan(impossible.temperature(np.array([0.01]), 1e4)))


@pytest.mark.parametrize(
    ("given", "front"),
    [
        ({"density_ice": 1097.0, "concentration": 0.02}, 0.1195),  # particles: 0.112 m with 30 rows
        ({"density_ice": 1097.0, "concentration": 0.05}, 0.1128),
        ({"concentration": 0.89, "liquidus_slope": 1e3, "melting_point": 1e3, "eutectic": 1.0, "cold": 2.0}, 0.0795),
        ({"warm": 330.0}, 0.0521),
    ],
)
def test_the_front_meets_the_wall(given, front):
    """If it failed, the edge of where an integration gets through would be taken for the front."""
    case = SodiumNitrate(**given)
    assert case.exact.front(91800.0) == pytest.approx(front, abs=2e-4)
    assert float(case.exact.temperature(np.array([0.0]), 91800.0)[0]) == pytest.approx(case.cold, abs=1e-5)


def test_conduction_as_printed():
    """If it failed, (4.2) would be blamed for too much or too little; the ratio by another program."""
    still = replace(MUSH, diffusivity=0.0)
    assert replace(still, literal=True).front(1.0) / still.front(1.0) == pytest.approx(0.1197 / 0.0933, rel=5e-3)
