"""Drag that calms the particles while a case finds its rest."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.kernel
def slow_down(
    first: int,
    dt: float,
    rate: float,
    until: wp.float64,
    time: wp.array[wp.float64],
    role: wp.array[int],
    velocity: wp.array[wp.vec3],
):
    """Slow free particles down by exp(-``rate`` dt) while ``time`` (1,) [s] is less than ``until`` [s]."""
    i = wp.tid() + first
    if role[i] == Role.FREE and time[0] < until:
        velocity[i] = velocity[i] * wp.exp(-rate * dt)
