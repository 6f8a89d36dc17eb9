"""Advancing velocity and position, and watching over both."""

import warp as wp

from warpsph.kernels.basics.compensation import compensated_sum
from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def _fall(first: int, gravity: wp.vec3, acceleration: wp.array[wp.vec3]):
    i = wp.tid() + first
    acceleration[i] = gravity


@wp.kernel
def _kick(first: int, dt: float, role: wp.array[int], acceleration: wp.array[wp.vec3], velocity: wp.array[wp.vec3]):
    i = wp.tid() + first
    if role[i] == Role.FREE:
        velocity[i] += acceleration[i] * dt


@wp.kernel
def _drift(
    first: int,
    dt: float,
    role: wp.array[int],
    velocity: wp.array[wp.vec3],
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
):
    i = wp.tid() + first
    if role[i] != Role.WALL and role[i] != Role.DUMMY and role[i] != Role.RESERVOIR:
        x, carry = compensated_sum(position[i], velocity[i] * dt, position_carry[i])
        position[i] = x
        position_carry[i] = carry


@wp.kernel
def _watch(
    first: int,
    role: wp.array[int],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    reference: wp.array[wp.vec3],
    farthest_squared: float,
    speed_limit_squared: float,
    outdated: wp.array[int],
    runaway: wp.array[int],
):
    i = wp.tid() + first
    if role[i] != Role.RESERVOIR:
        d = position[i] - reference[i]
        if wp.dot(d, d) > farthest_squared:
            outdated[0] = 1
        u = velocity[i]
        if not (wp.dot(u, u) < speed_limit_squared):
            runaway[0] = i + 1


def fall(launch, gravity, acceleration) -> None:
    """Begin the acceleration (n,) [m/s^2] of a step with gravity alone."""
    launch(_fall, acceleration.shape[0], [gravity, acceleration])


def kick(launch, dt, role, acceleration, velocity) -> None:
    """Add ``acceleration * dt`` to the velocity (n,) [m/s] of free particles."""
    launch(_kick, role.shape[0], [dt, role, acceleration, velocity])


def drift(launch, dt, role, velocity, position, position_carry) -> None:
    """Add ``velocity * dt`` to the position (n,) [m], compensated, of all that is not a wall."""
    launch(_drift, role.shape[0], [dt, role, velocity, position, position_carry])


def watch(launch, role, position, velocity, reference, farthest, speed_limit, outdated, runaway) -> None:
    """Raise ``outdated`` where a particle left its ``reference`` position by ``farthest`` [m], and note a runaway.

    ``runaway`` (1,) becomes 1 + the index of a particle whose speed is not below ``speed_limit`` [m/s] or not a number.
    """
    launch(
        _watch,
        role.shape[0],
        [role, position, velocity, reference, farthest**2, speed_limit**2, outdated, runaway],
    )


@wp.kernel
def _advance_clock(first: int, dt: wp.float64, time: wp.array[wp.float64], step: wp.array[int]):
    step[0] += 1
    time[0] += dt


def advance_clock(launch, dt, time, step) -> None:
    """Advance the simulated time (1,) [s] (float64) and the number of the step (1,)."""
    launch.whole(_advance_clock, 1, [dt, time, step])
