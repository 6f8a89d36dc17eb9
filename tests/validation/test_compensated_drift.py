"""One slow particle far from the origin, whose every step is below single precision."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.run.simulation import Simulation

TOLERANCE = 1e-6  # a few units in the last place of single precision, which are 2.4e-7 m at 2 m


@pytest.mark.parametrize(("start", "speed"), [(2.0, 1e-3), (-2.0, -1e-3), (2.0, -1e-3)])
def test_lands_where_it_should(start, speed, device):
    """Otherwise a strand withdrawn at a centimetre a second would stand still."""
    model = Model(2, 0.01, (fluid_material("marker", 1000.0),), gravity=(0.0, 0.0, 0.0))
    particles = Particles()
    particles.add(np.array([[start, 0.0, 0.0]]), Role.FREE, velocity=(speed, 0.0, 0.0))
    result = Simulation(Executor(device, 1), model, particles, dt=1e-5).run(1.0, 1.0)
    assert result.steps == 100_000
    assert result.positions[0, 0] == pytest.approx(start + float(np.float32(speed)) * result.time, abs=TOLERANCE)
    assert result.positions[0, 0] != start
