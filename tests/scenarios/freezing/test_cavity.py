"""Freezing in an irregular cavity."""

import numpy as np
import pytest

from warpsph.errors import InputError
from warpsph.scenarios.freezing.cavity import Cavity, area, inside, outline


def test_points_inside_a_polygon():
    """Particles beside the cavity would be water in the rock."""
    square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    points = np.array([(0.5, 0.5), (0.01, 0.99), (1.2, 0.5), (-0.1, 0.5), (0.5, 1.5), (-0.5, 0.0)])
    assert list(inside(points, square)) == [True, True, False, False, False, False]
    grid = np.stack(np.meshgrid(*[np.linspace(-0.6, 0.6, 600, endpoint=False) + 0.001] * 2), -1).reshape(-1, 2)
    assert np.mean(inside(grid, outline())) * 1.2**2 == pytest.approx(area(outline()), rel=1e-3)


def test_it_freezes_around_the_sinks_and_upwards(device):
    """Heat that crossed the irregular edge would freeze more, or less; the ledger would not close."""
    case = Cavity(across=24, output_interval=50000.0)
    result = case.run(device=device)
    assert [check for check in case.checks(result) if not check.passed] == []
    frozen, height = (result.diagnostics[name] for name in ("frozen", "height_of_water"))
    assert np.all(np.diff(frozen) > 0.0)
    assert 0.75 < frozen[-1] < 0.9
    assert height[-1] > 0.2
    ice = result.positions[(result.fields["solid_fraction"] == 1.0)]
    assert np.mean(ice[:, 0] < 0.0) == pytest.approx(0.5, abs=0.03)


@pytest.mark.slow
def test_every_check_passes():
    """Otherwise `warpsph verify` would fail."""
    failed = [check for check in Cavity.verify(lambda case: case.run(device="cpu"), True) if not check.passed]
    assert failed == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"start": 273.0}, "start = 273.0 K: must lie above melting"),
        ({"sink_x": 0.4, "sink_y": 0.3}, "a sink must lie in the cavity"),
        ({"strength": 2000.0}, "strength = 2000 W/m: by the end both sinks have taken more heat .*; 38.* W/m at most"),
    ],
)
def test_wrong_input_is_refused_in_one_line(changes, words):
    """A sink in the rock would take its heat from nowhere."""
    with pytest.raises(InputError, match=words) as caught:
        Cavity(**changes)
    assert "\n" not in str(caught.value)
