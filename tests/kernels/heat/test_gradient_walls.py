"""Walls by the gradient on one side: the published condition, what it is exact for, and what is refused."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.lattice import Lattice
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, GradientWalls, HeatWall

CONDUCTIVITY, SPACING = 10.0, 0.01
STUFF = solid_material("stuff", density=1000.0, heat_capacity=1000.0, conductivity=CONDUCTIVITY)
X, Y = np.eye(3)[:2]


def body(device: str, size: tuple[float, ...], sides: list[HeatWall], temperature, *, support_ratio=2.0, **given):
    """A box from the origin with rows on its faces; ``given`` goes to the conduction."""
    x = lattice([-0.5 * SPACING] * len(size), [length + 0.5 * SPACING for length in size], SPACING)
    particles = Particles()
    particles.add(x, Role.FREE, temperature=temperature(x))
    conduction = Conduction(longest_interval=1e9, smoothing="cubic_spline", support_ratio=support_ratio, **given)
    model = Model(len(size), SPACING, (STUFF,), (conduction, GradientWalls(sides)), gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device), model, particles)


def published_sum(x: np.ndarray, i: int, T: np.ndarray, normal: np.ndarray, support: float, dimension: int) -> float:
    """2 sum V (T_j - T_i) n . grad W of the cubic spline, in double precision, over what it makes of a slope of 1."""
    d = x[i] - x
    r = np.linalg.norm(d, axis=1)
    r[i] = 1.0
    slope = -3.0 * np.where(r < 0.5 * support, 2.0 * support - 3.0 * r, np.maximum(support - r, 0.0) ** 2 / r)
    scale = normalisation("cubic_spline", dimension, support) * SPACING**dimension
    factor = Lattice(dimension, SPACING, support / SPACING).slope("cubic_spline")
    return float(2.0 * scale / factor * np.sum((T - T[i]) * slope * (d @ normal)))


@pytest.mark.parametrize("support_ratio", [2.0, 2.6])
@pytest.mark.parametrize("size", [(0.1, 0.08), (0.08, 0.07, 0.06)], ids=["2D", "3D"])
def test_particles_on_walls_keep_the_published_condition(device, size, support_ratio):
    """A wrong sign, factor or corner would cool the body by another law. Rook, Yildiz & Dost (2007), section 4.2.

    3e-4 K is single precision, and what the sweeps leave where particles on walls see each other; the gradient is of
    some 1000 K/m.
    """
    walls = [HeatWall.film(-X, -size[0], 200.0, 250.0), HeatWall.insulated(-Y, -size[1]), HeatWall.insulated(Y, 0.0)]
    walls.append(HeatWall.given_flux(X, 0.0, 3000.0))
    rng = np.random.default_rng(3)
    noise = lambda x: 300.0 + 200.0 * x[:, 0] + rng.uniform(0.0, 5.0, len(x))  # noqa: E731
    simulation = body(device, size, walls, noise, support_ratio=support_ratio)
    simulation.prepare()
    for _ in range(4):  # more sweeps, for the corners
        simulation.solver.act("find_temperature")
    state = simulation.snapshot()
    x, T = state["position"].astype(float), state["temperature"].astype(float)
    on = np.array([np.abs(wall.height(x)) < 1e-3 * SPACING for wall in walls])
    assert np.all((on.any(axis=0)) == (state["held"] != 0))
    for i in np.flatnonzero(on.any(axis=0)):
        mine = [wall for wall, there in zip(walls, on[:, i], strict=True) if there]
        gradient = sum(published_sum(x, i, T, np.asarray(w.normal), support_ratio * SPACING, len(size)) for w in mine)
        leaves = sum(w.conductance * (T[i] - w.outside) + w.flux for w in mine)
        assert gradient == pytest.approx(leaves / CONDUCTIVITY, abs=3e-4 / SPACING)


@pytest.mark.parametrize("exact", [True, False], ids=["exact", "published"])
def test_a_linear_profile_is_continued_up_to_what_the_lattice_makes_of_it(device, exact):
    """The factor 2 is exact on a straight row: the temperature on the wall is the profile's, times the lattice's."""
    flux = 1000.0 * CONDUCTIVITY
    walls = [HeatWall.given_flux(X, 0.0, flux)]
    linear = lambda x: 300.0 + 1000.0 * x[:, 0]  # noqa: E731
    simulation = body(device, (0.1, 0.1), walls, linear, exact_on_lattice=exact)
    simulation.prepare()
    state = simulation.snapshot()
    row = (state["held"] != 0) & (np.abs(state["position"][:, 1] - 0.05) < 0.03)
    factor = 1.0 if exact else Lattice(2, SPACING, 2.0).slope("cubic_spline")
    assert state["temperature"][row] == pytest.approx(310.0 - 1000.0 * SPACING / factor, abs=1e-4)


def test_heat_that_reaches_the_walls_is_counted(device):
    """Heat would be lost, or found, at the particles on walls, which have none of their own."""
    walls = [HeatWall.film(-X, -0.1, 500.0, 250.0), HeatWall.insulated(X, 0.0)]
    simulation = body(device, (0.1, 0.1), walls, lambda x: 300.0)
    simulation.prepare()

    def heat() -> float:
        s = simulation.snapshot()
        return float(np.sum((s["mass"].astype(float) * s["enthalpy"])[s["held"] == 0]))

    before = heat()
    simulation.run(50.0, 50.0)
    s = simulation.snapshot()
    assert before - heat() == pytest.approx(s["heat_held"].sum(), rel=1e-4)
    assert s["heat_held"].sum() > 1e-3 * before
    surface = s["held"] != 0
    assert s["enthalpy"][surface] == pytest.approx(1000.0 * s["temperature"][surface], rel=1e-6)


def test_wrong_input_is_refused_in_one_line(device):
    """A row that is missing, or a second kind of wall beside it, would give a wrong flux without a word."""
    film = HeatWall.film(X, 0.0, 100.0, 300.0)
    with pytest.raises(InputError, match="one gives the temperature"):
        GradientWalls([HeatWall.at_temperature(X, 0.0, 300.0)])
    with pytest.raises(InputError, match="a tuple of one HeatWall or more"):
        GradientWalls([])
    with pytest.raises(InputError, match="no particle stands on wall 1"):
        body(device, (0.1, 0.1), [film, HeatWall.insulated(Y, -0.005)], lambda x: 300.0)
    with pytest.raises(InputError, match="walls that meet are all of one kind"):
        body(device, (0.1, 0.1), [film], lambda x: 300.0, walls=[HeatWall.insulated(Y, 0.0)])
