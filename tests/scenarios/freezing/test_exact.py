"""The exact solutions of freezing: equations, fronts and published numbers."""

import numpy as np
import pytest
from scipy.special import erf

from warpsph.scenarios.freezing.line_sink import LineSink
from warpsph.scenarios.freezing.neumann import Neumann
from warpsph.scenarios.freezing.point_sink import WATER

ONE = dict.fromkeys(WATER, 1.0)
UNEQUAL = ONE | {"conductivity_liquid": 0.27, "heat_capacity_liquid": 2.0}


def slopes(solution, front: float, time: float) -> tuple[float, float]:
    """Gradient of the temperature on both sides of the front."""
    d = 1e-6 * front
    T = solution.temperature(front + d * np.array([-2.0, -1.0, 1.0, 2.0]), time)
    return float(T[1] - T[0]) / d, float(T[3] - T[2]) / d


@pytest.mark.parametrize("properties", [ONE, UNEQUAL, WATER], ids=["equal", "unequal", "water"])
@pytest.mark.parametrize("kind", [Neumann, LineSink])
def test_exact_solutions_solve_their_problem(kind, properties):
    """Otherwise the reference itself would be wrong: equation in both phases, balance of heat at the front (3.1)."""
    solution = kind(0.3, 273.15, 280.0, **properties)
    time = 0.05 / solution.diffusivity_solid
    front, tick = float(solution.front(time)), 1e-4 * time
    d = 1e-3 * front
    for r, diffusivity in ((0.6 * front, solution.diffusivity_solid), (1.5 * front, solution.diffusivity_liquid)):
        x = np.array([r])
        rate = (solution.temperature(x, time + tick) - solution.temperature(x, time - tick)) / (2.0 * tick)
        below, here, above = (solution.temperature(x + s, time) for s in (-d, 0.0, d))
        bend = (above - 2.0 * here + below) / d**2
        if kind is LineSink:
            bend = bend + (above - below) / (2.0 * d) / r
        assert rate == pytest.approx(diffusivity * bend, rel=1e-4)
    assert solution.temperature(np.array([front]), time)[0] == pytest.approx(273.15, abs=1e-9)
    solid, liquid = slopes(solution, front, time)
    speed = (solution.front(time + tick) - solution.front(time - tick)) / (2.0 * tick)
    balance = properties["conductivity_solid"] * solid - properties["conductivity_liquid"] * liquid
    assert balance == pytest.approx(properties["density"] * properties["latent_heat"] * speed, rel=1e-3)


def test_the_plane_takes_the_heat_of_its_gradient():
    """The ledger of the cold face would be compared with a wrong number."""
    solution = Neumann(0.5, 1.0, 1.2, **ONE)
    times = np.linspace(0.01, 0.05, 4001)
    flux = [float(solution.temperature(np.array([1e-6]), t)[0] - solution.plane) / 1e-6 for t in times]
    assert solution.heat(0.05) - solution.heat(0.01) == pytest.approx(np.trapezoid(flux, times), rel=1e-4)


@pytest.mark.parametrize("conductivity", [1e-3, 1e-5, 1e-9])
def test_melt_that_hardly_conducts_has_a_plane_too(conductivity):
    """If it failed, zero would be divided by zero; the less the melt conducts, the thinner its layer."""
    solution = Neumann(0.5, 1.0, 1.2, **(ONE | {"conductivity_liquid": conductivity}))
    thin = 0.2 * 0.5 * np.sqrt(np.pi)  # of the layer, per latent heat: start - melting times lambda sqrt(pi)
    limit = 1.0 - erf(0.5) * np.exp(0.25) * (0.5 * np.sqrt(np.pi) + thin)
    assert solution.plane == pytest.approx(limit, abs=2.0 * conductivity)
    front = float(solution.front(0.05))
    T = solution.temperature(front * np.array([0.0, 1.0, 1.0 + 20.0 * conductivity, 2.0]), 0.05)
    assert T[[0, 1, 3]] == pytest.approx([solution.plane, 1.0, 1.2])
    assert 1.0 < T[2] < 1.2


def test_published_numbers():
    """Otherwise a misprint of the paper, or one of ours, would be in every comparison."""
    assert Neumann(0.5, 1.0, 1.2, **ONE).plane == pytest.approx(0.190602422789, abs=1e-11)
    assert Neumann(0.5, 1.0, 1.2, **ONE).front(0.0568047337278) == pytest.approx(0.23833743669)
    weak, strong = (LineSink(similarity, 273.15, 283.15, **WATER) for similarity in (0.15, 0.20))
    assert weak.relative_strength == pytest.approx(0.033651, abs=5e-7)
    assert strong.relative_strength == pytest.approx(0.055928, abs=5e-7)
    assert weak.front(475000.0) == pytest.approx(0.2121, abs=5e-5)
    assert strong.front(2.0 / 3.0 * 475000.0) == pytest.approx(0.2309, abs=5e-5)
