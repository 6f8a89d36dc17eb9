"""The linear system of conduction says what the explicit sums say, pair by pair, wall by wall."""

from itertools import combinations

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import melting_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import BackwardEuler, Conduction, Explicit, HeatWall, PhaseChange, cut_cells

SPACING = 0.01
STUFF = solid_material("stuff", density=1000.0, heat_capacity=1000.0, conductivity=10.0)
COPPER = solid_material("copper", density=8900.0, heat_capacity=390.0, conductivity=400.0)
MELT = melting_material(
    "melt",
    density=7000.0,
    heat_capacity=700.0,
    latent_heat=2.5e5,
    solidus=350.0,
    liquidus=350.0,
    conductivity_solid=30.0,
    conductivity_liquid=10.0,
    viscosity=0.0,
    source="none",
)
KINDS = {
    "temperature": lambda n, at: HeatWall.at_temperature(n, at, 280.0),
    "film": lambda n, at: HeatWall.film(n, at, 700.0, 500.0),
    "soft film": lambda n, at: HeatWall.film(n, at, 30.0, 200.0),
    "flux": lambda n, at: HeatWall.given_flux(n, at, 2e4),
    "insulated": HeatWall.insulated,
}
PAIRS = [*combinations(KINDS, 2), *((kind, kind) for kind in KINDS)]


def short_step(device, integrator, walls, dimension, smoothing, sharp, materials):
    """Heat (n,) [W] that each particle gains, and (walls,) that walls take, in a step too short to change anything."""
    interval = 1e-7
    x = lattice([0.0] * dimension, [0.08] * dimension, SPACING)
    rng = np.random.default_rng(3)
    particles = Particles()
    half = x[:, 0] > 0.04 if len(materials) > 1 else np.zeros(len(x), bool)
    for index, chosen in enumerate((~half, half)[: len(materials)]):
        T = rng.uniform(300.0, 400.0, chosen.sum())
        if materials[index] is MELT:
            T[::3] = 350.0
        volume = cut_cells(x[chosen], walls, SPACING, dimension)
        particles.add(x[chosen], Role.FREE, material=materials[index].name, temperature=T, volume=volume)
    conduction = Conduction(
        {("stuff", "copper"): 3e3} if len(materials) > 1 else {},
        longest_interval=interval,
        walls=walls,
        smoothing=smoothing,
        sharp_fronts=sharp,
        integrator=integrator,
    )
    model = Model(dimension, SPACING, materials, (conduction, PhaseChange()), gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor(device), model, particles)
    simulation.prepare()
    state, solver = simulation.state, simulation.solver
    if materials[0] is MELT:  # a part of the latent heat, another one in each of them
        h = state.numpy("enthalpy")
        at_front = state.numpy("temperature") == 350.0
        h[at_front] = h[at_front].min() - 2.5e5 * rng.uniform(0.0, 1.0, at_front.sum())
        state.enthalpy.assign(h)
        solver.act("find_temperature")
    solver.set_steps(interval, interval)
    solver.act("sum_heat")
    if isinstance(integrator, Explicit):
        return state.numpy("heat_rate"), conduction.rate_to_walls()
    before = state.numpy("enthalpy").astype(float) - state.numpy("enthalpy_carry")
    solver.act("add_heat")
    gained = state.numpy("enthalpy").astype(float) - state.numpy("enthalpy_carry") - before
    return gained * state.numpy("mass") / interval, conduction.heat_to_walls() / interval


@pytest.mark.parametrize("smoothing", ["poly6", "cubic_spline"])
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("kinds", PAIRS, ids="-".join)
def test_rows_give_the_heat_of_the_sums(device, kinds, dimension, smoothing):
    """In a corner of two walls, in space of three, with a film between two materials. Rounding of single precision."""
    if dimension == 3 and smoothing == "poly6":
        pytest.skip("the images are the same code for both smoothing kernels")
    one, other = (KINDS[kind] for kind in kinds)
    walls = [one((1.0, 0.0, 0.0), 0.0), other((0.0, 1.0, 0.0), 0.0)]
    if dimension == 3:
        walls.append(one((0.0, 0.0, -1.0), -0.08))
    given = (walls, dimension, smoothing, False, (STUFF, COPPER))
    rate, taken = short_step(device, Explicit(), *given)
    implicit_rate, implicit_taken = short_step(device, BackwardEuler(tolerance=1e-9), *given)
    assert np.abs(implicit_rate - rate).max() < 2e-5 * np.abs(rate).max()
    assert implicit_taken == pytest.approx(taken, rel=2e-5, abs=1e-5 * float(np.abs(rate).max()))


@pytest.mark.parametrize("sharp", [False, True], ids=["curve", "front"])
def test_rows_of_particles_that_freeze(device, sharp):
    """Conductivities of the solid fraction, or another one on each side of the front."""
    walls = [KINDS["temperature"]((1.0, 0.0, 0.0), 0.0), KINDS["insulated"]((0.0, 1.0, 0.0), 0.0)]
    given = (walls, 2, "cubic_spline", sharp, (MELT,))
    rate, taken = short_step(device, Explicit(), *given)
    implicit_rate, implicit_taken = short_step(device, BackwardEuler(tolerance=1e-9), *given)
    assert np.abs(implicit_rate - rate).max() < 2e-4 * np.abs(rate).max()
    assert implicit_taken == pytest.approx(taken, rel=2e-4)
