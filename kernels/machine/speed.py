"""The highest speed that solid particles have had."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role

wp.set_module_options({"enable_backward": False})


@wp.kernel
def note_speed(
    first: int,
    role: wp.array[int],
    phase: wp.array[int],
    velocity: wp.array[wp.vec3],
    fastest_squared: wp.array[float],
):
    """Raise ``fastest_squared`` (1,) [m^2/s^2] to the highest of the free solid particles; any order gives the same."""
    i = wp.tid() + first
    if role[i] == Role.FREE and phase[i] == Phase.SOLID:
        squared = wp.dot(velocity[i], velocity[i])
        if squared > fastest_squared[0]:
            wp.atomic_max(fastest_squared, 0, squared)
