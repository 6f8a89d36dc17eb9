"""Walls whose numbers change along them and with time, against independent finite differences."""

import numpy as np
import pytest
from scipy.linalg import eigh_tridiagonal
from scipy.sparse import diags, eye, kron
from scipy.sparse.linalg import spsolve

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import (
    Alloy,
    BackwardEuler,
    Conduction,
    CrankNicolson,
    Explicit,
    GradientWalls,
    HeatWall,
    Liquidus,
    Profile,
)

CONDUCTIVITY, HEAT = 10.0, 1.0e6  # [W/(m K)], [J/(m^3 K)]
STUFF = solid_material("stuff", density=1000.0, heat_capacity=1000.0, conductivity=CONDUCTIVITY)
X, Y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
LENGTH = 0.1  # [m], of the slab along x
EXPLICIT = Explicit()


def body(
    device: str,
    size: tuple[float, ...],
    walls: list[HeatWall],
    spacing: float,
    start: float = 300.0,
    origin: np.ndarray | float = 0.0,
    interval: float = 1e9,
    integrator: Explicit | BackwardEuler | CrankNicolson = EXPLICIT,
) -> tuple[Simulation, Conduction]:
    """A box of one temperature whose corner is at ``origin`` (3,)."""
    particles = Particles()
    particles.add(lattice((0.0,) * len(size), size, spacing) + origin, Role.FREE, temperature=start)
    conduction = Conduction(longest_interval=interval, walls=walls, integrator=integrator)
    model = Model(len(size), spacing, (STUFF,), (conduction,), gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device), model, particles), conduction


def content(simulation: Simulation) -> float:
    """Heat of the body [J], with what single precision has lost of it."""
    s = simulation.state
    return float(np.sum(s.numpy("mass") * (s.numpy("enthalpy").astype(float) - s.numpy("enthalpy_carry"))))


def sides(size: tuple[float, ...], first: int = 1) -> list[HeatWall]:
    """Insulation of a box on its faces along the axes from the ``first`` on."""
    faces = [(np.eye(3)[axis], length) for axis, length in enumerate(size) if axis >= first]
    return [wall for n, L in faces for wall in (HeatWall.insulated(n, 0.0), HeatWall.insulated(-n, -L))]


def ramped_slab(x: np.ndarray, conductance: float, at_start: float, rise: float, time: float) -> np.ndarray:
    """Temperature (n,) of a slab of 300 K behind a film at x = 0 with an outside that rises linearly, insulated beyond.

    1200 finite volumes, exact in time: each mode of the discrete operator follows the ramp by itself.
    """
    n = 1200
    dx = LENGTH / n
    link = CONDUCTIVITY / dx
    film = 1.0 / (1.0 / conductance + 0.5 * dx / CONDUCTIVITY)
    diagonal = np.full(n, -2.0 * link)
    diagonal[0], diagonal[-1] = -link - film, -link
    rates, modes = eigh_tridiagonal(diagonal / (HEAT * dx), np.full(n - 1, link) / (HEAT * dx))
    # T = 300 + u; du/dt = A u + b (at_start - 300 + rise t)
    b = modes[0] * film / (HEAT * dx)
    constant = (np.exp(rates * time) - 1.0) / rates
    ramp = (constant - time) / rates
    u = modes @ (b * ((at_start - 300.0) * constant + rise * ramp))
    return 300.0 + np.interp(x, (np.arange(n) + 0.5) * dx, u)


@pytest.mark.parametrize("far", [0.0, 100.0], ids=["here", "far"])
@pytest.mark.parametrize("size", [(LENGTH, 0.06), (LENGTH, 0.05, 0.05)], ids=["2D", "3D"])
def test_an_outside_that_rises(device, size, far):
    """A wall that saw the first number for ever, or one of another time, would not follow the furnace.

    The outside rises by 400 K, the slab by up to 145 K. With 10 rows 2.0 K are left and with 20 rows 0.6 K, those of
    the smoothing error; a lag of one second would be 1 K.
    """
    outside = Profile((300.0, 700.0), times=(0.0, 200.0))
    walls = [HeatWall.film(X, far, 200.0, outside), HeatWall.insulated(-X, -far - LENGTH), *sides(size)]
    for spacing, error in ((0.01, 2.1), (0.005, 0.65)) if len(size) == 2 else ((0.01, 2.1),):
        simulation, _ = body(device, size, walls, spacing, origin=far * X, interval=0.25)
        result = simulation.run(200.0, 200.0)
        exact = ramped_slab(result.positions[:, 0].astype(float) - far, 200.0, 300.0, 2.0, 200.0)
        assert np.ptp(exact) > 130.0
        assert np.abs(result.fields["temperature"] - exact).max() < error


