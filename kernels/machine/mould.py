"""The oscillating mould."""

import math

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.kernel
def oscillate(
    first: int,
    amplitude: float,
    frequency: float,
    time: wp.array[wp.float64],
    role: wp.array[int],
    rest_position: wp.array[wp.vec3],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
):
    """Move walls up and down about their ``rest_position`` (n,) [m] by ``amplitude`` [m] at ``frequency`` [Hz]."""
    i = wp.tid() + first
    if role[i] == Role.WALL:
        cycles = time[0] * wp.float64(frequency)
        angle = 2.0 * wp.static(math.pi) * float(cycles - wp.floor(cycles))
        position[i] = rest_position[i] + wp.vec3(0.0, amplitude * wp.sin(angle), 0.0)
        velocity[i] = wp.vec3(0.0, 2.0 * wp.static(math.pi) * frequency * amplitude * wp.cos(angle), 0.0)
