"""Elastic bodies of many shapes: turned, spun, far from the origin, beside each other, and heavier than the fluid."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import fluid_material, solid_material, thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.scenarios import Cantilever
from warpsph.terms import Conduction, Contact, Elasticity, Fluid, PhaseChange, SummedDensity

DX, E, RHO = 0.01, 1.0e6, 1000.0
SHAPES = ("square", "L", "strip", "ball")
BOX = {"lower": (-1.0,) * 3, "upper": (1.0,) * 3}


def shape(name: str, dimension: int) -> np.ndarray:
    """Particles (n, 3) [m] of a body around the origin, with right-angled and re-entrant corners, thin, or round."""
    half = (12 if dimension == 2 else 6) / 2 * DX
    x = lattice((-half,) * dimension, (half,) * dimension, DX)
    if name == "L":
        x = x[(x[:, 0] < 0.0) | (x[:, 1] < 0.0)]
    if name == "strip":
        x = x[np.abs(x[:, 1]) < 1.1 * DX]
    if name == "ball":
        x = x[np.linalg.norm(x, axis=1) < half - 0.4 * DX]
    return x


def body(device: str, x: np.ndarray, dimension: int, support: float, **fields) -> Simulation:
    particles = Particles()
    particles.add(x, Role.FREE, phase=Phase.SOLID, **fields)
    rubber = solid_material("rubber", RHO)
    model = Model(dimension, DX, (rubber,), (Elasticity(E, 0.3),), support, gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device), model, particles, **BOX)


def turned(x: np.ndarray, angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return x @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


@pytest.mark.parametrize("support", [1.5, 2.6])
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", SHAPES)
def test_a_turned_body_feels_no_force(device, name, dimension, support):
    """If it failed, a corner, an edge or a thin part would resist a turn of the body."""
    x = shape(name, dimension)
    for angle in (1.0, 3.0):
        simulation = body(device, x, dimension, support)
        simulation.prepare()
        order = simulation.state.numpy("id")
        simulation.state.position.assign(turned(x, angle)[order])
        simulation.state.outdated.fill_(1)
        simulation.prepare()
        state = simulation.snapshot()
        force = np.linalg.norm(state["acceleration"] * state["mass"][:, None], axis=1)
        assert force.max() < 1e-4 * E * DX ** (dimension - 1)


@pytest.mark.parametrize("support", [1.5, 2.6])
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", SHAPES)
def test_a_spun_body_keeps_spinning(name, dimension, support):
    """If it failed, a square would turn by 64 degrees and swing back like a torsion pendulum."""
    x = shape(name, dimension)
    spin = 20.0 * np.stack([-x[:, 1], x[:, 0], np.zeros(len(x))], axis=1)
    result = body("cpu", x, dimension, support, velocity=spin).run(0.16, 0.16)
    mass, u, y = result.fields["mass"].astype(float), result.fields["velocity"], result.positions.astype(float)
    before = np.sum(mass * (x[:, 0] * spin[:, 1] - x[:, 1] * spin[:, 0]))
    after = np.sum(mass * (y[:, 0] * u[:, 1] - y[:, 1] * u[:, 0]))
    assert after == pytest.approx(before, rel=1e-5)
    start, end = x - x.mean(axis=0), y - y.mean(axis=0)
    left, _, right = np.linalg.svd(end.T @ start)
    rotation = left @ np.diag([1.0, 1.0, np.linalg.det(left @ right)]) @ right
    assert np.abs(end - start @ rotation.T).max() < 0.01 * DX


@pytest.mark.parametrize("place", [0.0, 2.0, 100.0])
def test_a_plate_swings_everywhere_as_at_the_origin(place):
    """If it failed, rounding of positions would be strain, and two metres from the origin energy would grow by half."""
    case = Cantilever(layers=6, duration=0.1)
    simulation = case.build(Executor("cpu"))
    simulation.state.position.assign(simulation.state.numpy("position").astype(float) + np.array([place, place, 0.0]))
    result = simulation.run(case.duration, 0.01)
    energy = result.diagnostics["kinetic_energy"] + result.diagnostics["strain_energy"]
    assert np.abs(energy / energy[0] - 1.0).max() < 2e-3


def two_squares(gap: float, contact: bool = True) -> Simulation:
    """Two squares that start ``gap`` spacings apart and fly away from each other."""
    particles = Particles()
    square = lattice((0.0, 0.0), (8 * DX, 8 * DX), DX)
    for number, side in ((0, -1.0), (1, 1.0)):
        shift = 0.5 * (gap - 1.0) if side > 0 else -0.5 * (gap - 1.0) - 8.0
        x = square + np.array([shift * DX, 0.0, 0.0])
        particles.add(x, Role.FREE, phase=Phase.SOLID, body=number, velocity=(0.5 * side, 0.0, 0.0))
    terms = (Elasticity(E, 0.3), Contact()) if contact else (Elasticity(E, 0.3),)
    model = Model(2, DX, (solid_material("rubber", RHO),), terms, gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor("cpu", 1), model, particles, **BOX)


@pytest.mark.parametrize("gap", [1.0, 2.0, 2.55, 2.65])
def test_bodies_that_start_close_are_not_bonded(gap):
    """If it failed, two bodies closer than a support at the start would be glued together for ever."""
    simulation = two_squares(gap)
    simulation.prepare()
    bonds, of_body = simulation.state.bonds, simulation.state.numpy("body")
    count, partner = bonds.count.numpy(), bonds.partner.numpy().reshape(-1, bonds.capacity)
    assert all(of_body[j] == of_body[i] for i in range(len(count)) for j in partner[i, : count[i]])
    result = simulation.run(0.1, 0.1)
    speed = [result.fields["velocity"][result.fields["body"] == k, 0].mean() for k in (0, 1)]
    assert speed[1] == pytest.approx(-speed[0], rel=1e-3)
    assert speed[1] >= 0.499  # and faster where contact has pushed


def test_melt_that_freezes_joins_the_body_that_it_touches():
    """If it failed, a shell that grows would be a heap of particles that belong to nobody."""
    particles = Particles()
    x = lattice((0.0, 0.0), (20 * DX, 4 * DX), DX)
    left, right = x[:, 0] < 7 * DX, x[:, 0] > 13 * DX
    for number, mine in ((3, left), (5, right)):
        particles.add(x[mine], Role.FREE, phase=Phase.SOLID, temperature=1000.0, body=number)
    particles.add(x[~left & ~right], Role.FREE, temperature=1900.0)
    terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
    model = Model(2, DX, (thesis_steel(),), terms, gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor("cpu", 1), model, particles)
    simulation.prepare()
    state = simulation.state
    middle = np.abs(state.numpy("position")[:, 0] - 10 * DX) < 3 * DX
    state.solid_fraction.assign(np.where(middle & (state.numpy("position")[:, 0] > 9 * DX), 0.0, 1.0))
    simulation.solver.act("change_phases")
    froze = middle & (state.numpy("phase") == Phase.SOLID)
    near = froze & (state.numpy("position")[:, 0] < 8 * DX)
    assert np.sum(near) == 4
    assert np.all(state.numpy("body")[near] == 3)


def beam(density: float) -> tuple[np.ndarray, np.ndarray]:
    """Mass and force of the particles of a solid of some density in a fluid of 1000 kg/m^3, in the order of ids."""
    particles = Particles()
    x = lattice((0.0, 0.0), (16 * DX, 16 * DX), DX)
    solid = (np.abs(x[:, 1] - 8 * DX) < 2 * DX) & (np.abs(x[:, 0] - 8 * DX) < 5 * DX)
    particles.add(x[~solid], Role.FREE, "water")
    particles.add(x[solid], Role.FREE, "plate", phase=Phase.SOLID)
    terms = (Fluid(RHO, 20.0), SummedDensity(), Elasticity(E, 0.3))
    materials = (fluid_material("water", RHO, 1.0), solid_material("plate", density))
    model = Model(2, DX, materials, terms, gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor("cpu", 1), model, particles)
    simulation.prepare()
    state = simulation.snapshot()
    plate = state["material"] == 1
    assert np.allclose(state["body_volume"][plate], DX**2, rtol=1e-6)
    return state["mass"][plate], state["acceleration"][plate] * state["mass"][plate][:, None]


def test_a_solid_in_a_fluid_has_its_own_mass():
    """If it failed, a plate of aluminium under water would weigh and bend as if it were water."""
    light, force_on_light = beam(RHO * (1.0 + 1e-3))
    heavy, force_on_heavy = beam(2700.0)
    assert np.allclose(heavy, 2700.0 * DX**2, rtol=1e-6)
    assert np.allclose(heavy / light, 2.7 / 1.001, rtol=1e-6)
    assert np.allclose(force_on_heavy, force_on_light, atol=1e-5 * np.abs(force_on_light).max())


@pytest.mark.parametrize("melts", [False, True])
def test_a_fluid_of_another_density_is_refused(melts):
    """If it failed, a melt would silently have the mass of the reference fluid."""
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE, phase=Phase.SOLID if melts else Phase.LIQUID)
    terms = (Fluid(RHO, 20.0), SummedDensity(), *((Conduction(), PhaseChange()) if melts else ()))
    with pytest.raises(InputError, match=r"oil of 1100 kg/m.3 flows or can melt.*one density of fluids, 1000"):
        Simulation(Executor("cpu", 1), Model(2, DX, (fluid_material("oil", 1100.0),), terms), particles)


def test_bonds_have_a_support_of_their_own():
    """If it failed, a thin solid in a fluid would be as soft as the fluid's wide support makes it."""
    particles = Particles()
    x = lattice((0.0, 0.0), (10 * DX, 10 * DX), DX)
    particles.add(x, Role.FREE, phase=Phase.SOLID)
    terms = (Fluid(RHO, 20.0), SummedDensity(), Elasticity(E, 0.3, support_ratio=1.5))
    simulation = Simulation(Executor("cpu", 1), Model(2, DX, (solid_material("rubber", RHO),), terms, 2.6), particles)
    simulation.prepare()
    inside = np.abs(simulation.state.numpy("position")[:, :2] - 5 * DX).max(axis=1) < 2 * DX
    assert np.all(simulation.state.bonds.count.numpy()[inside] == 8)
    assert np.all(simulation.state.neighbours.count.numpy()[inside] > 20)
