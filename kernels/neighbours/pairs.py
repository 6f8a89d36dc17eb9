"""The neighbour list as the kernels see it: a row of entries for each particle, and the way from one to another."""

import warp as wp

wp.set_module_options({"enable_backward": False})

# The mask changes no index. It tells the compiler that none is negative, so that none has to be counted from the end.
NOT_NEGATIVE = wp.constant(0x7FFFFFFF)


@wp.struct
class NeighbourList:
    """Rows of neighbours. An entry is the neighbour's index j, or ``-1 - j`` where the pair is bonded.

    ``count`` (n,); ``entry`` (n * capacity,), addressed by two strides so that a CPU reads rows and a GPU columns.
    ``periodic`` is -1 in a periodic box: compilers take a negative number for the rare case. ``period`` [m] has the
    edges of that box and ``inverse_period`` [1/m] the inverse of these, both 0 along axes that are not periodic.
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
    return neighbours.entry[(i * neighbours.row_stride + k * neighbours.entry_stride) & NOT_NEGATIVE]


@wp.func
def index_of(entry: int) -> int:
    return wp.where(entry < 0, -1 - entry, entry) & NOT_NEGATIVE


@wp.func
def to_nearest(d: wp.vec3, period: wp.vec3, inverse: wp.vec3) -> wp.vec3:
    """The way ``d`` [m] less the whole periods in it."""
    return wp.vec3(
        d[0] - period[0] * wp.rint(d[0] * inverse[0]),
        d[1] - period[1] * wp.rint(d[1] * inverse[1]),
        d[2] - period[2] * wp.rint(d[2] * inverse[2]),
    )


@wp.func
def difference(neighbours: NeighbourList, x_i: wp.vec3, x_j: wp.vec3) -> wp.vec3:
    """x_i - x_j [m], in a periodic box to the nearest image; every pair of particles takes its distance from here."""
    d = x_i - x_j
    if neighbours.periodic < 0:
        d = to_nearest(d, neighbours.period, neighbours.inverse_period)
    return d


@wp.func
def difference_of_doubles(neighbours: NeighbourList, x_i: wp.vec3d, x_j: wp.vec3d) -> wp.vec3d:
    """The same in double precision."""
    d = x_i - x_j
    if neighbours.periodic >= 0:
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
    lost = position_carry[i] - position_carry[j]
    if neighbours.periodic < 0:
        # across the border the places differ by a period, and their difference would be rounded like that
        x_i, x_j = wp.vector(position[i], dtype=wp.float64), wp.vector(position[j], dtype=wp.float64)
        return wp.vector(difference_of_doubles(neighbours, x_i, x_j), dtype=float) - lost
    return (position[i] - position[j]) - lost
