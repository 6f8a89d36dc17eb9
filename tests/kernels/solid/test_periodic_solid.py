"""Elastic bars that are joined with themselves around a periodic box."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.run.simulation import Simulation
from warpsph.terms import Elasticity

DX, E, RHO = 0.01, 1.0e6, 1000.0
ROWS = {2: (40, 12), 3: (30, 10, 10)}


def bar(device: str, dimension: int, velocity, periodic_across: bool = False) -> tuple[Simulation, PeriodicBox]:
    """A bar along x without ends; ``velocity`` finds that of places (n, 3) [m]."""
    edges = DX * np.array(ROWS[dimension])
    x = lattice(0.4 * edges, 1.4 * edges, DX)
    particles = Particles()
    particles.add(x, Role.FREE, phase=Phase.SOLID, velocity=velocity(x))
    lengths = [*edges, 0.0][:3] if periodic_across else [edges[0], 0.0, 0.0]
    box = PeriodicBox((0.0, 0.0, 0.0), lengths)
    model = Model(
        dimension, DX, (solid_material("rubber", RHO),), (Elasticity(E, 0.3),), gravity=(0.0, 0.0, 0.0), periodic=box
    )
    return Simulation(Executor(device), model, particles), box


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_bar_slides_through_the_border_without_force(device, dimension):
    """A bond that took the long way around would pull with the strain of a whole period."""
    velocity = np.array([16.0, 2.4, 0.0])
    simulation, box = bar(device, dimension, lambda x: np.tile(velocity, (len(x), 1)))
    simulation.prepare()
    before = simulation.snapshot()
    bonds = simulation.state.bonds.count.numpy()[np.argsort(simulation.state.numpy("id"))]
    inside = np.abs(before["position"][:, 1] - before["position"][:, 1].mean()) < 0.2 * DX * ROWS[dimension][1]
    inside &= (dimension == 2) | (np.abs(before["position"][:, 2] - before["position"][:, 2].mean()) < 2 * DX)
    assert np.ptp(bonds[inside]) == 0
    duration = 1.2 * box.edges[0] / velocity[0]
    simulation.run(duration, duration)
    after = simulation.snapshot()
    assert simulation.state.renewals.numpy()[0] > 10
    assert np.allclose(after["velocity"], velocity, atol=1e-4)
    assert np.abs(after["stress"]).max() < 1e-5 * E
    way = after["position"].astype(float) - before["position"]
    assert np.allclose(box.nearest(way - velocity * simulation.time), 0.0, atol=1e-6)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_wave_runs_around(device, dimension):
    """A joint softer or harder than the rest would reflect the wave, or change the time that it takes around."""
    length, speed = ROWS[dimension][0] * DX, 0.05
    simulation, _ = bar(device, dimension, lambda x: speed * np.sin(2 * np.pi * x / length) * [1, 0, 0], True)
    simulation.prepare()
    start = simulation.snapshot()["velocity"][:, 0].astype(float)
    wave_speed = simulation.model.the(Elasticity).wave_speed(RHO)
    times, amplitudes = [], []
    period = length / wave_speed  # of the standing wave, which is two that run around
    for _ in range(66):
        simulation.run(period / 60.0, period / 60.0)
        amplitudes.append(simulation.snapshot()["velocity"][:, 0].astype(float) @ start / (start @ start))
        times.append(simulation.time)
    last = 30 + int(np.argmax(amplitudes[30:]))
    assert times[last] == pytest.approx(period, rel=0.06)  # the smoothing slows so short a wave down
    assert amplitudes[last] > 0.97
    assert np.allclose(amplitudes, np.cos(2.0 * np.pi * np.array(times) / times[last]), atol=0.05)
    across = np.abs(simulation.snapshot()["velocity"][:, 1:]).max()
    assert across < 1e-3 * speed


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_stretched_ring_bears_the_stress_of_its_strain(device, dimension):
    """Strain is found from places: a shear that is the same everywhere must be so across the border too."""
    simulation, box = bar(device, dimension, lambda x: np.zeros_like(x), True)
    simulation.prepare()
    state, slope = simulation.state, 1.0e-3
    x = state.numpy("position").astype(float)
    length = box.edges[1]
    x[:, 0] += slope * length / (2.0 * np.pi) * np.sin(2.0 * np.pi * x[:, 1] / length)
    state.position.assign(x.astype(np.float32))
    state.position_carry.assign((x.astype(np.float32) - x).astype(np.float32))
    state.outdated.fill_(1)
    simulation.prepare()
    _, mu = simulation.model.the(Elasticity).lame
    after = simulation.snapshot()
    exact = mu * slope * np.cos(2.0 * np.pi * after["position"][:, 1] / length)
    found = after["stress"][:, 0, 1]
    weight = (found @ exact) / (exact @ exact)
    assert 0.7 < weight < 1.0  # a smoothing kernel over ten rows of a wave
    assert np.allclose(found, weight * exact, atol=0.01 * mu * slope)
