"""Faces of walls, through which no fluid particle may pass in a step."""

import warp as wp

from warpsph.kernels.flow.corrected.scheme import WALL, FlowConstants
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})

STOP_RANGE = wp.constant(1.0)  # within which nothing may come closer to the face in a step than by half [dx]
BEHIND = wp.constant(2.0)  # how far behind the face it is brought back; walls are three layers thick [dx]


@wp.func
def stop_at_faces(
    flow: FlowConstants,
    dt: float,
    i: int,
    motion: wp.vec3,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    to_surface: wp.array[wp.vec3],
    part: wp.array[int],
):
    """The acceleration [m/s^2] which a particle that moves by ``motion`` [m/s] in the coming step needs to halve its
    distance to the face of a wall at most, or, behind it, to come back by half. Only the face right before it counts:
    at an edge that stands out into the fluid it is behind the other one. What is far behind has not passed the face: it
    is on the other side of the wall.
    """
    stopped = motion
    for k in range(neighbours.count[i]):
        j = index_of(entry_of(neighbours, i, k))
        if part[j] == WALL:
            d = difference(neighbours, position[i], position[j])
            if wp.dot(d, d) < flow.support * flow.support:
                depth = wp.length(to_surface[j])
                normal = to_surface[j] / depth
                across = wp.dot(d, normal)
                height = across - depth
                in_range = height < STOP_RANGE * flow.spacing and height > -BEHIND * flow.spacing
                if in_range and wp.length(d - across * normal) < flow.beside:
                    excess = -0.5 * height / dt - wp.dot(stopped - velocity[j], normal)
                    stopped += normal * wp.max(excess, 0.0)
    return (stopped - motion) / dt
