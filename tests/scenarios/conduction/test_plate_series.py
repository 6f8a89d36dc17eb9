"""The exact series of the two plates: values in fifteen digits, and the problems that they solve."""

import numpy as np
import pytest

from warpsph.scenarios.conduction.plate_series import ConvectivePlate, FixedPlate, film_roots

FIXED = FixedPlate(10.0, 10.0, 1.0, 100.0, 0.0)  # in cm and °C, as the source has it
CONVECTIVE = ConvectivePlate(10.0, 10.0, 1.0, 100.0, 0.0, 0.1)

# x, y [cm], t [s], T [°C]: Rook, Yildiz & Dost (2007), equations (19) and (20), summed in forty digits.
VALUES = {
    "fixed": [
        (5.0, 5.0, 0.25, 99.999999999385),
        (1.0, 5.0, 0.25, 84.2700792947124),
        (0.5, 0.5, 0.25, 27.0920122803396),
        (7.5, 2.5, 1.0, 85.1744436818001),
        (5.0, 5.0, 1.0, 99.8372854369998),
        (2.5, 5.0, 4.0, 52.0370997865061),
        (1.0, 1.0, 4.0, 7.56053638119358),
        (5.0, 5.0, 8.0, 33.3800347376355),
        (0.5, 0.5, 8.0, 0.820712548396924),
    ],
    "convective": [
        (10.0, 0.0, 0.25, 94.5990043554961),
        (10.0, 10.0, 0.25, 89.4897162505118),
        (7.5, 7.5, 0.5, 99.9221827153198),
        (10.0, 10.0, 0.5, 85.5546507364138),
        (10.0, 5.0, 1.0, 89.6444531783734),
        (9.0, 9.0, 4.0, 77.381231539551),
        (0.0, 0.0, 8.0, 99.4284645307972),
        (2.5, 7.5, 8.0, 88.5244332106014),
        (10.0, 10.0, 8.0, 55.7343274883449),
    ],
}


@pytest.mark.parametrize(("plate", "values"), [(FIXED, VALUES["fixed"]), (CONVECTIVE, VALUES["convective"])])
def test_values(plate, values):
    """Otherwise the reference itself would be wrong: too few modes, a wrong share, a lost factor."""
    for x, y, time, exact in values:
        assert plate.temperature(np.array([[x, y]]), time)[0] == pytest.approx(exact, abs=1e-11)


def test_roots():
    """A root that is missed, or found twice, would leave a mode out. Of z tan z = 1, in eighteen digits."""
    assert film_roots(1.0, 2) == pytest.approx([0.860333589019379762, 3.42561845948172815], abs=1e-15)
    for biot in (1e-6, 0.01, 1.0, 50.0, 1e6):
        z = film_roots(biot, 40)
        np.testing.assert_allclose(z * np.sin(z), biot * np.cos(z), atol=1e-11 * max(biot, 1.0))
        assert np.all(np.floor(2.0 * z / np.pi) == 2.0 * np.arange(40))


@pytest.mark.parametrize("kind", [FixedPlate, ConvectivePlate])
def test_the_series_solve_their_problems(kind):
    """With edges of two lengths and a warm outside a factor could be wrong that the source's plate does not show."""
    further = {"ratio": 7.0} if kind is ConvectivePlate else {}
    plate = kind(0.2, 0.1, 2e-5, 400.0, 300.0, **further)
    x, step, tick, time = np.array([[0.15, 0.07, 0.0], [0.18, 0.02, 0.0]]), 1e-4, 1e-3, 20.0
    rate = (plate.temperature(x, time + tick) - plate.temperature(x, time - tick)) / (2.0 * tick)
    shifts = step * np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
    laplacian = sum(plate.temperature(x + shift, time) - plate.temperature(x, time) for shift in shifts) / step**2
    np.testing.assert_allclose(rate, 2e-5 * laplacian, rtol=1e-4)
    for axis, edge in ((0, 0.2), (1, 0.1)):
        at = x.copy()
        at[:, axis] = edge
        inside = at - 1e-7 * np.eye(3)[axis]
        slope = (plate.temperature(at, time) - plate.temperature(inside, time)) / 1e-7
        rise = plate.temperature(at, time) - 300.0
        if kind is FixedPlate:
            assert rise == pytest.approx(np.zeros(2), abs=1e-10)
        else:
            assert slope == pytest.approx(-7.0 * rise, rel=1e-4)
    assert plate.temperature(np.array([[0.1, 0.05]]), 0.01) == pytest.approx(400.0, abs=1e-9)
    assert plate.temperature(np.array([[0.1, 0.05]]), 0.0) == 400.0
