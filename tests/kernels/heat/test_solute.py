"""Diffusion of a solute: what is kept, what grows, and the exact spreading of a step."""

import numpy as np
import pytest
from scipy.special import erfc

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import HeatWall, Solute

DENSITY = 1000.0
DIFFUSIVITY = 1.0e-6 * DENSITY  # [kg/(m s)]


def body(device, dimension, solute, diffusivity=DIFFUSIVITY, walls=True, cells=(12, 6, 6), shaken=0.0, material=None):
    """A block of liquid of spacing 1 cm, with the solute that a function of the places gives."""
    size = 0.01 * np.array(cells[:dimension])
    points = lattice(np.zeros(dimension), size, 0.01)
    points[:, :dimension] += np.random.default_rng(1).uniform(-shaken, shaken, (len(points), dimension))
    faces = []
    for axis in range(dimension):
        normal = np.eye(3)[axis]
        faces += [HeatWall.insulated(normal, 0.0), HeatWall.insulated(-normal, -size[axis])]
    names = ("a", "b") if material is not None else ("a",)
    materials = tuple(fluid_material(name, DENSITY) for name in names)
    particles = Particles()
    kinds = [names[k] for k in material(points)] if material is not None else "a"
    particles.add(points, Role.FREE, kinds, solute=solute(points))
    term = Solute(diffusivity, tuple(faces) if walls else ())
    return Simulation(
        Executor(device, 2), Model(dimension, 0.01, materials, (term,), gravity=(0.0, 0.0, 0.0)), particles
    )


def half(points):
    return np.where(points[:, 0] < 0.06, 0.2, 0.1)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("walls", [True, False])
def test_solute_is_kept_and_entropy_never_falls(device, dimension, walls):
    """Otherwise solute would be made or lost, or would flow together again: Monaghan et al. (2.14), (2.18)."""
    simulation = body(device, dimension, half, walls=walls, shaken=0.003)
    before, entropies = simulation.snapshot()["solute_mass"].sum(), []
    for _ in range(6):
        simulation.run(40.0, 40.0)
        state = simulation.snapshot()
        entropies.append(np.sum(state["mass"].astype(float) * np.log(state["solute"].astype(float))))
    assert state["solute_mass"].sum() == pytest.approx(before, rel=1e-9)
    assert np.all(np.diff(entropies) > 0.0)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_step_spreads_as_the_exact_one(device, dimension):
    """Otherwise it would spread too fast or too slowly, or differently at walls."""
    simulation = body(device, dimension, half, cells=(24, 4, 4))
    time = 400.0
    result = simulation.run(time, time)
    x, width = result.positions[:, 0], np.sqrt(4.0 * 1e-6 * time)
    exact = 0.1 + 0.05 * (erfc((x - 0.06) / width) - erfc((x + 0.06) / width))
    np.testing.assert_allclose(result.fields["solute"], exact, atol=1.5e-3)
    columns = result.fields["solute"].reshape(24, -1)
    assert np.ptp(columns, axis=1).max() < 1e-6  # walls are mirrors


def test_the_worse_of_two_liquids_decides(device):
    """Otherwise solute would leave a liquid in which it cannot move, or the flux between two would be wrong."""
    given = {"cells": (24, 4), "material": lambda points: (points[:, 0] > 0.12).astype(int)}

    def step(points):
        return np.where(points[:, 0] < 0.12, 0.2, 0.1)

    blocked = body(device, 2, step, {"a": DIFFUSIVITY}, **given).run(200.0, 200.0)
    np.testing.assert_allclose(blocked.fields["solute"], step(blocked.positions), atol=1e-6)
    slow = body(device, 2, step, {"a": DIFFUSIVITY, "b": 0.25 * DIFFUSIVITY}, **given).run(800.0, 800.0)
    passed = np.sum(slow.fields["solute_mass"][slow.positions[:, 0] > 0.12]) - 0.1 * 0.12 * 0.04 * DENSITY
    exact = 2.0 * 0.1 * 0.04 * DENSITY * np.sqrt(1e-6 * 800.0 / np.pi) * 0.5 / 1.5  # two half spaces in contact
    assert passed == pytest.approx(exact, rel=0.08)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"diffusivity": -1.0}, "diffusivity = -1.0: must be zero or positive"),
        ({"diffusivity": {"a": "fast"}}, "must be zero or positive"),
        ({"walls": "left"}, "walls = 'left': must be a tuple of HeatWall"),
    ],
)
def test_wrong_input(wrong, message):
    """Otherwise it would come out of a kernel, or not at all."""
    with pytest.raises(InputError, match=message):
        Solute(**wrong)


def test_wrong_particles():
    """Otherwise more solute than liquid would diffuse, or images of what is behind a wall would count."""
    with pytest.raises(InputError, match="'solute' must be a mass fraction"):
        body("cpu", 2, lambda points: 1.5 + 0.0 * points[:, 0])
    particles = Particles()
    particles.add(lattice((-0.05, 0.0), (0.05, 0.05), 0.01), Role.FREE)
    model = Model(2, 0.01, (fluid_material("a", 1.0),), (Solute(1e-6, (HeatWall.insulated((1.0, 0.0, 0.0), 0.0),)),))
    with pytest.raises(InputError, match="25 particles are behind it"):
        Simulation(Executor("cpu"), model, particles)
