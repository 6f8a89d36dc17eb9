"""Tanks keep what is in them, however hard it hits their walls and corners."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.run.simulation import Simulation
from warpsph.terms import CorrectedFluid, Fluid, SummedDensity

SOUND, SPACING, TOP = 10.0, 0.05, 1.5


def tank_of(executor, points, velocity, gravity, dimension, published=False, viscosity=0.0):
    """Liquid at ``points`` (n, 3) [m] with ``velocity`` [m/s] in a tank 1 m wide, and in space 0.4 m deep."""
    upper = (1.0, TOP, 0.4)[:dimension]
    walls = tank((0.0,) * dimension, upper, SPACING)
    particles = Particles()
    particles.add(points, Role.FREE, "liquid", velocity=velocity)
    if published:
        particles.add(walls, Role.DUMMY, "wall")
        terms = (Fluid(1000.0, SOUND), SummedDensity())
    else:
        high = (1.0, np.inf, 0.4 if dimension == 3 else 0.0)
        particles.add(walls, Role.DUMMY, "wall", to_surface=way_to_box(walls, (0.0, 0.0, 0.0), high))
        terms = (CorrectedFluid(1000.0, SOUND, free_surface=True),)
    model = Model(
        dimension=dimension,
        spacing=SPACING,
        materials=(fluid_material("liquid", 1000.0, viscosity), solid_material("wall", 1000.0, viscosity)),
        terms=terms,
        gravity=gravity,
    )
    return Simulation(executor, model, particles, lower=(-3.0,) * 3, upper=(5.0,) * 3)


def block(lower, upper, dimension):
    return lattice(lower[:dimension], upper[:dimension], SPACING)


def deepest(simulation, duration, dimension):
    """How far [m] a particle ever is behind a face of the tank, looked at fifty times."""
    worst, over = 0.0, np.zeros(int(np.sum(simulation.snapshot()["role"] == Role.FREE)), bool)
    for _ in range(50):
        simulation.run(duration / 50, duration / 50)
        state = simulation.snapshot()
        x = state["position"][state["role"] == Role.FREE].astype(float)
        over |= x[:, 1] >= TOP
        x = x[~over]  # what has flown over the walls has not gone through them
        behind = [-x[:, 0], x[:, 0] - 1.0, -x[:, 1]] + ([-x[:, 2], x[:, 2] - 0.4] if dimension == 3 else [])
        worst = max(worst, float(np.max(behind)))
    return worst


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("mach", [0.2, 0.3])
def test_a_drop_that_hits_a_corner_stays_in(mach, dimension, device):
    """Otherwise a corner, which two walls or three close, would be open to what is fast."""
    points = block((0.1, 0.1, 0.0), (0.35, 0.35, 0.4), dimension)
    way = np.array([-1.0, -1.0, 0.0]) / np.sqrt(2.0)
    simulation = tank_of(Executor(device), points, tuple(mach * SOUND * way), (0.0, -10.0, 0.0), dimension)
    assert deepest(simulation, 0.4, dimension) <= 0.0


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_jet_against_a_wall_stays_in(dimension, device):
    """Otherwise what follows would push what has hit through the wall."""
    points = block((0.0, 0.3, 0.1), (0.9, 0.6, 0.3), dimension)
    simulation = tank_of(Executor(device), points, (0.3 * SOUND, 0.0, 0.0), (0.0, -10.0, 0.0), dimension)
    assert deepest(simulation, 0.5, dimension) <= 0.0


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_tank_that_sloshes_stays_tight(dimension, device):
    """Otherwise waves that run up a wall and fall back would leave the tank."""
    points = block((0.0, 0.0, 0.0), (1.0, 0.4, 0.4), dimension)
    for side in (5.0, -5.0):  # a tank that is shaken with half the weight of the liquid
        simulation = tank_of(Executor(device), points, (0.0, 0.0, 0.0), (side, -10.0, 0.0), dimension)
        assert deepest(simulation, 1.0, dimension) <= 0.0
        state = simulation.snapshot()
        points = state["position"][state["role"] == Role.FREE].astype(float)


def test_a_tank_of_the_published_flow_is_tight_where_it_is_viscous(device):
    """Otherwise the thesis's walls would leak where its flow is as viscous as it asks for."""
    points = block((0.0, 0.0, 0.0), (0.5, 0.5, 0.0), 2)
    simulation = tank_of(Executor(device), points, (0.0, 0.0, 0.0), (0.0, -10.0, 0.0), 2, True, 50.0)
    assert deepest(simulation, 1.0, 2) < 0.5 * SPACING  # its walls begin where their particles are


def test_what_comes_to_the_back_of_a_wall_is_not_shot_through_it(device):
    """What splashes over the rim of a tank and falls down beside it would come back through the wall, faster than
    sound.
    """
    fluid, wall = fluid_material("fluid", 1000.0), solid_material("wall", 1000.0)
    flow = CorrectedFluid(1000.0, 10.0, free_surface=True)
    model = Model(2, 0.1, (fluid, wall), (flow,), gravity=(0.0, 0.0, 0.0))
    floor = lattice((0.0, -0.3), (1.0, 0.0), 0.1)
    face = way_to_box(floor, (-np.inf, 0.0, 0.0), (np.inf, np.inf, 0.0))
    particles = Particles()
    particles.add(lattice((0.3, -0.8), (0.7, -0.4), 0.1), Role.FREE, "fluid", velocity=(0.0, 0.5, 0.0))
    particles.add(floor, Role.DUMMY, "wall", to_surface=face)
    simulation = Simulation(Executor(device), model, particles)
    simulation.run(0.4, 0.4)
    state = simulation.snapshot()
    free = state["role"] == Role.FREE
    assert state["position"][free, 1].max() < -0.3
    assert np.linalg.norm(state["velocity"][free], axis=1).max() < 1.0


def test_fluid_on_the_very_place_of_a_wall_particle_stays_a_number():
    """What holds it off would divide by the distance, which is none, and the whole fluid be lost in a step or two."""
    points = block((0.0, 0.0, 0.0), (1.0, 0.4, 0.0), 2)
    points[0] = (-0.5 * SPACING, 0.5 * SPACING, 0.0)
    simulation = tank_of(Executor("cpu", 1), points, (0.0, 0.0, 0.0), (0.0, -10.0, 0.0), 2)
    simulation.run(0.02, 0.02)
    assert np.all(np.isfinite(simulation.snapshot()["velocity"]))
