"""Filling the neighbour list from sorted cells, and deciding when it has become too old."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.neighbours.cells import Grid, cell_beside, cell_of
from warpsph.kernels.neighbours.pairs import NeighbourList, difference

wp.set_module_options({"enable_backward": False})


@wp.kernel
def list_neighbours(
    first: int,
    grid: Grid,
    start: wp.array[int],
    position: wp.array[wp.vec3],
    role: wp.array[int],
    radius: float,
    neighbours: NeighbourList,
    row_length: wp.array[int],
    longest_row: wp.array[int],
):
    """Write every pair closer than ``radius`` [m] into the rows of both (pairs of dummies excepted).

    Particles must stand in the order of their cells. A row that would overflow is cut; ``row_length`` (n,) has the full
    lengths, and ``longest_row`` (1,) is not zero where one is cut.
    """
    i = wp.tid() + first
    n = int(0)
    if role[i] != Role.RESERVOIR:
        x_i = position[i]
        c = cell_of(grid, x_i)
        for place in range(27):
            cell = cell_beside(grid, c, place)
            if cell >= 0:
                for j in range(start[cell], start[cell + 1]):
                    d = difference(neighbours, x_i, position[j])
                    if (
                        wp.dot(d, d) < radius * radius
                        and j != i
                        and not (role[i] == Role.DUMMY and role[j] == Role.DUMMY)
                    ):
                        if n < neighbours.capacity:
                            neighbours.entry[i * neighbours.row_stride + n * neighbours.entry_stride] = j
                        n += 1
        if n > neighbours.capacity:
            wp.atomic_max(longest_row, 0, n)
    row_length[i] = n
    neighbours.count[i] = wp.min(n, neighbours.capacity)


@wp.kernel
def clear_flag(first: int, flag: wp.array[int], counter: wp.array[int]):
    """Set ``flag`` (1,) to zero and count the event in ``counter`` (1,); one thread."""
    flag[0] = 0
    counter[0] += 1
