"""The plate behind films against its series: with images, and by the published gradient on one side."""

import numpy as np
import pytest

from warpsph.cases.case import preset_layer, resolve
from warpsph.errors import InputError
from warpsph.scenarios.conduction.plate_convective import PlateConvective


def errors(device: str, **changes) -> list[float]:
    """Root mean square errors after 1 s with 20 and 40 particles across."""
    cases = [PlateConvective(across=n, duration=1.0, output_interval=1.0, step=1.0, **changes) for n in (20, 40)]
    return [float(case.run(device=device).diagnostics["rms_error"][-1]) for case in cases]


@pytest.mark.parametrize(
    "changes", [{"duration": 1.0}, {"across": 20}, {"conductance": 1e4, "height": 0.05, "duration": 4.0}]
)
def test_images(device, changes):
    """Otherwise films or insulation would conduct too much or too little: coarse, strong, not square."""
    case = PlateConvective(**changes)
    checks = case.checks(case.run(device=device))
    assert len(checks) > 1
    assert [check for check in checks if not check.passed] == []


def test_the_published_gradient(device):
    """Otherwise the preset would not be the published boundary: errors of the same sums in double precision."""
    case = resolve(PlateConvective, [preset_layer(PlateConvective, "paper")])
    result = case.run(device=device)
    assert [check for check in case.checks(result) if not check.passed] == []
    series = result.diagnostics
    at = [np.argmin(np.abs(series["time"] - time)) for time in (0.5, 8.0)]
    assert series["rms_error"][at] == pytest.approx([0.4956, 0.7051], abs=1e-3)
    assert series["largest_error"][at] == pytest.approx([2.793, 1.821], abs=2e-3)
    corner = np.argmax(result.positions.sum(axis=1))
    assert result.fields["temperature"][corner] == pytest.approx(273.15 + 53.9134, abs=1e-3)


def test_images_are_second_order_and_the_gradient_first(device):
    """Otherwise one of the two would not be what the manual says of it."""
    coarse, fine = errors(device)
    assert np.log2(coarse / fine) == pytest.approx(2.0, abs=0.2)
    coarse, fine = errors(device, boundary="gradient")
    assert np.log2(coarse / fine) == pytest.approx(1.0, abs=0.3)


@pytest.mark.slow
def test_every_check_passes():
    """Otherwise `warpsph verify` would fail."""
    found = PlateConvective.verify(lambda case: case.run(device="cpu"), True)
    assert [check for check in found if not check.passed] == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"boundary": "mirror"}, "boundary = 'mirror'"),
        ({"conductance": 0.0}, r"conductance = 0.0: .* \[W/\(m\^2 K\)\]"),
        ({"height": 0.0511}, "must be a whole number"),
    ],
)
def test_wrong_input_is_refused_in_one_line(changes, words):
    """A traceback would not tell what is wrong."""
    with pytest.raises(InputError, match=words) as caught:
        PlateConvective(**changes)
    assert "\n" not in str(caught.value)
