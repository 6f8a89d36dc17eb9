"""Freezing and melting: the switch, and the bonds that come and go with it."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, PhaseChange, SummedDensity

SPACING = 0.01
STEEL = thesis_steel()


def block(device: str, dimension: int) -> Simulation:
    particles = Particles()
    x = lattice((0.0,) * dimension, (8 * SPACING,) * dimension, SPACING)
    particles.add(x, Role.FREE, temperature=STEEL.liquidus + 100.0)
    model = Model(
        dimension,
        SPACING,
        (STEEL,),
        (
            Fluid(2100.0, 10.0),
            SummedDensity(),
            Conduction(),
            PhaseChange(freeze_above=0.55, melt_below=0.45),
            Elasticity(1e5, 0.3),
        ),
        gravity=(0.0, 0.0, 0.0),
    )
    simulation = Simulation(Executor(device), model, particles)
    simulation.prepare()
    return simulation


def set_solid(simulation: Simulation, fraction: np.ndarray) -> None:
    simulation.state.solid_fraction.assign(fraction.astype(np.float32))
    simulation.solver.act("change_phases")


def bonds_of(simulation: Simulation) -> dict[tuple[int, int], np.ndarray]:
    bonds = simulation.state.bonds
    count = bonds.count.numpy()
    partner = bonds.partner.numpy().reshape(len(count), -1)
    separation = bonds.separation.numpy().reshape(len(count), -1, 3)
    return {(i, int(partner[i, b])): separation[i, b] for i in range(len(count)) for b in range(count[i])}


def marked_pairs(simulation: Simulation) -> set[tuple[int, int]]:
    rows = simulation.state.neighbours
    entry, count = rows.entry.numpy(), rows.count.numpy()
    return {
        (i, -1 - int(e))
        for i in range(len(count))
        for k in range(count[i])
        if (e := entry[i * rows.row_stride + k * rows.entry_stride]) < 0
    }


@pytest.mark.parametrize("dimension", [2, 3])
def test_bonds_join_solids_and_only_solids(device, dimension):
    """A missing bond is a hole in the shell; one to the melt would carry it along."""
    simulation = block(device, dimension)
    x = simulation.state.numpy("position")
    solid = x[:, 0] < 4 * SPACING
    set_solid(simulation, solid.astype(float))
    distance = np.linalg.norm(x[:, None] - x[None, :], axis=2)
    near = (distance < simulation.model.support) & (distance > 0) & solid[:, None] & solid[None, :]
    bonds = bonds_of(simulation)
    assert set(bonds) == {(int(i), int(j)) for i, j in zip(*np.nonzero(near), strict=True)}
    assert all(np.allclose(vector, x[i] - x[j]) for (i, j), vector in bonds.items())
    assert marked_pairs(simulation) == set(bonds)


def test_melting_cuts_bonds_and_freezing_again_forgets_the_old_shape(device):
    """A remolten particle that came back to its old bonds would be pulled to where it once was."""
    simulation = block(device, 2)
    n = simulation.state.count
    set_solid(simulation, np.ones(n))
    melt = 27
    fraction = np.ones(n)
    fraction[melt] = 0.0
    set_solid(simulation, fraction)
    assert not [pair for pair in bonds_of(simulation) if melt in pair]
    assert simulation.state.numpy("phase")[melt] == Phase.LIQUID
    x = simulation.state.numpy("position")
    x[melt] += [0.2 * SPACING, 0.1 * SPACING, 0.0]
    simulation.state.position.assign(x)
    set_solid(simulation, np.ones(n))
    bonds = bonds_of(simulation)
    mine = [pair for pair in bonds if melt in pair]
    assert len(mine) > 20
    assert all(np.allclose(bonds[i, j], x[i] - x[j], atol=1e-7) for i, j in mine)


def test_hysteresis(device):
    """Without it a particle at the threshold would make and cut its bonds at every step."""
    simulation = block(device, 2)
    n = simulation.state.count
    seen = []
    for fraction in (0.5, 0.56, 0.5, 0.46, 0.44, 0.5, 0.0):
        set_solid(simulation, np.full(n, fraction))
        seen.append(Phase(int(simulation.state.numpy("phase")[0])))
    M, S, L = Phase.MUSHY, Phase.SOLID, Phase.LIQUID
    assert seen == [M, S, S, S, M, M, L]


def test_bonds_survive_sorting(device):
    """Bonds that did not follow their particles would tie strangers together."""
    simulation = block(device, 2)
    n = simulation.state.count
    set_solid(simulation, np.ones(n))
    ids = simulation.state.numpy("id")
    before = {(ids[i], ids[j]): tuple(v) for (i, j), v in bonds_of(simulation).items()}
    x = simulation.state.numpy("position")
    simulation.state.position.assign(x[:, [1, 0, 2]] * [-1.0, 1.0, 1.0] + [9 * SPACING, 0.0, 0.0])
    simulation.state.outdated.fill_(1)
    simulation.solver.neighbours.renew_if_outdated()
    ids_after = simulation.state.numpy("id")
    assert not np.array_equal(ids, ids_after)
    after = {(ids_after[i], ids_after[j]): tuple(v) for (i, j), v in bonds_of(simulation).items()}
    assert before == after
    assert marked_pairs(simulation) == set(bonds_of(simulation))
