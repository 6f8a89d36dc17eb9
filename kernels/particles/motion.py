"""Leap-frog steps in double precision, and what the rest of the program sees of them."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def fall_precisely(
    first: int, precise_gravity: wp.vec3d, role: wp.array[int], precise_acceleration: wp.array[wp.vec3d]
):
    """Begin the acceleration (n,) [m/s^2] of a step: gravity for free particles, zero for all others."""
    i = wp.tid() + first
    precise_acceleration[i] = wp.vec3d()
    if role[i] == Role.FREE:
        precise_acceleration[i] = precise_gravity


@wp.kernel
def kick_precisely(
    first: int,
    dt: wp.float64,
    last_step: wp.array[wp.float64],
    precise_acceleration: wp.array[wp.vec3d],
    precise_velocity: wp.array[wp.vec3d],
):
    """Advance the velocity (n,) [m/s] from the middle of the last step to that of this one, by ``dt`` [s].

    ``last_step`` (1,) is the length of the step before, 0 at the start, where the velocity is that of the start.
    """
    i = wp.tid() + first
    between = wp.float64(0.5) * (last_step[0] + dt)
    precise_velocity[i] += between * precise_acceleration[i]  # Greenspan (2.1), (2.2)


@wp.kernel
def drift_precisely(
    first: int, dt: wp.float64, precise_velocity: wp.array[wp.vec3d], precise_position: wp.array[wp.vec3d]
):
    """Advance the position (n,) [m] by ``dt`` [s]."""
    i = wp.tid() + first
    precise_position[i] += dt * precise_velocity[i]  # Greenspan (2.3)


@wp.kernel
def show(
    first: int,
    precise_position: wp.array[wp.vec3d],
    precise_velocity: wp.array[wp.vec3d],
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
):
    """Write place and velocity (n,) in single precision, and what the place loses by it."""
    i = wp.tid() + first
    x, u = precise_position[i], precise_velocity[i]
    shown = wp.vec3(float(x[0]), float(x[1]), float(x[2]))
    position[i] = shown
    position_carry[i] = wp.vec3(
        float(wp.float64(shown[0]) - x[0]), float(wp.float64(shown[1]) - x[1]), float(wp.float64(shown[2]) - x[2])
    )
    velocity[i] = wp.vec3(float(u[0]), float(u[1]), float(u[2]))


@wp.kernel
def keep_step(first: int, dt: wp.float64, last_step: wp.array[wp.float64]):
    """Remember the length ``dt`` [s] of this step; one thread."""
    last_step[0] = dt


@wp.kernel
def damp(
    first: int,
    dt: wp.float64,
    time: wp.array[wp.float64],
    damping_rate: wp.float64,
    damping_end: wp.float64,
    precise_velocity: wp.array[wp.vec3d],
):
    """Let the velocity (n,) [m/s] decay at ``damping_rate`` [1/s] until ``damping_end`` [s]."""
    i = wp.tid() + first
    if time[0] < damping_end:
        precise_velocity[i] *= wp.exp(-damping_rate * dt)