@pytest.mark.parametrize(
    ("integrator", "step", "error"), [(CrankNicolson(), 10.0, 0.7), (BackwardEuler(), 1.0, 0.85)], ids=["CN", "BE"]
)
def test_an_outside_that_rises_under_implicit_steps(device, integrator, step, error):
    """Numbers of the begin alone would make a step of Crank and Nicolson late by half of it, here 5 s or 4 K.

    Of 20 rows the smoothing error is 0.6 K.
    """
    outside = Profile((300.0, 700.0), times=(0.0, 200.0))
    walls = [HeatWall.film(X, 0.0, 200.0, outside), HeatWall.insulated(-X, -LENGTH), *sides((LENGTH, 0.02))]
    simulation, _ = body(device, (LENGTH, 0.02), walls, 0.005, interval=step, integrator=integrator)
    result = simulation.run(200.0, 200.0)
    exact = ramped_slab(result.positions[:, 0].astype(float), 200.0, 300.0, 2.0, 200.0)
    assert simulation.solver.interval == pytest.approx(step)
    assert np.abs(result.fields["temperature"] - exact).max() < error


OUTSIDE = Profile((300.0, 500.0, 350.0), places=(0.0, 0.06, 0.1), along="y")
CONDUCTANCE = Profile((400.0, 100.0), places=(0.02, 0.08), along=(0.0, 1.0, 0.0))
SURFACE = Profile((400.0, 300.0), places=(0.0, 0.1), along="y")
FLUX = Profile.of(lambda x: -2.0e4 * np.sin(np.pi * x / 0.1), np.linspace(0.0, 0.1, 41), "x")
UNEVEN = [
    HeatWall.film(X, 0.0, CONDUCTANCE, OUTSIDE),
    HeatWall.at_temperature(-X, -LENGTH, SURFACE),
    HeatWall.given_flux(Y, 0.0, FLUX),
    HeatWall.insulated(-Y, -LENGTH),
]


def uneven_square(points: np.ndarray) -> np.ndarray:
    """Steady temperature (n,) between the walls ``UNEVEN``, by finite volumes of its own on 160 x 160 cells."""
    n = 160
    dx = LENGTH / n
    s = (np.arange(n) + 0.5) * dx
    chain = diags([np.ones(n - 1), np.r_[-1.0, np.full(n - 2, -2.0), -1.0], np.ones(n - 1)], [-1, 0, 1])
    matrix = CONDUCTIVITY * (kron(chain, eye(n)) + kron(eye(n), chain))  # cell (i, j) at x_i, y_j is row i n + j
    outside = np.interp(s, OUTSIDE.places, OUTSIDE.values)
    film = dx / (1.0 / np.interp(s, CONDUCTANCE.places, CONDUCTANCE.values) + 0.5 * dx / CONDUCTIVITY)
    surface = np.interp(s, SURFACE.places, SURFACE.values)
    loss, gain = np.zeros((n, n)), np.zeros((n, n))
    loss[0], gain[0] = film, film * outside
    loss[-1] += 2.0 * CONDUCTIVITY
    gain[-1] += 2.0 * CONDUCTIVITY * surface
    gain[:, 0] += 2.0e4 * np.sin(np.pi * s / LENGTH) * dx
    field = spsolve((matrix - diags(loss.ravel())).tocsc(), -gain.ravel()).reshape(n, n)
    low = np.clip(((points[:, :2] / dx) - 0.5).astype(int), 0, n - 2)
    share = points[:, :2] / dx - 0.5 - low
    (a, b), (f, g) = low.T, share.T
    return (1 - f) * ((1 - g) * field[a, b] + g * field[a, b + 1]) + f * (
        (1 - g) * field[a + 1, b] + g * field[a + 1, b + 1]
    )


@pytest.mark.parametrize("size", [(LENGTH, LENGTH), (LENGTH, LENGTH, 0.05)], ids=["plane", "space"])
def test_numbers_that_change_along_walls(device, size):
    """A hot end of a furnace would warm the wrong end of the body, or all of it.

    Temperatures differ by 121 K. With 10 rows the root mean square error is 0.56 K and the largest one, in a corner,
    2.4 K; with 20 rows 0.15 K and 1.0 K, with 40 rows 0.05 K and 0.5 K.
    """
    rows = (10, 20) if len(size) == 2 else (10,)
    for count, bound in zip(rows, (0.6, 0.17), strict=False):
        simulation, conduction = body(device, size, [*UNEVEN, *sides(size, 2)], LENGTH / count, 400.0)
        result = simulation.run(6000.0, 6000.0)
        errors = result.fields["temperature"] - uneven_square(result.positions.astype(float))
        assert np.sqrt(np.mean(errors**2)) < bound
        assert np.abs(errors).max() < 2.6
        rates = conduction.rate_to_walls()
        assert abs(rates.sum()) < 1e-4 * rates.max()  # steady


