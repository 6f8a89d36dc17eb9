"""The slab between two walls against the series of its modes."""

import numpy as np
import pytest

from warpsph.scenarios.conduction.heat_slab import HeatSlab
from warpsph.scenarios.conduction.slab_series import Face, Slab

GIVEN = Face(np.inf, 400.0, 0.0)
FILM = Face(200.0, 350.0, 0.0)
FLUX = Face(0.0, 0.0, -1e4)
INSULATED = Face(0.0, 0.0, 0.0)


def test_every_preset_agrees_with_its_series(device):
    """Otherwise a wall of some kind would conduct too much, too little, or to nobody."""
    failed = [check for check in HeatSlab.verify(lambda case: case.run(device=device), slow=False) if not check.passed]
    assert failed == []


@pytest.mark.parametrize("kind", ["temperature", "film", "flux", "insulated"])
@pytest.mark.parametrize("dimension", [2, 3])
def test_rows_on_walls(device, kind, dimension):
    """Cells that a wall cuts would count in full, and the slab would seem half a row thicker on each side."""
    case = HeatSlab(dimension=dimension, rows=10, breadth=4, left=kind, right_temperature=350.0, row_on_wall=True)
    assert [check for check in case.checks(case.run(device=device)) if not check.passed] == []


@pytest.mark.parametrize("left", [GIVEN, FILM, FLUX, INSULATED])
@pytest.mark.parametrize("right", [GIVEN, FILM, FLUX, INSULATED])
def test_the_series_solves_the_problem(left, right):
    """Otherwise the reference itself would be wrong: equation, faces and start, by differences."""
    slab = Slab(0.1, 10.0, 1e-5, 300.0, left, right)
    x, step, tick, time = np.linspace(0.01, 0.09, 9), 1e-4, 0.1, 100.0
    rate = (slab.temperature(x, time + tick) - slab.temperature(x, time - tick)) / (2.0 * tick)
    bend = slab.temperature(x + step, time) - 2.0 * slab.temperature(x, time) + slab.temperature(x - step, time)
    np.testing.assert_allclose(rate, 1e-5 * bend / step**2, rtol=1e-3, atol=1e-4)
    ends = slab.temperature(np.array([0.0, 0.1]), time)
    for face, end, flux in zip((left, right), ends, slab.flux(time), strict=True):
        if np.isinf(face.conductance):
            assert end == pytest.approx(face.outside, abs=1e-6)
        else:
            assert flux == pytest.approx(face.conductance * (end - face.outside) + face.flux, abs=1e-3)
    assert slab.temperature(np.array([0.05]), 5.0)[0] == pytest.approx(300.0, abs=0.1)
