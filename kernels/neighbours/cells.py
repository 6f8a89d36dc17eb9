"""Sorting particles into the cells of a regular grid (counting sort)."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.struct
class Grid:
    """A box of cells. Particles outside it belong to the nearest cell, which keeps neighbours in adjacent cells.

    ``wraps`` is 1 along axes on which the last cell is beside the first one.
    """

    origin: wp.vec3
    inverse_size: wp.vec3
    nx: int
    ny: int
    nz: int
    wraps: wp.vec3i


@wp.func
def cell_coordinate(x: float, inverse_size: float, n: int) -> int:
    return wp.clamp(int(wp.floor(wp.clamp(x * inverse_size, -1.0, float(n)))), 0, n - 1)


@wp.func
def cell_of(grid: Grid, x: wp.vec3) -> wp.vec3i:
    d = x - grid.origin
    return wp.vec3i(
        cell_coordinate(d[0], grid.inverse_size[0], grid.nx),
        cell_coordinate(d[1], grid.inverse_size[1], grid.ny),
        cell_coordinate(d[2], grid.inverse_size[2], grid.nz),
    )


@wp.func
def along(c: int, n: int, wraps: int) -> int:
    """Which of ``n`` cells along an axis is the one at ``c``, -1 where there is none."""
    if c >= 0 and c < n:
        return c
    return wp.where(wraps != 0, (c + n) % n, -1)


@wp.func
def number_of(grid: Grid, c: wp.vec3i) -> int:
    return (c[2] * grid.ny + c[1]) * grid.nx + c[0]


@wp.func
def cell_beside(grid: Grid, c: wp.vec3i, place: int) -> int:
    """Number of one of the 27 cells around ``c``, itself among them, in rising order; -1 where there is none.

    A grid that wraps has three cells or more along that axis, so that no cell stands at two places.
    """
    x = along(c[0] + place % 3 - 1, grid.nx, grid.wraps[0])
    y = along(c[1] + place // 3 % 3 - 1, grid.ny, grid.wraps[1])
    z = along(c[2] + place // 9 - 1, grid.nz, grid.wraps[2])
    return wp.where(x < 0 or y < 0 or z < 0, -1, number_of(grid, wp.vec3i(x, y, z)))


@wp.kernel
def find_cells(
    first: int,
    grid: Grid,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    material: wp.array[int],
    cell: wp.array[int],
):
    """Write the ``cell`` (n,) of each particle; behind the grid there is one cell a material for the reservoir."""
    i = wp.tid() + first
    if role[i] == Role.RESERVOIR:
        cell[i] = grid.nx * grid.ny * grid.nz + material[i]
    else:
        cell[i] = number_of(grid, cell_of(grid, position[i]))


@wp.kernel
def clear(first: int, values: wp.array[int]):
    """Set ``values`` (n,) to zero."""
    values[wp.tid() + first] = 0


@wp.kernel
def count_particles(first: int, cell: wp.array[int], start: wp.array[int], rank: wp.array[int]):
    """Count the particles of every cell into ``start`` (cells + 1,), one place further on; not to be cut into slices.

    ``rank`` (n,) numbers the particles of a cell, in any order.
    """
    i = wp.tid() + first
    rank[i] = wp.atomic_add(start, cell[i] + 1, 1)


@wp.kernel
def place_particles(first: int, cell: wp.array[int], start: wp.array[int], rank: wp.array[int], order: wp.array[int]):
    """Write into ``order`` (n,) which particle shall stand at each place; ``start`` is by now a running sum."""
    i = wp.tid() + first
    order[start[cell[i]] + rank[i]] = i


@wp.kernel
def sort_within_cells(first: int, start: wp.array[int], order: wp.array[int]):
    """Order the particles of each cell by their present place, so that the result is reproducible."""
    c = wp.tid() + first
    for a in range(start[c] + 1, start[c + 1]):
        moved = order[a]
        b = a - 1
        while b >= start[c] and order[b] > moved:
            order[b + 1] = order[b]
            b -= 1
        order[b + 1] = moved
