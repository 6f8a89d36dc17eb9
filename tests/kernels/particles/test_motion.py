"""Motion in double precision, forces of pairs, the floor and the source."""

from dataclasses import replace

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import DrivingSource, Elasticity, Floor, PairPotential, PreciseMotion

POTENTIAL = PairPotential(2500.0, 2900.0, 4, 6, cutoff=1.5)
DT = 1e-4


def simulation(
    device: str, places, *terms, velocities=(0.0, 0.0, 0.0), gravity=(0.0, 0.0, 0.0), dimension=2, mass=1.0, dt=DT
):
    """Particles of 1 kg, or another ``mass``, with the bond of the triangle."""
    model = Model(
        dimension, 1.077, (solid_material("particles", 1.0),), (PreciseMotion(), *terms), 1.2, gravity=gravity
    )
    particles = Particles()
    particles.add(np.asarray(places, float), Role.FREE, velocity=np.asarray(velocities, float), mass=mass)
    return Simulation(Executor(device, threads=None if device != "cpu" else 1), model, particles, dt=dt)


def forces_of_all_pairs(places: np.ndarray, potential: PairPotential) -> np.ndarray:
    """Sums (n, 3) of (2.5) to (2.7) over all pairs, by NumPy."""
    d = places[:, None] - places[None]
    r = np.linalg.norm(d, axis=2) + np.diag(np.full(len(places), np.inf))
    f = -potential.attraction / r**potential.attraction_exponent
    f += potential.repulsion / r**potential.repulsion_exponent
    return np.sum(np.where(r <= potential.cutoff, f / r, 0.0)[:, :, None] * d, axis=1)


def by_id(sim: Simulation, name: str) -> np.ndarray:
    return sim.state.numpy(name)[np.argsort(sim.state.numpy("id"))]


@pytest.mark.parametrize("dimension", [2, 3])
def test_listed_pairs_give_the_forces_of_all_pairs(dimension, device):
    """If it failed, a pair would be missed or counted twice where particles have moved and been sorted."""
    axes = [np.arange(14 if dimension == 2 else 6) * 1.05] * dimension
    grid = np.stack([*(a.ravel() for a in np.meshgrid(*axes))], axis=1)
    places = np.zeros((len(grid), 3))
    places[:, :dimension] = grid + np.random.default_rng(1).uniform(-0.1, 0.1, grid.shape)
    sim = simulation(device, places, POTENTIAL, dimension=dimension)
    for duration in (DT, 1000 * DT):
        sim.run(duration, duration)
        sim.solver.neighbours.renew_if_outdated()
        sim.solver.act("sum_forces")
        exact = forces_of_all_pairs(by_id(sim, "precise_position"), POTENTIAL)
        found = by_id(sim, "precise_acceleration")
        assert np.abs(found - exact).max() < 1e-12 * np.abs(exact).max()
    assert sim.state.renewals.numpy()[0] > 1


def test_a_pair_swings_as_leap_frog_says(device):
    """If it failed, the step would not be (2.1) to (2.3): half a step of force at first, whole steps then."""
    x, v = 1.2, 0.0
    sim = simulation(device, [(0.0, 0.0, 0.0), (1.2, 0.0, 0.0)], POTENTIAL)
    for k in range(1000):
        force = -2500.0 / x**4 + 2900.0 / x**6
        v += (0.5 if k == 0 else 1.0) * DT * 2.0 * force
        x += DT * v
    sim.run(1000 * DT, 1000 * DT)
    places = by_id(sim, "precise_position")
    assert places[1, 0] - places[0, 0] == pytest.approx(x, rel=1e-12)
    assert np.abs(by_id(sim, "position") - places).max() < 1e-6
    lost = by_id(sim, "position").astype(float) - by_id(sim, "position_carry")
    assert np.abs(lost - places).max() < 1e-13


def test_free_fall_is_exact_to_the_digits_of_double_precision(device):
    """If it failed, something of single precision, gravity or the step, would be in the motion."""
    sim = simulation(device, [(0.0, 9.7536, 0.0)], POTENTIAL, gravity=(0.0, -9.7536, 0.0))
    sim.run(1000 * DT, 100 * DT)
    fallen = 9.7536 - by_id(sim, "precise_position")[0, 1]
    assert fallen == pytest.approx(0.5 * 9.7536 * (1000 * DT) ** 2, rel=1e-12)


