"""Advancing velocity, position and time."""

import warp as wp

from warpsph.kernels.basics.compensation import compensated_sum
from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def fall(first: int, gravity: wp.vec3, role: wp.array[int], acceleration: wp.array[wp.vec3]):
    """Begin the acceleration (n,) [m/s^2] of a step: gravity for free particles, zero for all others."""
    i = wp.tid() + first
    if role[i] == Role.FREE:
        acceleration[i] = gravity
    else:
        acceleration[i] = wp.vec3()


@wp.kernel
def kick(first: int, dt: float, role: wp.array[int], acceleration: wp.array[wp.vec3], velocity: wp.array[wp.vec3]):
    """Add ``acceleration * dt`` to the velocity (n,) [m/s] of free particles."""
    i = wp.tid() + first
    if role[i] == Role.FREE:
        velocity[i] += acceleration[i] * dt


@wp.kernel
def drift(
    first: int,
    dt: float,
    role: wp.array[int],
    velocity: wp.array[wp.vec3],
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
):
    """Add ``velocity * dt`` to the position (n,) [m], compensated, of all that is not a wall."""
    i = wp.tid() + first
    if role[i] != Role.WALL and role[i] != Role.DUMMY and role[i] != Role.RESERVOIR:
        x, carry = compensated_sum(position[i], velocity[i] * dt, position_carry[i])
        position[i] = x
        position_carry[i] = carry


@wp.kernel
def advance_clock(first: int, dt: wp.float64, time: wp.array[wp.float64], steps: wp.array[int]):
    """Advance the simulated time (1,) [s] (float64) and the number of steps (1,); one thread."""
    steps[0] += 1
    time[0] += dt
