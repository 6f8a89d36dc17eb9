"""Sums of a smoothing kernel over the mirror images of a particle behind plane walls."""

import warp as wp

from warpsph.kernels.basics.smoothing import cubic_spline_slope, cubic_spline_value
from warpsph.kernels.heat.walls import HeatWalls, height
from warpsph.kernels.neighbours.pairs import NeighbourList, difference

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.func
def mirrors_of(walls: HeatWalls, support: float, x: wp.vec3) -> int:
    """The planes, a bit each, that stand within the support of ``x``; all particles are before all of them."""
    mirrors = int(0)
    for p in range(walls.offset.shape[0]):
        if height(walls, p, x) < support:
            mirrors |= 1 << p
    return mirrors


@wp.func
def image_distance(neighbours: NeighbourList, walls: HeatWalls, planes: int, x_i: wp.vec3, x_j: wp.vec3) -> float:
    """Square of the distance [m^2] from ``x_i`` to the image of ``x_j`` in ``planes`` at right angles, a bit each."""
    d = difference(neighbours, x_i, x_j)
    r_squared = wp.dot(d, d)
    for p in range(walls.offset.shape[0]):
        if (planes >> p) & 1 != 0:
            h_i, h_j = height(walls, p, x_i), height(walls, p, x_j)
            r_squared += 4.0 * (wp.max(h_i, 0.0) * wp.max(h_j, 0.0))
    return r_squared


@wp.func
def image_values(
    neighbours: NeighbourList, walls: HeatWalls, mirrors: int, support: float, x_i: wp.vec3, x_j: wp.vec3
) -> float:
    """Sum of the cubic spline over the images of ``x_j`` in one, two and three of the planes ``mirrors``."""
    total = float(0.0)
    planes = int(mirrors)
    while planes != 0:
        total += cubic_spline_value(image_distance(neighbours, walls, planes, x_i, x_j), support)
        planes = (planes - 1) & mirrors
    return total


@wp.func
def image_slopes(
    neighbours: NeighbourList, walls: HeatWalls, mirrors: int, support: float, x_i: wp.vec3, x_j: wp.vec3
) -> float:
    """Sum of W'/r of the cubic spline over the images of ``x_j``, as :func:`image_values`."""
    total = float(0.0)
    planes = int(mirrors)
    while planes != 0:
        total += cubic_spline_slope(image_distance(neighbours, walls, planes, x_i, x_j), support)
        planes = (planes - 1) & mirrors
    return total
