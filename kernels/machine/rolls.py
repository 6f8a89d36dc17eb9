"""Support rolls: smooth cylinders along the cold faces, which the strand slides over."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.struct
class RollConstants:
    """``face``: x, and in 3D z, of the cold faces, which the rolls touch [m]; ``radius`` [m]; ``heights`` (rolls,) of
    their axes [m]; ``clearance`` of a particle's centre from a surface [m]; ``reach`` from a surface within which it
    pushes [m]; ``stiffness`` by which the push grows with the square of the depth [N/m^2], in 2D [N/m^3]."""

    face: float
    radius: float
    heights: wp.array[float]
    clearance: float
    reach: float
    stiffness: float


@wp.func
def way_from_roll(rolls: RollConstants, roll: int, away: float, height: float) -> wp.vec3:
    """Distance [m] of what is ``away`` from the axis of the strand from a roll, and the normal (away, up) out of it."""
    d = wp.vec2(away - rolls.face - rolls.radius, height - rolls.heights[roll])
    normal = d / wp.max(wp.length(d), 1.0e-6 * rolls.radius)
    return wp.vec3(wp.length(d) - rolls.radius, normal[0], normal[1])


@wp.kernel
def press(
    first: int,
    rolls: RollConstants,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    mass: wp.array[float],
    acceleration: wp.array[wp.vec3],
):
    """Push free particles out of the rolls, along the normal, without friction.

    The push begins softly, with the square of the depth, so that several particles of a row carry a roll: a shell that
    rests on the one at the apex is held back by it, and snaps past.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE:
        x = position[i]
        for axis in range(0, 3, 2):
            if x[axis] > rolls.face - rolls.reach:
                for roll in range(rolls.heights.shape[0]):
                    way = way_from_roll(rolls, roll, x[axis], x[1])
                    depth = rolls.reach - way[0]
                    if depth > 0.0:
                        push = depth * depth * rolls.stiffness / mass[i]
                        force = wp.vec3(0.0, push * way[2], 0.0)
                        force[axis] = push * way[1]
                        acceleration[i] += force
