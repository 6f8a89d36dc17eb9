"""Particles with a front in them: exact for a straight front, beside a wall too, and no heat lost."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import melting_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, HeatWall, WholePhases, cut_cells

SPACING, MELTING, ROWS = 0.01, 273.15, 8
K_ICE, K_WATER = 2.2, 0.591
WATER = melting_material(
    "water", density=1000.0, heat_capacity=2090.0, heat_capacity_liquid=4190.0, latent_heat=3.335e5, solidus=MELTING,
    liquidus=MELTING, conductivity_solid=K_ICE, conductivity_liquid=K_WATER, viscosity=0.0, source="round numbers",
)  # fmt: skip
WIDTH = 5 * SPACING
ALONG, UP = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


def strip(device: str, walls, enthalpy, *, lower: float = 0.0, **conduction) -> Simulation:
    """Rows across y, the first half a spacing above ``lower``, with the enthalpy at their heights."""
    x = lattice((0.0, lower), (WIDTH, lower + ROWS * SPACING), SPACING)
    walls = (*walls, HeatWall.insulated(ALONG, 0.0), HeatWall.insulated(-ALONG, -WIDTH))
    particles = Particles()
    particles.add(x, Role.FREE, enthalpy=enthalpy(x[:, 1]), volume=cut_cells(x, walls, SPACING, 2))
    # With h of one spacing a row conducts to the next rows only, so a straight front must come out exactly.
    term = Conduction(
        longest_interval=1e9, walls=walls, smoothing="cubic_spline", support_ratio=2.0, sharp_fronts=True, **conduction
    )
    return Simulation(Executor(device), Model(2, SPACING, (WATER,), (term,), gravity=(0.0, 0.0, 0.0)), particles)


def profile(front: float, cold_flux: float, warm_flux: float, row: int, share: float):
    """Enthalpy of straight profiles on both sides of a front; ``share`` of the given row has frozen."""
    frozen, molten = WATER.melting_enthalpies

    def enthalpy(y):
        ice = frozen + 2090.0 * cold_flux / K_ICE * (y - front)
        water = molten + 4190.0 * warm_flux / K_WATER * (y - front)
        here = np.round(y / SPACING - 0.5).astype(int)
        return np.where(here == row, molten + share * (frozen - molten), np.where(here < row, ice, water))

    return enthalpy


@pytest.mark.parametrize("share", [0.05, 0.3, 0.5, 0.8, 0.95])
@pytest.mark.parametrize("row", [0, 3], ids=["at the wall", "inside"])
def test_a_straight_front_takes_the_exact_heat(device, row, share):
    """A front that seemed to lie elsewhere in its row would let too much heat pass, or too little.

    The thinnest layer, 1e-3 spacings, is the error.
    """
    front, cold_flux, warm_flux = (row + share) * SPACING, 300.0, 100.0
    walls = (
        HeatWall.at_temperature(UP, 0.0, MELTING - cold_flux / K_ICE * front),
        HeatWall.given_flux(-UP, -ROWS * SPACING, -warm_flux),
    )
    simulation = strip(device, walls, profile(front, cold_flux, warm_flux, row, share))
    simulation.prepare()
    simulation.solver.act("sum_heat")
    rows = np.round(simulation.state.numpy("position")[:, 1] / SPACING - 0.5).astype(int)
    rate = np.array([simulation.state.numpy("heat_rate")[rows == k].sum() for k in range(ROWS)]) / WIDTH
    expected = np.zeros(ROWS)
    expected[row] = warm_flux - cold_flux
    assert rate == pytest.approx(expected, abs=0.012 * cold_flux)
    taken = simulation.model.the(Conduction).rate_to_walls()[0] / WIDTH
    assert taken == pytest.approx(cold_flux, rel=0.012)


def test_no_heat_is_lost(device):
    """The two of a pair must see the same conductivity, whichever of them asks."""
    rng = np.random.default_rng(7)
    frozen, molten = WATER.melting_enthalpies
    random = lambda y: rng.uniform(frozen - 2e4, molten + 2e4, len(y))  # noqa: E731
    walls = (HeatWall.insulated(UP, 0.0), HeatWall.insulated(-UP, -ROWS * SPACING))
    simulation = strip(device, walls, random)
    before = simulation.snapshot()["enthalpy"].astype(float).sum()
    rates = simulation.state
    simulation.prepare()
    simulation.solver.act("sum_heat")
    assert abs(rates.numpy("heat_rate").sum()) < 1e-5 * np.abs(rates.numpy("heat_rate")).sum()
    result = simulation.run(1e5, 1e5)
    assert result.fields["enthalpy"].astype(float).sum() == pytest.approx(before, rel=1e-6)


def test_one_conductivity_or_two(device):
    """Whole phases would be written and then not be used."""
    term = Conduction(sharp_fronts=True)
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.1, 0.1), SPACING), Role.FREE)
    with pytest.raises(InputError, match="exclude each other"):
        Simulation(Executor(device), Model(2, SPACING, (WATER,), (term, WholePhases())), particles)
