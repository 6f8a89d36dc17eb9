"""Heat in a periodic box: a wave of temperature decays at the rate of the lattice, and near the exact one."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.kernels.basics.host import on_host
from warpsph.kernels.basics.smoothing import poly6_slope
from warpsph.run.simulation import Simulation
from warpsph.terms import BackwardEuler, Conduction, CrankNicolson, Explicit

DX, MEAN, SWING = 0.01, 400.0, 50.0
STUFF = solid_material("stuff", density=1000.0, heat_capacity=1000.0, conductivity=10.0)
DIFFUSIVITY = 1.0e-5
ROWS = {2: (32, 20), 3: (24, 12, 12)}
STEP_FACTORS = {
    Explicit: lambda z: 1.0 - z,
    BackwardEuler: lambda z: 1.0 / (1.0 + z),
    CrankNicolson: lambda z: (1.0 - 0.5 * z) / (1.0 + 0.5 * z),
}


def block(device: str, dimension: int, temperature, integrator, interval: float) -> Simulation:
    """A block, periodic along all its axes, and not cut at 0."""
    edges = DX * np.array(ROWS[dimension])
    x = lattice(-0.3 * edges, 0.7 * edges, DX)
    particles = Particles()
    particles.add(x, Role.FREE, temperature=temperature(x))
    box = PeriodicBox((0.0, 0.0, 0.0), (*edges, 0.0)[:3])
    terms = (Conduction(integrator=integrator(), longest_interval=interval),)
    model = Model(dimension, DX, (STUFF,), terms, gravity=(0.0, 0.0, 0.0), periodic=box)
    return Simulation(Executor(device), model, particles)


def lattice_rate(simulation: Simulation, k: float) -> float:
    """Rate [1/s] at which the sum over the lattice lets a wave of wave number k [1/m] along x decay."""
    d = simulation.model.lattice.offsets
    slope = on_host(poly6_slope)(np.sum(d**2, axis=1), simulation.model.support)
    return DIFFUSIVITY * 2.0 * np.sum(slope * (1.0 - np.cos(k * d[:, 0]))) / np.sum(slope * d[:, 0] ** 2)


@pytest.mark.parametrize("integrator", STEP_FACTORS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_a_wave_on_a_ring_decays_at_its_rate(device, dimension, integrator):
    """Heat that passes the border at another rate than elsewhere would bend the wave."""
    length = ROWS[dimension][0] * DX
    k, steps, interval = 2.0 * np.pi / length, 40, 0.5
    wave = lambda x: np.cos(k * (x[:, 0] - 0.1 * length))  # noqa: E731
    simulation = block(device, dimension, lambda x: MEAN + SWING * wave(x), integrator, interval)
    result = simulation.run(steps * interval, steps * interval)
    assert result.steps == steps
    rate = lattice_rate(simulation, k)
    assert rate == pytest.approx(DIFFUSIVITY * k**2, rel=0.03)
    expected = SWING * STEP_FACTORS[integrator](rate * interval) ** steps
    found = result.fields["temperature"].astype(float) - MEAN
    assert expected < 0.95 * SWING
    assert np.allclose(found, expected * wave(result.positions), atol=2e-4)


@pytest.mark.parametrize("integrator", STEP_FACTORS)
def test_heat_of_a_ring_is_kept(device, integrator):
    """A ring has no end by which heat could leave."""
    generator = np.random.default_rng(2)
    simulation = block(device, 2, lambda x: generator.uniform(300.0, 500.0, len(x)), integrator, 0.5)
    simulation.prepare()
    before = simulation.snapshot()["temperature"].astype(float)
    after = simulation.run(20.0, 20.0).fields["temperature"].astype(float)
    assert after.mean() == pytest.approx(before.mean(), abs=2e-4)
    assert after.std() < 0.5 * before.std()
