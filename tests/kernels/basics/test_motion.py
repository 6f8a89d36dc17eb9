"""Motion in single precision."""

import numpy as np
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.launch import Launch
from warpsph.kernels.basics.motion import drift


def test_tiny_steps_far_from_the_origin_add_up(device):
    """Without compensation a strand at 2 m that moves at 1 mm/s would stand still."""
    executor = Executor(device)
    role = wp.array([int(Role.FREE)], dtype=int, device=device)
    velocity = wp.array([[1e-3, -1e-3, 0.0]], dtype=wp.vec3, device=device)
    position = wp.array([[2.0, 2.0, 0.0]], dtype=wp.vec3, device=device)
    carry = wp.zeros(1, dtype=wp.vec3, device=device)
    steps, dt = 100_000, 1e-5
    arrays = {"role": role, "velocity": velocity, "position": position, "position_carry": carry}
    launch = Launch(executor, 1, arrays)
    recording = executor.record(lambda: launch(drift, dt=dt))
    executor.replay([(recording, steps)])
    moved = position.numpy()[0].astype(float) - carry.numpy()[0] - 2.0
    assert np.allclose(moved, [1e-3, -1e-3, -2.0], atol=1e-6)
