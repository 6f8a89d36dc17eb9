"""A floor that reflects what falls through it, damped or, where it is hot, faster than it came."""

import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.struct
class FloorConstants:
    """What a floor gives back of the vertical speed: ``cold``, and in ``|x| < hot_half_width`` [m] what is hot.

    There it is ``hot - slope (x + hot_half_width)``, with ``slope`` in 1/m.
    """

    cold: wp.float64
    hot: wp.float64
    slope: wp.float64
    hot_half_width: wp.float64


@wp.func
def returned(base: FloorConstants, x: wp.float64) -> wp.float64:
    """Share of the vertical speed that is returned at ``x`` [m]."""
    if wp.abs(x) < base.hot_half_width:
        return base.hot - base.slope * (x + base.hot_half_width)  # Greenspan (5.1)
    return base.cold


@wp.kernel
def reflect(
    first: int, base: FloorConstants, precise_position: wp.array[wp.vec3d], precise_velocity: wp.array[wp.vec3d]
):
    """Put back above y = 0 what has fallen below, stop it along the floor, and turn its vertical velocity (n,)."""
    i = wp.tid() + first
    x = precise_position[i]
    if x[1] < wp.float64(0.0):
        u = precise_velocity[i]
        precise_position[i] = wp.vec3d(x[0], -x[1], x[2])  # Greenspan (3.1)
        precise_velocity[i] = wp.vec3d(wp.float64(0.0), -returned(base, x[0]) * u[1], wp.float64(0.0))