def test_numbers_along_a_wall_far_from_the_origin(device):
    """A profile read at a place that is rounded would be that of another place; here 4e-6 m, of 3.3 K/mm."""
    here, _ = body(device, (LENGTH, LENGTH), UNEVEN, 0.01, 400.0)
    far = 100.0
    outside = Profile(OUTSIDE.values, np.add(OUTSIDE.places, far), "y")
    conductance = Profile(CONDUCTANCE.values, np.add(CONDUCTANCE.places, far), "y")
    walls = [
        HeatWall.film(X, 0.0, conductance, outside),
        HeatWall.at_temperature(-X, -LENGTH, Profile(SURFACE.values, np.add(SURFACE.places, far), "y")),
        HeatWall.given_flux(Y, far, FLUX),
        HeatWall.insulated(-Y, -far - LENGTH),
    ]
    there, _ = body(device, (LENGTH, LENGTH), walls, 0.01, 400.0, origin=far * Y)
    fields = [simulation.run(300.0, 300.0).fields["temperature"] for simulation in (here, there)]
    assert fields[1] == pytest.approx(fields[0], abs=0.05)


@pytest.mark.parametrize("integrator", [EXPLICIT, BackwardEuler(), CrankNicolson()], ids=["explicit", "BE", "CN"])
@pytest.mark.parametrize("size", [(LENGTH, LENGTH), (LENGTH, LENGTH, 0.05)], ids=["2D", "3D"])
def test_what_uneven_walls_take_the_body_loses(device, size, integrator):
    """Images with numbers of their own must take from the body what the ledgers say. Rounding: 1e-6 of the heat."""
    conductance = Profile(((100.0, 800.0), (500.0, 0.0)), (0.0, 0.1), "y", times=(0.0, 60.0))
    walls = [
        HeatWall.film(X, 0.0, conductance, Profile((900.0, 300.0), times=(10.0, 50.0))),
        HeatWall.at_temperature(-X, -LENGTH, Profile(((300.0, 400.0), (700.0, 200.0)), (0.0, 0.1), "y", (0.0, 60.0))),
        HeatWall.given_flux(Y, 0.0, FLUX),
        HeatWall.film(-Y, -LENGTH, 100.0, 900.0),
        *sides(size, 2),
    ]
    simulation, conduction = body(device, size, walls, 0.01, 500.0, interval=5.0, integrator=integrator)
    before = content(simulation)
    simulation.run(60.0, 60.0)
    lost = before - content(simulation)
    assert abs(lost) > 0.003 * before
    assert conduction.heat_to_walls().sum() == pytest.approx(lost, abs=1e-6 * before)


@pytest.mark.parametrize(
    ("integrator", "late"), [(EXPLICIT, 2.0), (BackwardEuler(), 0.0), (CrankNicolson(damped_steps=0), 1.0)]
)
def test_a_step_takes_the_numbers_of_its_time(device, integrator, late):
    """Numbers of another time would be those of another step. A flux is counted as it is prescribed."""
    flux = Profile((0.0, 1.0e4), times=(0.0, 20.0))
    size = (LENGTH, 0.06)
    walls = [HeatWall.given_flux(X, 0.0, flux), HeatWall.insulated(-X, -LENGTH), *sides(size)]
    simulation, conduction = body(device, size, walls, 0.01, interval=2.0, integrator=integrator)
    simulation.run(20.0, 20.0)
    ends = np.arange(2.0, 21.0, 2.0)
    assert simulation.solver.interval == pytest.approx(2.0)
    assert conduction.heat_to_walls()[0] == pytest.approx(0.06 * 2.0 * np.sum(500.0 * (ends - late)), rel=1e-5)


def test_on_the_device_as_on_the_host(device):
    """Both must find the same number at every place and time, beyond the ends of the profile too."""
    rng = np.random.default_rng(2)
    places, times = np.sort(rng.uniform(0.01, 0.09, 7)), (3.0, 5.0, 11.0)
    outside = Profile(rng.uniform(300.0, 900.0, (3, 7)), places, (0.6, 0.8, 0.0), times)
    walls = [HeatWall.film(X, 0.0, 50.0, outside), HeatWall.insulated(-X, -LENGTH)]
    simulation, conduction = body(device, (LENGTH, LENGTH), walls, 0.005, interval=1.0)
    for time in range(1, 14):
        simulation.run(1.0, 1.0)
        expected = outside.at(simulation.state.numpy("position"), time - simulation.solver.interval)
        assert conduction.arrays["wall_outside_at"].numpy()[0] == pytest.approx(expected, rel=1e-5)
        assert np.all(conduction.arrays["wall_conductance_at"].numpy() == [[50.0], [0.0]])


