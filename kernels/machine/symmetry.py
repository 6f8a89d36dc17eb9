"""A plane that mirrors what crosses it."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role

wp.set_module_options({"enable_backward": False})


@wp.kernel
def reflect(
    first: int,
    dt: float,
    normal: wp.vec3,
    offset: float,
    reach: float,
    role: wp.array[int],
    phase: wp.array[int],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
):
    """Reflect free particles that are behind the plane ``x . normal = offset`` [m]; ``normal`` points inside.

    Solid ones within ``reach`` [m] are kept from moving across it by the step of ``dt`` [s] behind them, as their bonds
    with their mirror images would: an edge that could be drawn away from the plane would let melt through.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE:
        depth = wp.dot(position[i], normal) - offset
        if phase[i] == Phase.SOLID and depth < reach:
            across = wp.dot(velocity[i], normal) * normal
            position[i] -= dt * across
            velocity[i] -= across
        elif depth < 0.0:
            position[i] -= 2.0 * depth * normal
            velocity[i] -= 2.0 * wp.dot(velocity[i], normal) * normal
