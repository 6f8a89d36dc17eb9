"""A fluid that fills its box keeps its mean compression, and so its mean pressure."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.faces import velocity_of_faces, way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import CorrectedFluid, DeltaFluid, Enclosed

DX = 0.1


def stirred(device: str, compression: float = 0.0, *terms: Enclosed, free_surface: bool = False) -> Simulation:
    """A box under a lid that slides."""
    model = Model(
        dimension=2,
        spacing=DX,
        materials=(fluid_material("fluid", 1.0, 0.01), solid_material("wall", 1.0, 0.01)),
        terms=(CorrectedFluid(1.0, 10.0, free_surface), *terms),
        gravity=(0.0, 0.0, 0.0),
    )
    walls = tank((0.0, 0.0), (1.0, 1.0), DX, lid=True)
    way = way_to_box(walls, (0.0, 0.0, 0.0), (1.0, 1.0, 0.0))
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 1.0), DX), Role.FREE, "fluid", compression=compression)
    velocity = velocity_of_faces(way, {"+y": (1.0, 0.0, 0.0)})
    particles.add(walls, Role.DUMMY, "wall", velocity=velocity, to_surface=way)
    return Simulation(Executor(device), model, particles)


def drift(simulation: Simulation) -> float:
    """Change of the mean compression in a second."""
    state = simulation.snapshot()
    fluid = state["role"] == Role.FREE
    before = state["compression"][fluid].astype(float).mean()
    simulation.run(1.0, 1.0)
    return float(simulation.snapshot()["compression"][fluid].astype(float).mean() - before)


def test_the_mean_compression_stays_as_it_is_at_the_start(device):
    """If it failed, the pressure of a closed box would drift away, by the errors in the corners under a sliding lid."""
    assert abs(drift(stirred(device))) > 5e-4
    for compression in (0.0, 0.02):
        # the rest of one step of 10 ms, where a second leaves 2e-3
        assert abs(drift(stirred(device, compression, Enclosed()))) < 1e-4


def test_the_flow_itself_is_the_same(device):
    """If it failed, what is taken from the pressure of all particles alike would act on them."""
    speeds = []
    for terms in ((), (Enclosed(),)):
        simulation = stirred(device, 0.0, *terms)
        simulation.run(0.2, 0.2)
        speeds.append(simulation.snapshot()["velocity"])
    np.testing.assert_allclose(speeds[0], speeds[1], atol=1e-3)


def test_a_free_surface_is_refused():
    """A fluid with a free surface may spread; a mean kept by force would lift or sink its surface."""
    with pytest.raises(InputError, match="free surface"):
        stirred("cpu", 0.0, Enclosed(), free_surface=True)


def test_another_flow_is_refused():
    """The advice to add the corrected flow to another one, which excludes it, would lead nowhere."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 1.0), DX), Role.FREE, "fluid")
    model = Model(2, DX, (fluid_material("fluid", 1.0),), (DeltaFluid(1.0, 10.0), Enclosed()))
    with pytest.raises(InputError, match="drop it, or take that flow"):
        Simulation(Executor("cpu"), model, particles)


def test_walls_without_fluid_are_refused():
    """The mean over no particles is no number."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, DX), DX), Role.DUMMY, "fluid", to_surface=(0.0, 0.5 * DX, 0.0))
    model = Model(2, DX, (fluid_material("fluid", 1.0),), (CorrectedFluid(1.0, 10.0), Enclosed()))
    with pytest.raises(InputError, match="there is no fluid"):
        Simulation(Executor("cpu"), model, particles)
