"""Conduction between disordered particles that flow: flux, conservation, what follows shifted particles."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import BackwardEuler, CorrectedConduction, CorrectedFluid, HeatWall

CONDUCTIVITY = 0.1


def sheared_layer(device, dimension, faces, temperature, conductivity=CONDUCTIVITY, shifting=8.0):
    """A layer 1 m high between a floor at rest and a lid at 1 m/s, its particles out of order; 1 J/(m^3 K)."""
    dx = 0.1
    depth = (1.0,) if dimension == 3 else ()
    fluid = fluid_material("fluid", 1.0, 0.1, conductivity=conductivity, heat_capacity=1.0)
    conduction = CorrectedConduction(walls=faces, longest_interval=0.02)
    model = Model(
        dimension=dimension,
        spacing=dx,
        materials=(fluid, solid_material("wall", 1.0, 0.1)),
        terms=(CorrectedFluid(1.0, 10.0, shifting=shifting), conduction),
        gravity=(0.0, 0.0, 0.0),
        periodic=PeriodicBox((0.0, 0.0, 0.0), (1.0, 0.0, *(depth or (0.0,)))),
    )
    x = lattice((0.0,) * dimension, (1.0, 1.0, *depth), dx)
    x[:, :dimension] += np.random.default_rng(1).uniform(-0.2, 0.2, (len(x), dimension)) * dx
    outside = lattice((0.0, -0.3, *(0.0,) * len(depth)), (1.0, 1.3, *depth), dx)
    way = way_to_box(outside, (-np.inf, 0.0, -np.inf), (np.inf, 1.0, np.inf))
    walls = np.linalg.norm(way, axis=1) > 0.0
    lid = np.outer(outside[walls, 1] > 1.0, (1.0, 0.0, 0.0))
    particles = Particles()
    particles.add(x, Role.FREE, "fluid", temperature=temperature(x), velocity=np.outer(x[:, 1], (1.0, 0.0, 0.0)))
    particles.add(outside[walls], Role.DUMMY, "wall", velocity=lid, to_surface=way[walls])
    return Simulation(Executor(device), model, particles), conduction


def heat(simulation):
    state = simulation.snapshot()
    return float(np.sum((state["enthalpy"].astype(float) * state["mass"])[state["role"] == Role.FREE]))


@pytest.mark.parametrize("dimension", [2, 3])
def test_heat_through_a_sheared_layer(dimension, device):
    """Otherwise the disorder of a flow would conduct heat better or worse than its material does."""
    faces = (HeatWall.at_temperature((0, 1, 0), 0.0, 10.0), HeatWall.at_temperature((0, -1, 0), -1.0, 11.0))
    simulation, conduction = sheared_layer(device, dimension, faces, lambda x: 10.0 + x[:, 1])
    simulation.run(1.0, 1.0)
    before = conduction.heat_to_walls()
    simulation.run(3.0, 3.0)
    flux = (conduction.heat_to_walls() - before) / 3.0
    # second order from 0.02 % at 20 rows, and the noise of three turns
    assert flux == pytest.approx(np.array([1.0, -1.0]) * CONDUCTIVITY, rel=0.005)


@pytest.mark.parametrize("insulated", [True, False])
def test_heat_is_kept(insulated, device):
    """Otherwise what one particle gains the other one would not lose, or walls would not count what they take."""
    ends = (((0, 1, 0), 0.0), ((0, -1, 0), -1.0))
    faces = [HeatWall.insulated(*end) if insulated else HeatWall.film(*end, 1.0, 5.0) for end in ends]
    wave = lambda x: 10.0 + np.sin(2.0 * np.pi * x[:, 0])  # noqa: E731
    simulation, conduction = sheared_layer(device, 2, faces, wave, shifting=0.0)
    start = heat(simulation)
    simulation.run(0.5, 0.5)
    assert start - heat(simulation) == pytest.approx(float(conduction.heat_to_walls().sum()), abs=1e-5)  # rounding


def test_shifted_particles_have_the_temperature_of_their_place(device):
    """Otherwise shifting, which is no flow, would carry heat along and blur layers."""
    faces = (HeatWall.at_temperature((0, 1, 0), 0.0, 10.0), HeatWall.at_temperature((0, -1, 0), -1.0, 11.0))
    simulation, _ = sheared_layer(device, 2, faces, lambda x: 10.0 + x[:, 1], conductivity=1e-6)
    simulation.run(2.0, 2.0)
    state = simulation.snapshot()
    fluid = state["role"] == Role.FREE
    # a twentieth of a row: velocities across the layer carry particles as far; shifting takes them three times farther
    assert np.std(state["temperature"][fluid] - state["position"][fluid, 1]) < 0.005


def test_what_it_cannot_do_is_refused():
    """Otherwise a choice that has no effect here would be taken without a word."""
    with pytest.raises(InputError, match="explicit steps only"):
        CorrectedConduction(integrator=BackwardEuler(), longest_interval=1.0)
    with pytest.raises(InputError, match="smoothing"):
        CorrectedConduction(smoothing="poly6")
