"""The highest speeds that solid particles have had."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role
from warpsph.kernels.solid.bonds import BondList

wp.set_module_options({"enable_backward": False})


@wp.kernel
def note_speed(
    first: int,
    row: int,
    role: wp.array[int],
    phase: wp.array[int],
    velocity: wp.array[wp.vec3],
    bonds: BondList,
    fastest_squared: wp.array[float],
    fastest_grain_squared: wp.array[float],
):
    """Raise ``fastest_squared`` and ``fastest_grain_squared``, each (1,) [m^2/s^2], to the highest of free solid
    particles; any order gives the same.

    A grain is a particle with fewer bonds than one inside a ``row`` of particles has: it hangs in the melt.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE and phase[i] == Phase.SOLID:
        squared = wp.dot(velocity[i], velocity[i])
        if bonds.count[i] < row:
            if squared > fastest_grain_squared[0]:
                wp.atomic_max(fastest_grain_squared, 0, squared)
        elif squared > fastest_squared[0]:
            wp.atomic_max(fastest_squared, 0, squared)
