"""The reference of the crucible against an independent one, and against an exact solution."""

from pathlib import Path

import numpy as np
import pytest

from warpsph.scenarios.conduction.slab_series import Face, Slab
from warpsph.scenarios.crystal.crystal_growth import CrystalGrowth
from warpsph.scenarios.crystal.finite_volumes import SquareCells
from warpsph.scenarios.crystal.isotherm import isotherm

DATA = Path(__file__).parent / "data"


def read(name: str) -> np.ndarray:
    return np.genfromtxt(DATA / name, delimiter=",", comments="#", skip_header=0)[1:]


def test_the_crucible_as_another_program_has_found_it():
    """A mistake in the set-up, a material or a face, would be in the particles and in their reference alike.

    Both divide the crucible into the same cells, so that they agree to the digits that are given.
    """
    case = CrystalGrowth()
    field = case.finite_volumes(1800.0)
    x, z, T = read("finite_volumes.csv").T
    column, row = (x / case.spacing).astype(int), (z / case.spacing).astype(int)
    assert len(T) == 9 * 34
    assert field[column, row] == pytest.approx(T, abs=1e-3)
    _, height = read("interface.csv").T
    assert case.interface(field) == pytest.approx(height[:25], abs=1e-7)


@pytest.mark.parametrize("time", [20.0, 200.0])
def test_a_slab_behind_a_film(time):
    """A reference that is wrong in time would blame the particles. 100 cells, second order in cell and step."""
    slab = Slab(0.1, 10.0, 1e-5, 400.0, Face(0.0, 0.0, 0.0), Face(200.0, 300.0, 0.0))
    n = 100
    flat = np.ones((n, 2))
    cells = SquareCells(
        1e-3,
        10.0 * flat,
        1e6 * flat,
        (np.full(2, 200.0), np.full(n, 1e-9), np.full(n, 1e-9)),
        (np.full(2, 300.0), np.full(n, 300.0), np.full(n, 300.0)),
    )
    found = cells.temperature(400.0 * flat, time)
    x = (np.arange(n) + 0.5) * 1e-3
    assert found[:, 0] == pytest.approx(slab.temperature(x, time), abs=0.02)
    assert found[:, 1] == pytest.approx(found[:, 0], abs=1e-9)


def test_isotherms():
    """An interface that is off by a row, or lost where a column is too hot or too cold, would look like growth."""
    height = np.array([1.0, 2.0, 3.0])
    columns = np.array([[10.0, 20.0, 30.0], [10.0, 11.0, 12.0], [30.0, 40.0, 50.0], [10.0, 30.0, 20.0]])
    assert isotherm(height, columns, 25.0) == pytest.approx([2.5, 3.0, 1.0, 1.75])
