"""What walls show to the corrected flow: pressure and velocity, continued from the fluid in front of them."""

import warp as wp

from warpsph.kernels.basics.smoothing import wendland_c2_value
from warpsph.kernels.flow.corrected.scheme import FLUID, SOLID, WALL, FlowConstants
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})

NEAREST_TO_WALL = wp.constant(0.5)  # least distance, in spacings, at which a particle counts for the fit


@wp.kernel
def continue_into_walls(
    first: int,
    flow: FlowConstants,
    gravity: wp.vec3,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    to_surface: wp.array[wp.vec3],
    viscosity: wp.array[float],
    mass: wp.array[float],
    part: wp.array[int],
    pressure: wp.array[float],
    compression: wp.array[float],
    ghost_velocity: wp.array[wp.vec3],
):
    """Write the ``pressure`` [Pa], ``compression`` and ``ghost_velocity`` [m/s] of walls and solids, each (n,).

    Pressure after Adami, Hu & Adams (2012), equation 27. The velocity is a linear fit to that of the fluid which takes
    the wall's own at the wall's face; ``to_surface`` (n,) [m] leads there. Along a wall without viscosity the fluid
    slips: there only the part across the face is fitted, the rest is the fluid's mean. A solid has its own velocity.
    """
    i = wp.tid() + first
    if part[i] == WALL or part[i] == SOLID:
        x_i = position[i]
        u_i = velocity[i]
        depth = wp.length(to_surface[i])
        normal = to_surface[i] / wp.max(depth, 1.0e-12)
        least = NEAREST_TO_WALL * flow.spacing
        weight = float(0.0)
        weighted_pressure = float(0.0)
        weighted_velocity = wp.vec3()
        rise = wp.vec3()
        lever = float(0.0)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if part[j] == FLUID:
                d = difference(neighbours, x_i, position[j])
                r_squared = wp.dot(d, d)
                if r_squared < flow.support * flow.support:
                    W = wendland_c2_value(r_squared, flow.support)
                    u = velocity[j] - u_i
                    height = -wp.dot(d, normal) - depth
                    weight += W
                    weighted_pressure += W * (pressure[j] + mass[j] / flow.volume * wp.dot(gravity, d))
                    weighted_velocity += u * W
                    if height > -least:  # what is farther behind the face is in front of another one
                        height = wp.max(height, least)
                        rise += u * (W * height)
                        lever += W * height * height
        p = float(0.0)
        ghost = u_i
        if weight > 0.0:
            p = weighted_pressure / weight
        if weight > 0.0 and part[i] == WALL:
            fitted = rise * (-depth / wp.max(lever, 1.0e-30))
            if viscosity[i] == 0.0:
                mean = weighted_velocity / weight
                fitted = mean + normal * wp.dot(fitted - mean, normal)
            ghost = u_i + fitted
        if flow.free_surface != 0:
            p = wp.max(p, 0.0)
        pressure[i] = p
        compression[i] = p / flow.bulk_modulus
        ghost_velocity[i] = ghost
