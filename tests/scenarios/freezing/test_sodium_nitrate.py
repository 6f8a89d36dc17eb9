"""The freezing solution against the exact mush."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.errors import InputError
from warpsph.scenarios import SodiumNitrate
from warpsph.scenarios.freezing.sodium_nitrate import EARLY, LATE


@pytest.fixture(scope="module")
def narrow():
    """30 rows, four columns."""
    case = SodiumNitrate(columns=4)
    return case, case.run(device="cpu")


def test_a_narrow_box_agrees_with_the_exact_mush(narrow):
    """If it failed, the mush would grow too fast, be too thin, or salt, mass or heat would be lost."""
    case, result = narrow
    checks = case.checks(result)
    assert len(checks) == 8
    assert [check for check in checks if not check.passed] == []


def test_finer_rows_come_nearer(narrow):
    """If it failed, the particles would go to another solution than the exact one."""
    coarse_case, coarse = narrow
    fine_case = SodiumNitrate(columns=4, rows=60)
    fine = fine_case.run(device="cpu")
    for time in (EARLY, LATE):
        ratios = np.abs(np.divide(fine_case.errors(fine, time), coarse_case.errors(coarse, time)))
        assert np.all(ratios < 0.75), ratios


def test_the_width_does_not_matter(narrow):
    """If it failed, walls at the sides would hold heat or ice back."""
    case, result = narrow
    wide = case.model_copy(update={"columns": 12}).run(device="cpu")
    for name in ("temperature", "ice", "brine"):
        np.testing.assert_allclose(wide.diagnostics[name], result.diagnostics[name], rtol=1e-5, atol=1e-5)


def test_threads_and_stops_change_nothing():
    """If it failed, a run could not be repeated, or one that goes on would go elsewhere."""
    case = SodiumNitrate(columns=8, rows=20, duration=6000.0, output_interval=2000.0)
    whole = case.run(device="cpu", threads=1)
    parts = case.build(Executor("cpu", 2))
    parts.run(2000.0, 2000.0)
    stopped = parts.run(4000.0, 2000.0)
    for name in ("temperature", "ice_temperature", "solute", "liquid_heat", "ice_mass", "heat_freed"):
        np.testing.assert_array_equal(stopped.fields[name], whole.fields[name])


def test_what_has_frozen_stays_in_equilibrium():
    """If it failed, a box that has come to rest would end in numbers that are none."""
    case = SodiumNitrate(height=0.05, columns=4, rows=8, duration=1e5, output_interval=1e4)
    result = case.run(device="cpu")
    ice, heat, taken = (result.diagnostics[name] for name in ("ice_mass", "heat", "heat_taken"))
    assert ice[-1] == pytest.approx(ice[-2], rel=1e-4)
    assert heat[-1] - heat[0] == pytest.approx(-taken[-1], rel=1e-6)
    assert result.fields["temperature"] == pytest.approx(case.cold, abs=1e-3)


def test_conduction_as_printed_thickens_the_mush(narrow):
    """If it failed, the option would not show what is wrong with (4.2)."""
    _, result = narrow
    printed = SodiumNitrate(columns=4, literal=True).run(device="cpu")
    assert 1.2 < printed.diagnostics["mush"][-1] / result.diagnostics["mush"][-1] < 1.35
    for name in ("mass", "salt"):
        series = printed.diagnostics[name]
        assert series[-1] == pytest.approx(series[0], rel=1e-9)


@pytest.mark.slow
def test_every_check_holds():
    """If it failed, `warpsph verify --slow sodium_nitrate` would say so."""
    failed = [c for c in SodiumNitrate.verify(lambda case: case.run(device="cpu"), slow=True) if not c.passed]
    assert failed == []


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"cold": 250.0}, r"cold \(250 K\) must be above eutectic .*freeze the salt, too, which the model leaves out"),
        ({"cold": 268.0}, r"liquidus of the solution \(267.231 K\) must be above cold \(268 K\).*freezes nothing"),
        ({"warm": 260.0}, r"warm \(260 K\) must be above liquidus of the solution .*ice that is there at the start"),
        ({"concentration": 0.05}, "ice would fill 1.04 of the room at the wall; the model leaves out"),
        ({"liquidus_slope": 17.0, "concentration": 0.3}, "liquidus_slope: too small for the eutectic"),
        ({"columns": 2}, "columns = 2"),
        ({"smoothing": 0.9}, "smoothing = 0.9"),
    ],
)
def test_wrong_input(wrong, message):
    """If it failed, a run would end where the model does not hold, without a word."""
    with pytest.raises(InputError, match=message):
        SodiumNitrate(**wrong)
