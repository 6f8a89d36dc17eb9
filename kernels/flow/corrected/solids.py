"""What the fluid and the walls of the corrected flow do to solids."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.flow.corrected.scheme import FLUID, SOLID, WALL, FlowConstants, slope_and_weight
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})

PUSH = wp.constant(0.5)  # of a wall on a solid that comes close to its face [c^2 / dx]
STANDING = wp.constant(0.5)  # how close to the face a solid stands [dx]


@wp.func
def stand_on_wall(flow: FlowConstants, d: wp.vec3, to_surface: wp.vec3, sound_speed: float) -> wp.vec3:
    """Acceleration [m/s^2] of a solid at the way ``d`` [m] from a wall particle, away from the wall's face."""
    depth = wp.length(to_surface)
    normal = to_surface / depth
    height = (wp.dot(d, normal) - depth) / flow.spacing
    held = float(0.0)
    if height > -1.0 and height < STANDING:
        held = PUSH * sound_speed * sound_speed * (1.0 - height / STANDING)
    return normal * (held / flow.spacing)


@wp.kernel
def press_on_solids(
    first: int,
    flow: FlowConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    to_surface: wp.array[wp.vec3],
    pressure: wp.array[float],
    viscosity: wp.array[float],
    mass: wp.array[float],
    role: wp.array[int],
    part: wp.array[int],
    shift_velocity: wp.array[wp.vec3],
    acceleration: wp.array[wp.vec3],
):
    """Add to the acceleration (n,) [m/s^2] of solid particles what the fluid and the walls do to them.

    Each pair of a solid and a fluid particle by the sum of their pressures, so that a face bears just the pressure that
    the fluid has there. Viscosity damps bonds along their line only, for all of it would brake the turning of a solid.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE and part[i] == SOLID:
        x_i = position[i]
        u_i = velocity[i]
        c = wp.sqrt(flow.bulk_modulus * flow.volume / mass[i])
        bond_damping = float(flow.dimension) + 2.0  # so that viscosity along bonds alone damps shear as all of it would
        force = wp.vec3()
        held = wp.vec3()
        for k in range(neighbours.count[i]):
            entry = entry_of(neighbours, i, k)
            j = index_of(entry)
            what = part[j]
            if part[j] == FLUID or part[j] == WALL or entry < 0:
                d = difference(neighbours, x_i, position[j])
                r_squared = wp.dot(d, d)
                if r_squared < flow.support * flow.support:
                    F, V_W = slope_and_weight(flow, r_squared)
                    u_ij = u_i - velocity[j]
                    mu_j = viscosity[j]
                    if what == WALL:
                        held += stand_on_wall(flow, d, to_surface[j], c) * V_W
                    elif what == FLUID:
                        force -= d * (F * (pressure[i] + pressure[j]))
                    if entry < 0:
                        u_ij = d * (bond_damping * wp.dot(d, u_ij) / (r_squared + 1.0e-20))
                    force += u_ij * (2.0 * mu_j * F)
        acceleration[i] += force * (flow.volume / mass[i]) + held
        shift_velocity[i] = wp.vec3()