def test_the_floor_reflects(device):
    """If it failed, (3.1) and (5.1) would not hold: rest along the floor, and a share of the speed by the place."""
    places = [(-4.0, 0.01, 0.0), (2.0, 0.01, 0.0), (7.0, 0.01, 0.0)]
    floor = Floor(0.1, hot=1.5, slope=0.025, hot_half_width=5.0)
    sim = simulation(device, places, POTENTIAL, floor, velocities=(0.5, -2.0, 0.0))
    sim.run(100 * DT, 100 * DT)
    velocity = by_id(sim, "precise_velocity")
    x = np.array([p[0] for p in places]) + 0.5 * 51 * DT
    share = np.where(np.abs(x) < 5.0, 1.5 - 0.025 * (x + 5.0), 0.1)
    np.testing.assert_allclose(velocity[:, 0], 0.0)
    np.testing.assert_allclose(velocity[:, 1], 2.0 * share, rtol=1e-4)
    assert np.all(by_id(sim, "precise_position")[:, 1] > 0.0)


def test_the_source_drives_away_by_its_schedule(device):
    """If it failed, (4.1) would act beyond its reach, in another direction, or with the strength of another time."""
    places = [(1.0, 0.0, 0.0), (0.0, 20.0, 0.0), (-30.0, 0.0, 0.0)]
    source = DrivingSource((0.0, 0.0, 0.0), 25.0, strengths=(1.0, 3.0), until=(50 * DT, 80 * DT))
    sim = simulation(device, places, POTENTIAL, source)
    sim.run(100 * DT, 10 * DT)
    velocity = by_id(sim, "precise_velocity")
    impulse = (50 * 1.0 + 30 * 3.0) * DT
    np.testing.assert_allclose(velocity[0], (impulse, 0.0, 0.0), rtol=2e-4)
    np.testing.assert_allclose(velocity[1], (0.0, impulse / 400.0, 0.0), rtol=2e-4)
    assert np.all(velocity[2] == 0.0)


def test_lengths_depth_and_stiffness_of_the_bond():
    """If it failed, the longest step and the speed limit would be those of another bond."""
    r, h = POTENTIAL.rest_length, 1e-5
    force = lambda r: -2500.0 / r**4 + 2900.0 / r**6  # noqa: E731
    assert r == pytest.approx(1.077033, abs=1e-6)
    assert force(r) == pytest.approx(0.0, abs=1e-9)
    assert -(force(r + h) - force(r - h)) / (2 * h) == pytest.approx(POTENTIAL.stiffness, rel=1e-6)
    distances = np.linspace(r, 200.0, 2_000_001)
    assert -np.trapezoid(force(distances), distances) == pytest.approx(POTENTIAL.depth, rel=1e-4)


def test_the_step_follows_from_the_heaviest_particle():
    """If it failed, heavy particles, which pull the harder, would make a body burst at the step that is allowed."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(5), np.arange(5)))
    places = POTENTIAL.rest_length * np.column_stack([x + 0.5 * (y % 2), np.sqrt(0.75) * y, 0.0 * x])
    places[:, :2] += np.random.default_rng(1).uniform(-0.01, 0.01, (25, 2))
    mass = np.where(x == 2, 100.0, 1.0)
    with pytest.raises(InputError, match=r"mass = 1.0: must be the heaviest particle's, 100 kg"):
        simulation("cpu", places, POTENTIAL, mass=mass, dt=None)
    sim = simulation("cpu", places, replace(POTENTIAL, mass=100.0), mass=mass, dt=None)
    sim.run(1.0, 1.0)
    assert np.abs(by_id(sim, "precise_position") - places).max() < 0.1 * POTENTIAL.rest_length


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: PairPotential(2500.0, 2900.0, 6, 4, 1.5), "repulsion_exponent = 4: must be a whole number above beta"),
        (lambda: PairPotential(2500.0, 2900.0, 4, 6, 1.0), "cutoff = 1.0: must be above 1.077 m"),
        (lambda: Floor(-0.1), "restitution = -0.1: must be zero or positive"),
        (lambda: Floor(0.1, 1.0, 0.5, 5.0), "slope = 0.5: must be so small"),
        (lambda: DrivingSource((0, 0, 0), 1.0, (1.0, 2.0), (2.0, 1.0)), "until = .*: must be as many rising times"),
        (lambda: DrivingSource((0, 0, 0), 1.0, 2.0, 1.0), "strengths = 2.0: must be a list of numbers"),
        (lambda: DrivingSource((0, 0, 0), 1.0, [1.0, [2.0]], [1.0, 2.0]), "strengths = .*: must be a list of numbers"),
        (lambda: DrivingSource((0, 0, 0), 1.0, (2.0,), 1.0), "until = 1.0: must be as many rising times"),
    ],
)
def test_wrong_numbers_are_refused_in_one_line(make, words):
    """If it failed, particles would collapse, or a schedule never come to its end."""
    with pytest.raises(InputError, match=words) as caught:
        make()
    assert "\n" not in str(caught.value)


def test_forces_in_single_precision_are_refused():
    """If it failed, an elastic body would be summed into accelerations that nobody reads."""
    with pytest.raises(InputError, match="Elasticity"):
        simulation("cpu", [(0.0, 0.0, 0.0)], POTENTIAL, Elasticity(1e5, 0.3))
