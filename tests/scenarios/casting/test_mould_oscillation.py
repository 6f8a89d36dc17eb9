"""Negative strip and the answer to the mould's stroke, on curves that are known."""

import numpy as np
import pytest

from warpsph.scenarios.casting.mould_oscillation import negative_strip_time, overtaking_time, response


def test_negative_strip_time_is_the_formula_in_its_usual_units():
    """60/(pi f) arccos(1000 v/(pi f s)) with 90 cycles/min, 6 mm, 0.6 m/min."""
    usual = 60.0 / (np.pi * 90.0) * np.arccos(1000.0 * 0.6 / (np.pi * 90.0 * 6.0))
    assert negative_strip_time(0.006, 1.5, 0.01) == pytest.approx(usual, rel=1e-12)


def test_a_slow_mould_never_overtakes():
    """An arccos outside its range would be a nan in a report."""
    assert negative_strip_time(0.001, 1.0, 0.01) == 0.0


@pytest.mark.parametrize("phase", [0.0, 1.0, 4.0])
def test_overtaking_of_a_sine_is_the_negative_strip_time(phase):
    """The measured time must agree with the formula where the strand moves evenly."""
    time = np.arange(0.0, 4.0 / 1.5 + 1e-9, 1.0 / 75.0)
    mould = 0.003 * 3.0 * np.pi * np.cos(3.0 * np.pi * time + phase)
    measured = overtaking_time(time, mould, np.full_like(time, -0.01), 1.5)
    assert measured == pytest.approx(negative_strip_time(0.006, 1.5, 0.01), rel=2e-3)


def test_response_finds_amplitude_and_phase_beside_a_trend_and_other_waves():
    """A level that sinks, or waves of the jet, must not pass for an answer to the mould."""
    time = np.linspace(0.0, 4.0, 201)
    values = 2e-3 * np.sin(3.0 * np.pi * time + 0.7) + 0.44 - 1e-3 * time + 1e-3 * np.sin(2.0 * np.pi * 5.0 * time)
    amplitude, phase = response(time, values, 1.5)
    assert amplitude == pytest.approx(2e-3, rel=2e-2)
    assert phase == pytest.approx(0.7, abs=2e-2)
