"""Which particles are fluid, for kernels and for the host."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.func
def is_fluid(role: int) -> bool:
    """Whether a particle flows: moved by the forces, by the inlet or by the outflow."""
    return role == Role.FREE or role == Role.INFLOW or role == Role.OUTFLOW


FLUID_ROLES = tuple(role for role in Role if is_fluid.func(role))
