"""Support rolls: smooth cylinders along the cold faces, which the strand slides over."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.struct
class RollConstants:
    """``face``: x, and in 3D z, of the cold faces, which the rolls touch [m]; ``radius`` [m]; ``heights`` (rolls,) of
    their axes [m]; ``clearance`` of a particle's centre from a surface [m]; ``stiffness`` [N/m], in 2D [N/m^2]."""

    face: float
    radius: float
    heights: wp.array[float]
    clearance: float
    stiffness: float


@wp.func
def depth_in_roll(rolls: RollConstants, roll: int, away: float, height: float) -> wp.vec3:
    """How deep [m] what is ``away`` from the axis of the strand is in a roll, and the normal (away, up) out of it."""
    d = wp.vec2(away - rolls.face - rolls.radius, height - rolls.heights[roll])
    normal = d / wp.max(wp.length(d), 1.0e-6 * rolls.radius)
    return wp.vec3(rolls.radius + rolls.clearance - wp.length(d), normal[0], normal[1])


@wp.kernel
def press(
    first: int,
    rolls: RollConstants,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    mass: wp.array[float],
    acceleration: wp.array[wp.vec3],
):
    """Push free particles out of the rolls: like a spring, along the normal, without friction."""
    i = wp.tid() + first
    if role[i] == Role.FREE:
        x = position[i]
        for axis in range(0, 3, 2):
            if x[axis] > rolls.face - rolls.clearance:
                for roll in range(rolls.heights.shape[0]):
                    contact = depth_in_roll(rolls, roll, x[axis], x[1])
                    if contact[0] > 0.0:
                        push = contact[0] * rolls.stiffness / mass[i]
                        force = wp.vec3(0.0, push * contact[2], 0.0)
                        force[axis] = push * contact[1]
                        acceleration[i] += force
