"""A lamp, what it sees, and the heat it gives."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Damping, Lamp, PreciseMotion

DT = 1e-3


def lit(device: str, places, velocity=(0.0, 0.0, 0.0), *terms, dimension=2, **lamp) -> Simulation:
    """Particles that do not feel each other, around a lamp of 100 W at the origin."""
    source = Lamp((0.0, 0.0, 0.0), 100.0, radius=0.5, **{"rays": 7200} | lamp)
    model = Model(
        dimension, 1.0, (solid_material("particles", 1.0),), (PreciseMotion(), source, *terms), gravity=(0.0,) * 3
    )
    particles = Particles()
    particles.add(np.asarray(places, float), Role.FREE, velocity=np.asarray(velocity, float), mass=2.0)
    return Simulation(Executor(device), model, particles, dt=DT)


def light_of(sim: Simulation) -> np.ndarray:
    """What each particle takes at the start [W]."""
    sim.prepare()
    return sim.state.numpy("light")[np.argsort(sim.state.numpy("id"))]


def test_what_stands_behind_lies_in_the_shadow(device):
    """If it failed, particles would be heated through others."""
    near, behind, beside, half = (4.0, 0.0, 0.0), (9.0, 0.2, 0.0), (0.0, -7.0, 0.0), (8.0, 1.0, 0.0)
    light = light_of(lit(device, [behind, near, half, beside]))
    alone = light_of(lit(device, [half]))[0]
    width = np.arcsin(0.5 / np.array([4.0, 7.0])) / np.pi
    assert light[0] == 0.0
    np.testing.assert_allclose(light[[1, 3]], 100.0 * width, rtol=0.01)
    assert 0.0 < light[2] < 0.7 * alone


def test_a_closed_ring_takes_all_and_leaves_nothing(device):
    """If it failed, heat would be lost or given twice."""
    angle = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)
    ring = np.column_stack([5.0 * np.cos(angle), 5.0 * np.sin(angle), 0.0 * angle])
    light = light_of(lit(device, np.vstack([ring, 2.0 * ring, 1.7 * ring[::3]])))
    assert np.sum(light) == pytest.approx(100.0, rel=1e-6)
    assert np.all(light[60:] == 0.0)


def test_a_second_lamp_is_refused():
    """If it failed, the light of the first would be lost and that of the second be given twice."""
    with pytest.raises(InputError, match="Lamp and Lamp exclude each other"):
        lit("cpu", [(4.0, 0.0, 0.0)], (0.0, 0.0, 0.0), Lamp((9.0, 0.0, 0.0), 100.0, radius=0.5))


def test_heat_becomes_kinetic_energy(device):
    """If it failed, a particle would gain another energy than the lamp has given."""
    for velocity in ((0.0, 0.0, 0.0), (0.0, 0.3, 0.0)):
        sim = lit(device, [(50.0, 0.0, 0.0)], velocity, begin=0.05, rays=2**20)
        before = np.sum(np.square(velocity))
        sim.run(0.05, 0.05)
        sim.solver.act("sum_forces")
        power = float(sim.state.light.numpy()[0])
        sim.run(0.02, 0.02)
        after = np.sum(sim.state.numpy("precise_velocity") ** 2)
        assert power > 0.0
        assert after - before == pytest.approx(power * 0.02, rel=1e-3)  # 2 kg


def test_friction_ends(device):
    """If it failed, a block would go on losing the heat that it is given."""
    sim = lit(device, [(5.0, 0.0, 0.0)], (0.0, 1.0, 0.0), Damping(2.0, 0.5), begin=1e3)
    sim.run(1.0, 0.1)
    assert sim.state.numpy("precise_velocity")[0, 1] == pytest.approx(np.exp(-1.0), rel=2e-3)


def test_a_lamp_in_space_is_refused():
    """If it failed, rays in one plane would miss what stands before and behind it."""
    with pytest.raises(InputError, match="Lamp: its rays lie in the plane"):
        lit("cpu", [(5.0, 0.0, 0.0)], dimension=3)
    with pytest.raises(InputError, match="Lamp: rays = 3: must be a whole number from 8"):
        lit("cpu", [(5.0, 0.0, 0.0)], rays=3)
