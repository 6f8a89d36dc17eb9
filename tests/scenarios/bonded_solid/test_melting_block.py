"""The block beside a lamp."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.scenarios.bonded_solid.melting_block import MeltingBlock
from warpsph.scenarios.bonded_solid.particle_solid import FOOT


def test_it_starts_as_a_close_packed_lattice_at_rest():
    """If it failed, the block would burst before it could settle."""
    case = MeltingBlock(columns=30, rows=20)
    places = case.lattice().places
    distance = np.linalg.norm(places[:, None] - places[None], axis=2)[np.triu_indices(len(places), 1)]
    assert distance.min() == pytest.approx(case.spacing, rel=1e-12)
    inside = np.sum(distance < 1.01 * case.spacing)
    assert inside == 29 * 20 + 19 * (2 * 30 - 1)
    assert np.ptp(places, axis=0) == pytest.approx(case.size, rel=1e-12)


def test_forces_of_ten_thousand_are_those_of_all_pairs(device):
    """If it failed, a large block would not obey the equations that the small solids do."""
    simulation = MeltingBlock(settling=0.0, perturbation=0.05).build(Executor(device))
    simulation.run(0.2, 0.1)
    simulation.solver.neighbours.renew_if_outdated()
    simulation.solver.act("sum_forces")
    x, bond = simulation.state.numpy("precise_position")[:, :2], MeltingBlock().potential
    found = simulation.state.numpy("precise_acceleration")[:, :2]
    exact = np.zeros_like(x)
    for begin in range(0, len(x), 500):
        d = x[begin : begin + 500, None] - x[None]
        r = np.sqrt(np.sum(d**2, axis=2))
        r[r == 0.0] = np.inf
        f = bond.repulsion / r**bond.repulsion_exponent - bond.attraction / r**bond.attraction_exponent
        exact[begin : begin + 500] = np.sum(np.where(r <= bond.cutoff, f / r, 0.0)[:, :, None] * d, axis=1)
    exact[:, 1] -= MeltingBlock().gravity * FOOT
    assert np.abs(found - exact).max() < 1e-12 * np.abs(exact).max()


def test_every_quick_check_passes(device):
    """If it failed, the shadow would be heated, or the lit side stay solid."""
    failed = [check for check in MeltingBlock.verify(lambda case: case.run(device=device), False) if not check.passed]
    assert failed == []


@pytest.mark.slow
def test_every_check_passes():
    """Otherwise `warpsph verify` would fail."""
    failed = [check for check in MeltingBlock.verify(lambda case: case.run(device="cpu"), True) if not check.passed]
    assert failed == []