def test_functions_are_sampled():
    """A profile of a function is to have its values at the nodes, and the mean of the two in the middle."""
    both = Profile.of(lambda place, time: 300.0 + 10.0 * place + time, (0.0, 2.0), "y", (0.0, 4.0))
    assert both.at(np.array([[0.0, 1.0, 0.0], [9.0, 9.0, 0.0]]), 2.0) == pytest.approx([312.0, 322.0])
    assert Profile.of(np.sqrt, times=(0.0, 4.0)).at(np.zeros((1, 3)), 2.0) == pytest.approx([1.0])
    assert Profile.of(np.sqrt, (0.0, 4.0), X).at(2.0 * X[None], 0.0) == pytest.approx([1.0])


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Profile((1.0, 2.0)), "Profile: places = .*: must be given, or else times"),
        (lambda: Profile((1.0, 2.0), (0.0, 1.0)), "Profile: along = None: must be given with places"),
        (lambda: Profile((1.0, 2.0), along="x", times=(0.0, 1.0)), "Profile: along = 'x': must be given with places"),
        (lambda: Profile((1.0, 2.0), (0.0, 1.0), "r"), "Profile: along = 'r': must be 'x', 'y', 'z' or a unit vector"),
        (lambda: Profile((1.0, 2.0), (0.0, 1.0), (1.0, 1.0, 0.0)), "Profile: along = .*: must be 'x', 'y', 'z' or a u"),
        (lambda: Profile((1.0, 2.0), (0.0, 0.0), "x"), "Profile: places = .*: must be numbers that rise"),
        (lambda: Profile((1.0, 2.0), times=(1.0, 0.0)), "Profile: times = .*: must be numbers that rise"),
        (lambda: Profile((1.0, 2.0), times="ab"), "Profile: times = 'ab': must be numbers that rise"),
        (lambda: Profile((1.0, np.nan), times=(0.0, 1.0)), "Profile: values = .*: must be finite numbers, 2, one"),
        (lambda: Profile((1.0, 2.0), (0.0, 1.0), "x", (0.0, 1.0, 2.0)), "must be finite numbers, 3 x 2, one for each"),
        (lambda: Profile(((1.0,), (1.0, 2.0)), times=(0.0, 1.0)), "Profile: values = .*: must be finite numbers"),
        (lambda: Profile.of(3.0, times=(0.0, 1.0)), "Profile: function = 3.0: must be a function"),
        (
            lambda: HeatWall.film(X, 0.0, Profile((1.0, -2.0), times=(0.0, 1.0)), 300.0),
            "HeatWall: conductance = Profile.*: its values must be from 0 to 1e[+]30",
        ),
        (
            lambda: HeatWall(X, 0.0, np.inf, 300.0, 0.0, {"flux": Profile((1.0, 2.0), times=(0.0, 1.0))}),
            "HeatWall: flux = Profile.*: none where the temperature",
        ),
        (
            lambda: HeatWall(X, 0.0, 1.0, 300.0, 0.0, {"warmth": Profile((1.0, 2.0), times=(0.0, 1.0))}),
            "HeatWall: profiles = .*: must be Profile by name, one of conductance, outside, flux",
        ),
        (
            lambda: body(
                "cpu",
                (LENGTH, LENGTH),
                [HeatWall.film(X, 0.0, 1.0, Profile((300.0, 400.0), (0.0, 1.0), "z"))],
                0.01,
            ),
            "heat wall 0: the profile of outside is along z, but there are two dimensions",
        ),
        (
            lambda: GradientWalls([HeatWall.film(X, 0.0, 1.0, SURFACE)]),
            "GradientWalls: walls: one has a profile",
        ),
        (
            lambda: Alloy(
                STUFF, 1e5, Liquidus.straight(300.0, 100.0, 250.0), [HeatWall.at_temperature(X, 0.0, SURFACE)]
            ),
            "Alloy: walls = .*: must be of one temperature or insulated; films, fluxes and profiles",
        ),
    ],
)
def test_bad_profiles_are_refused(make, words):
    """One line that names the argument, before anything has run."""
    with pytest.raises(InputError, match=words) as caught:
        make()
    assert "\n" not in str(caught.value)
