"""Bringing particles that have left a periodic box back into it, on the opposite side."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.neighbours.pairs import NeighbourList

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.func
def way_back(neighbours: NeighbourList, box_lower: wp.vec3, x: wp.vec3d) -> wp.vec3d:
    """The whole periods [m] that are to be taken from ``x`` [m], so that it is in the box."""
    way = wp.vec3d()
    for axis in range(3):
        if neighbours.period[axis] > 0.0:
            period = wp.float64(neighbours.period[axis])
            way[axis] = period * wp.floor((x[axis] - wp.float64(box_lower[axis])) / period)
    return way


@wp.kernel
def wrap(
    first: int,
    neighbours: NeighbourList,
    box_lower: wp.vec3,
    role: wp.array[int],
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
):
    """Bring the position (n,) [m] into the box, and with it what single precision loses of it."""
    i = wp.tid() + first
    x = wp.vector(position[i], dtype=wp.float64) - wp.vector(position_carry[i], dtype=wp.float64)
    way = way_back(neighbours, box_lower, x)
    if role[i] != Role.RESERVOIR and wp.length_sq(way) > wp.float64(0.0):
        x = x - way
        shown = wp.vector(x, dtype=float)
        position[i] = shown
        position_carry[i] = wp.vector(wp.vector(shown, dtype=wp.float64) - x, dtype=float)


@wp.kernel
def wrap_precisely(first: int, neighbours: NeighbourList, box_lower: wp.vec3, precise_position: wp.array[wp.vec3d]):
    """Bring the position (n,) [m] in double precision into the box."""
    i = wp.tid() + first
    precise_position[i] -= way_back(neighbours, box_lower, precise_position[i])
