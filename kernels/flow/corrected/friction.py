"""Friction of a boundary layer that is thinner than the particles, along walls at which the corrected flow slips."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.flow.corrected.scheme import FLUID, WALL, FlowConstants, slope_of
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})

BLASIUS = wp.constant(0.0225)
NEAREST_TO_FACE = wp.constant(0.25)  # least height at which a particle has its velocity [dx]


@wp.func
def friction_of_speed(speed: float, height: float, viscosity: float) -> float:
    """Stress on a smooth wall over density and speed [m/s], where the ``speed`` [m/s] is that at a ``height`` [m].

    The friction of a turbulent profile by the seventh root of the height (Schlichting 1979, chapter 21, after Blasius),
    or that of the viscous layer, whichever is greater; ``viscosity`` is the kinematic one [m^2/s]. For
    u y / nu from 500 to 1e4 the speed is within 6 % of the logarithmic profile with that stress.
    """
    viscous = viscosity / height
    return wp.max(viscous, BLASIUS * wp.sqrt(wp.sqrt(viscous * speed * speed * speed)))


@wp.kernel
def rub_at_walls(
    first: int,
    flow: FlowConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    to_surface: wp.array[wp.vec3],
    viscosity: wp.array[float],
    mass: wp.array[float],
    role: wp.array[int],
    part: wp.array[int],
    acceleration: wp.array[wp.vec3],
):
    """Add the acceleration (n,) [m/s^2] of free fluid particles by the friction at walls without viscosity.

    The stress at a face is spread over the particles before it by twice the gradient of the walls' share of the sums,
    which on the lattice adds up to the face.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE and part[i] == FLUID:
        x_i = position[i]
        u_i = velocity[i]
        nu = viscosity[i] * flow.volume / mass[i]
        rubbed = wp.vec3()
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if part[j] == WALL and viscosity[j] == 0.0:
                d = difference(neighbours, x_i, position[j])
                r_squared = wp.dot(d, d)
                if r_squared < flow.support * flow.support:
                    depth = wp.length(to_surface[j])
                    normal = to_surface[j] / depth
                    across = wp.dot(d, normal)
                    height = wp.max(across - depth, NEAREST_TO_FACE * flow.spacing)
                    u = u_i - velocity[j]
                    along = u - normal * wp.dot(u, normal)
                    of_face = -2.0 * slope_of(flow, r_squared) * wp.max(across, 0.0)
                    rubbed -= along * (of_face * friction_of_speed(wp.length(along), height, nu))
        acceleration[i] += rubbed
