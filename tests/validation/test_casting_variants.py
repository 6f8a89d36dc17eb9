"""Casting runs of some seconds: other starts, the published elasticity, and a longer comparison of threads."""

import numpy as np
import pytest

from warpsph.scenarios.casting.casting import Casting

pytestmark = pytest.mark.slow


def ledgers_close(case: Casting, result) -> bool:
    ledgers = ("particles lost (inside - start - in + out)", "ids that are missing or doubled", "enthalpy ledger")
    return all(check.passed for check in case.checks(result) if check.quantity in ledgers)


def test_a_grid_settles_to_the_column_at_rest():
    """The hydrostatic start is only a short cut: the regular grid must come to the same pressure."""
    pressures = []
    for start in ("hydrostatic", "grid"):
        case = Casting(start=start, duration=3.0, output_interval=1.0)
        result = case.run()
        assert ledgers_close(case, result)
        x, y = result.positions[:, 0], result.positions[:, 1]
        deep = (result.fields["role"] == 0) & (x > 0.02) & (x < 0.06) & (y > 0.03) & (y < 0.08)
        pressures.append(np.mean(result.fields["pressure"][deep]))
    assert pressures[1] == pytest.approx(pressures[0], rel=0.03)
    assert pressures[0] == pytest.approx(2100.0 * 9.81 * (0.44 - 0.055), rel=0.06)


def test_the_published_elasticity_runs():
    """The form of the thesis is an option that must work, for comparison."""
    case = Casting(elasticity="published", duration=1.0, output_interval=0.5)
    result = case.run()
    assert ledgers_close(case, result)
    assert np.all(result.diagnostics["escaped_melt"] == 0)


def test_threads_do_not_change_a_bit_in_two_seconds():
    """A race would show in a long run before it shows in a short one."""
    one, all_cores = (Casting(duration=2.0, output_interval=1.0).run(threads=threads) for threads in (1, None))
    assert np.array_equal(one.positions, all_cores.positions)
    assert np.array_equal(one.fields["enthalpy"], all_cores.fields["enthalpy"])
