"""Rolls: smooth, elastic, and on the right side."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.errors import InputError
from warpsph.machine import Rolls
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, SummedDensity

SPACING, FACE, RADIUS, HEIGHT = 0.004, 0.1, 0.01, 0.2


def beside_rolls(device: str, dimension: int, particles: Particles) -> Simulation:
    """Solid particles beside two rolls, without gravity."""
    terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), Elasticity(4e5, 0.3))
    model = Model(dimension, SPACING, (solid_material("steel", 2100.0),), terms, gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device), model, particles, parts=[Rolls(FACE, [0.1, HEIGHT], RADIUS)], dt=2e-5)


def thrown(device: str, dimension: int, start, velocity) -> Simulation:
    """One solid particle that flies at a roll."""
    particles = Particles()
    particles.add(np.array([start], float), Role.FREE, velocity=velocity, phase=Phase.SOLID)
    return beside_rolls(device, dimension, particles)


@pytest.mark.parametrize(("dimension", "axis"), [(2, 0), (3, 0), (3, 2)])
def test_what_hits_a_roll_bounces_back_with_its_speed(device, dimension, axis):
    """A roll that takes energy is a brake, one that gives some throws the shell back."""
    start, velocity = [0.02, HEIGHT, 0.02], [0.0, 0.0, 0.0]
    start[axis], velocity[axis] = FACE - 1.5 * SPACING, 0.5
    if dimension == 2:
        start[2] = 0.0
    simulation = thrown(device, dimension, start, tuple(velocity))
    deepest = -np.inf
    for _ in range(60):
        simulation.run(0.0005, 0.0005)
        deepest = max(deepest, simulation.snapshot()["position"][0, axis])
    state = simulation.snapshot()
    assert state["velocity"][0, axis] == pytest.approx(-0.5, rel=2e-3)
    assert FACE - SPACING < deepest < FACE


def test_a_roll_is_round_and_has_no_friction(device):
    """A glancing blow turns the velocity about the normal; friction would hold the strand up."""
    angle = np.radians(150.0)
    normal = np.array([np.cos(angle), np.sin(angle), 0.0])
    centre = np.array([FACE + RADIUS, HEIGHT, 0.0])
    along = np.array([-normal[1], normal[0], 0.0])
    start = centre + normal * (RADIUS + SPACING + 2e-4) - along * 2e-4
    simulation = thrown(device, 2, start, tuple(0.4 * (along - normal)))
    simulation.run(0.02, 0.001)
    velocity = simulation.snapshot()["velocity"][0]
    assert np.linalg.norm(velocity) == pytest.approx(0.4 * np.sqrt(2.0), rel=5e-3)
    assert velocity @ normal > 0.25
    assert velocity @ along > 0.25


def test_what_is_inside_the_strand_or_between_rolls_feels_none(device):
    """A shell that is held between the rolls too would never bulge."""
    for start in ([FACE - 1.01 * SPACING, HEIGHT, 0.0], [FACE + RADIUS, 0.5 * (0.1 + HEIGHT), 0.0]):
        simulation = thrown(device, 2, start, (0.0, 0.0, 0.0))
        simulation.prepare()
        assert np.all(simulation.state.numpy("acceleration") == 0.0)


@pytest.mark.parametrize("gap", [0.3, 0.5])
def test_a_row_of_particles_slides_over_a_roll(device, gap):
    """A skin that rests on the one particle at the apex hangs there until its withdrawal tears it past."""
    along = []
    for shift in np.linspace(0.0, 1.0, 9):
        row = np.zeros((15, 3))
        row[:, 0] = FACE - gap * SPACING
        row[:, 1] = HEIGHT + (np.arange(15) - 7 + shift) * SPACING
        particles = Particles()
        particles.add(row, Role.FREE, phase=Phase.SOLID)
        simulation = beside_rolls(device, 2, particles)
        simulation.prepare()
        push = simulation.state.numpy("acceleration").sum(axis=0)
        assert push[0] < 0.0
        along.append(push[1] / push[0])
    assert np.max(np.abs(along)) < 0.01


@pytest.mark.parametrize(("face", "heights", "radius", "name"), [
    (-0.1, [0.1], 0.01, "face"), (0.1, [np.nan], 0.01, "heights"), (0.1, [0.1], 0.0, "radius"),
    ("0.1", [0.1], 0.01, "face"), (0.1, "0.1", 0.01, "heights"), (0.1, 0.1, 0.01, "heights"),
    (0.1, [[0.1]], 0.01, "heights"), (0.1, [0.1], None, "radius"),
])  # fmt: skip
def test_rolls_that_cannot_be_are_refused(face, heights, radius, name):
    """A roll without a radius would push with an infinite force."""
    with pytest.raises(InputError, match=name):
        Rolls(face, heights, radius)


def test_rolls_are_drawn_where_they_are():
    """A picture that shows rolls elsewhere would be read as a gap."""
    rolls = Rolls(FACE, [0.1, HEIGHT], RADIUS)
    for length, layers in ((0.0, 1), (5 * SPACING, 5)):
        points = rolls.surface(SPACING, length)
        away = np.hypot(points[:, 0] - FACE - RADIUS, np.abs(points[:, 1] - 0.15) - 0.05)
        assert np.allclose(away, RADIUS - 0.5 * SPACING)
        assert len(np.unique(points[:, 2])) == layers
