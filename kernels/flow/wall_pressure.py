"""The pressure that walls and dummies show to the fluid: extrapolated from the fluid in front of them."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.roles import is_fluid
from warpsph.kernels.basics.smoothing import poly6_value
from warpsph.kernels.flow.fluid import FluidConstants
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.kernel
def extrapolate_pressure(
    first: int,
    fluid: FluidConstants,
    gravity: wp.vec3,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    density: wp.array[float],
    role: wp.array[int],
    pressure: wp.array[float],
):
    """Write the pressure [Pa] of walls and dummies (Adami, Hu & Adams 2012, equation 27).

    It continues the hydrostatic gradient of the fluid through the wall, so that a fluid at rest feels no force there.
    """
    i = wp.tid() + first
    if role[i] == Role.WALL or role[i] == Role.DUMMY:
        x_i = position[i]
        weighted = float(0.0)
        weight = float(0.0)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if is_fluid(role[j]):
                d = difference(neighbours, x_i, position[j])
                w = poly6_value(wp.dot(d, d), fluid.support) * fluid.density_scale
                weighted += w * (pressure[j] + density[j] * wp.dot(gravity, d))  # Adami (27), wall not accelerated
                weight += w
        p = float(0.0)
        if weight > 0.0:
            p = wp.max(weighted / weight, fluid.lowest_pressure)
        pressure[i] = p
