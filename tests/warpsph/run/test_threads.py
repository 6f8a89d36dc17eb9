"""Runs in several threads of one process, and a run within a run."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from warpsph.scenarios import HeatGaussian

CASES = [{"spacing": 0.05, "duration": 0.05, "output_interval": 0.01}, {"spacing": 0.04, "duration": 0.03}]


def final_temperatures(case: dict) -> np.ndarray:
    return HeatGaussian(**case).run(device="cpu", threads=1).fields["temperature"]


def test_runs_in_two_threads_have_the_bits_of_one_after_the_other():
    """If it failed, one run's launches would be recorded into another's step, and its result be wrong in silence."""
    expected = [final_temperatures(case) for case in CASES]
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(final_temperatures, CASES * 4))
    for k, temperatures in enumerate(found):
        np.testing.assert_array_equal(temperatures, expected[k % 2])


def test_a_run_within_a_run_goes_on():
    """If it failed, an observer that simulates something of its own would wait for itself for ever."""
    found = []
    outer = HeatGaussian(**CASES[0]).run(
        device="cpu", threads=1, progress=lambda progress: found.append(final_temperatures(CASES[1]))
    )
    np.testing.assert_array_equal(found[0], final_temperatures(CASES[1]))
    np.testing.assert_array_equal(outer.fields["temperature"], final_temperatures(CASES[0]))
