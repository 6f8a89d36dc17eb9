"""A plane that mirrors what crosses it."""

import warp as wp

from warpsph.kernels.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.kernel
def _reflect(
    first: int,
    normal: wp.vec3,
    offset: float,
    role: wp.array[int],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
):
    i = wp.tid() + first
    if role[i] == Role.FREE:
        depth = wp.dot(position[i], normal) - offset
        if depth < 0.0:
            position[i] -= 2.0 * depth * normal
            velocity[i] -= 2.0 * wp.dot(velocity[i], normal) * normal


def reflect(launch, normal, offset, role, position, velocity) -> None:
    """Reflect free particles that are behind the plane ``x . normal = offset`` [m]; ``normal`` points inside."""
    launch(_reflect, role.shape[0], [wp.vec3(*normal), offset, role, position, velocity])
