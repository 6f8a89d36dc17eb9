"""The neighbour list as the kernels see it: a row of entries for each particle."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.struct
class NeighbourList:
    """Rows of neighbours. An entry is the neighbour's index j, or ``-1 - j`` where the pair is bonded.

    ``count`` (n,); ``entry`` (n * capacity,), addressed by two strides so that a CPU reads rows and a GPU columns.
    """

    count: wp.array[int]
    entry: wp.array[int]
    capacity: int
    row_stride: int
    entry_stride: int


@wp.func
def entry_of(neighbours: NeighbourList, i: int, k: int) -> int:
    return neighbours.entry[i * neighbours.row_stride + k * neighbours.entry_stride]


@wp.func
def index_of(entry: int) -> int:
    return wp.where(entry < 0, -1 - entry, entry)


@wp.func
def precise_difference(position: wp.array[wp.vec3], position_carry: wp.array[wp.vec3], i: int, j: int) -> wp.vec3:
    """x_i - x_j with what single precision has lost of both: for bonds, where a small difference of it is a strain."""
    return (position[i] - position[j]) - (position_carry[i] - position_carry[j])
