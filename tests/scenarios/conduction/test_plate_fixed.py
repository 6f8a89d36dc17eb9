"""The plate between cold edges against its series: the default, as published, wrong input."""

import numpy as np
import pytest

from warpsph.cases.case import preset_layer, resolve
from warpsph.errors import InputError
from warpsph.scenarios.conduction.plate_checks import carried
from warpsph.scenarios.conduction.plate_fixed import PlateFixed
from warpsph.scenarios.conduction.plate_steps import step_checks


def paper(**changes) -> PlateFixed:
    case = resolve(PlateFixed, [preset_layer(PlateFixed, "paper")])
    return PlateFixed(**case.model_dump() | changes)


def failed(case: PlateFixed, device: str) -> list:
    checks = case.checks(case.run(device=device))
    assert len(checks) > 1
    return [check for check in checks if not check.passed]


@pytest.mark.parametrize("changes", [{"duration": 2.0}, {"across": 20}, {"length": 0.2, "across": 79, "duration": 4.0}])
def test_the_series(device, changes):
    """Otherwise the plate would cool too fast or too slowly: a coarse one, one that is not square."""
    assert failed(PlateFixed(**changes), device) == []


@pytest.mark.parametrize(
    ("integrator", "step", "expected"),
    [
        ("crank_nicolson", 0.009, [0.0709, 0.0142, 0.0099]),
        ("crank_nicolson", 0.05, [0.0753, 0.0137, 0.0105]),
        ("backward_euler", 0.05, [0.4897, 0.1545, 0.1364]),
    ],
)
def test_implicit_steps(device, integrator, step, expected):
    """Otherwise an integrator would not be the one of its equation: errors at 1, 4 and 8 s of the same sums, solved in
    double precision with direct elimination."""
    case = PlateFixed(integrator=integrator, step=step)
    result = case.run(device=device)
    assert [check for check in case.checks(result) if not check.passed] == []
    series = result.diagnostics
    found = [series["rms_error"][np.argmin(np.abs(series["time"] - time))] for time in (1.0, 4.0, 8.0)]
    assert found == pytest.approx(expected, abs=0.001)


def test_long_steps(device):
    """Otherwise an integrator would not have its order, or a step of 20 explicit ones would be off by more than 1 %."""
    checks = list(step_checks(PlateFixed, lambda case: case.run(device=device), slow=False))
    assert len(checks) == 5
    assert [check for check in checks if not check.passed] == []


def test_the_published_method_is_slow_by_the_area_of_its_particles(device):
    """Otherwise the preset would not be the method of the paper: 0.0625 cm^2 where the lattice has 0.0657 cm^2.

    The errors at 0.25, 1 and 8 s are those of the same sums in double precision.
    """
    case = paper()
    assert case.share == pytest.approx(6.25e-6)
    assert case.smoothing_length * case.spacing == pytest.approx(0.0025)
    assert carried(case) == pytest.approx(0.9629, abs=5e-5)
    result = case.run(device=device)
    assert [check for check in case.checks(result) if not check.passed] == []
    series = result.diagnostics
    found = [series["rms_error"][np.argmin(np.abs(series["time"] - time))] for time in (0.25, 1.0, 8.0)]
    assert found == pytest.approx([0.258, 0.639, 0.969], abs=0.002)


@pytest.mark.slow
def test_every_check_passes():
    """Otherwise `warpsph verify` would fail."""
    failed = [check for check in PlateFixed.verify(lambda case: case.run(device="cpu"), True) if not check.passed]
    assert failed == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (
            {"height": 0.05},
            r"height = 0.05 m is 19.5 spacings of 0.0025641 m: must be a whole number, 6 or more; 0.05128",
        ),
        ({"edge": 373.15}, "start = 373.15 K is the temperature outside: nothing would happen"),
        ({"across": 4}, "across = 4"),
        ({"integrator": "midpoint"}, "integrator = 'midpoint'"),
        ({"step": 0.0}, r"step = 0.0: .* \[s\]"),
    ],
)
def test_wrong_input_is_refused_in_one_line(changes, words):
    """A traceback, or a plate whose rows do not meet its edge, would not tell what is wrong."""
    with pytest.raises(InputError, match=words) as caught:
        PlateFixed(**changes)
    assert "\n" not in str(caught.value)
