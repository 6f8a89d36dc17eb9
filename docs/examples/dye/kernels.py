"""What runs on the device: the diffusion of a dye between neighbours."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import wendland_c2_slope
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.kernel
def sum_dye(
    first: int,
    neighbours: NeighbourList,
    support: float,
    scale: float,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    dye: wp.array[float],
    dye_rate: wp.array[float],
):
    """Write the change of the dye (n,) in unit time [1/s]; ``scale`` holds diffusivity, volume and normalisation."""
    i = wp.tid() + first
    total = float(0.0)
    for k in range(neighbours.count[i]):
        j = index_of(entry_of(neighbours, i, k))
        if role[j] == Role.FREE:
            d = difference(neighbours, position[i], position[j])
            total += (dye[i] - dye[j]) * wendland_c2_slope(wp.dot(d, d), support)
    dye_rate[i] = 2.0 * scale * total  # the sum of Vijaykumar (3.2)


@wp.kernel
def add_dye(first: int, dt: float, dye_rate: wp.array[float], dye: wp.array[float]):
    """Advance the dye (n,) by ``dt`` [s]."""
    i = wp.tid() + first
    dye[i] += dye_rate[i] * dt
