"""Motion of particles besides that of the fluid, which keeps them evenly spread."""

import warp as wp

from warpsph.kernels.basics.compensation import compensated_sum
from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def shift_half(
    first: int,
    dt: float,
    role: wp.array[int],
    shift_velocity: wp.array[wp.vec3],
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
):
    """Add half of ``shift_velocity * dt`` to the position (n,) [m] of free particles, compensated."""
    i = wp.tid() + first
    if role[i] == Role.FREE:
        x, carry = compensated_sum(position[i], shift_velocity[i] * (0.5 * dt), position_carry[i])
        position[i] = x
        position_carry[i] = carry
