"""The neighbour list as the kernels see it: a row of entries for each particle, and the way from one to another."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.struct
class NeighbourList:
    """Rows of neighbours. An entry is the neighbour's index j, or ``-1 - j`` where the pair is bonded.

    ``count`` (n,); ``entry`` (n * capacity,), addressed by two strides so that a CPU reads rows and a GPU columns.
    ``periodic`` is 1 in a periodic box; there ``period`` [m] has its edges and ``inverse_period`` [1/m] the inverse of
    these, both 0 along axes that are not periodic.
    """

    count: wp.array[int]
    entry: wp.array[int]
    capacity: int
    row_stride: int
    entry_stride: int
    periodic: int
    period: wp.vec3
    inverse_period: wp.vec3


@wp.func
def entry_of(neighbours: NeighbourList, i: int, k: int) -> int:
    return neighbours.entry[i * neighbours.row_stride + k * neighbours.entry_stride]


@wp.func
def index_of(entry: int) -> int:
    return wp.where(entry < 0, -1 - entry, entry)


@wp.func
def difference(neighbours: NeighbourList, x_i: wp.vec3, x_j: wp.vec3) -> wp.vec3:
    """x_i - x_j [m], in a periodic box to the nearest image; every pair of particles takes its distance from here."""
    d = x_i - x_j
    if neighbours.periodic == 0:
        return d
    period, inverse = neighbours.period, neighbours.inverse_period
    return wp.vec3(
        d[0] - period[0] * wp.rint(d[0] * inverse[0]),
        d[1] - period[1] * wp.rint(d[1] * inverse[1]),
        d[2] - period[2] * wp.rint(d[2] * inverse[2]),
    )


@wp.func
def difference_of_doubles(neighbours: NeighbourList, x_i: wp.vec3d, x_j: wp.vec3d) -> wp.vec3d:
    """The same in double precision."""
    d = x_i - x_j
    if neighbours.periodic == 0:
        return d
    period = wp.vector(neighbours.period, dtype=wp.float64)
    inverse = wp.vector(neighbours.inverse_period, dtype=wp.float64)
    return wp.vec3d(
        d[0] - period[0] * wp.rint(d[0] * inverse[0]),
        d[1] - period[1] * wp.rint(d[1] * inverse[1]),
        d[2] - period[2] * wp.rint(d[2] * inverse[2]),
    )


@wp.func
def precise_difference(
    neighbours: NeighbourList, position: wp.array[wp.vec3], position_carry: wp.array[wp.vec3], i: int, j: int
) -> wp.vec3:
    """x_i - x_j with what single precision has lost of both: for bonds, where a small difference of it is a strain."""
    if neighbours.periodic == 0:
        return (position[i] - position[j]) - (position_carry[i] - position_carry[j])
    # across the border the places differ by a period, and their difference would be rounded like that
    d = difference_of_doubles(
        neighbours, wp.vector(position[i], dtype=wp.float64), wp.vector(position[j], dtype=wp.float64)
    )
    return wp.vector(d, dtype=float) - (position_carry[i] - position_carry[j])
