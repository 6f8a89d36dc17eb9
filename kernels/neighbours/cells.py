"""Sorting particles into the cells of a regular grid (counting sort)."""

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False})


@wp.struct
class Grid:
    """A box of cells. Particles outside it belong to the nearest cell, which keeps neighbours in adjacent cells."""

    origin: wp.vec3
    inverse_size: float
    nx: int
    ny: int
    nz: int


@wp.func
def cell_coordinate(x: float, inverse_size: float, n: int) -> int:
    return wp.clamp(int(wp.floor(wp.clamp(x * inverse_size, -1.0, float(n)))), 0, n - 1)


@wp.func
def cell_of(grid: Grid, x: wp.vec3) -> wp.vec3i:
    d = x - grid.origin
    return wp.vec3i(
        cell_coordinate(d[0], grid.inverse_size, grid.nx),
        cell_coordinate(d[1], grid.inverse_size, grid.ny),
        cell_coordinate(d[2], grid.inverse_size, grid.nz),
    )


@wp.kernel
def _find_cells(
    first: int,
    grid: Grid,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    material: wp.array[int],
    cell: wp.array[int],
):
    i = wp.tid() + first
    if role[i] == Role.RESERVOIR:
        cell[i] = grid.nx * grid.ny * grid.nz + material[i]
    else:
        c = cell_of(grid, position[i])
        cell[i] = (c[2] * grid.ny + c[1]) * grid.nx + c[0]


@wp.kernel
def _clear(first: int, values: wp.array[int]):
    values[wp.tid() + first] = 0


@wp.kernel
def _count(first: int, cell: wp.array[int], count: wp.array[int], rank: wp.array[int]):
    i = wp.tid() + first
    rank[i] = wp.atomic_add(count, cell[i] + 1, 1)


@wp.kernel
def _running_sum(first: int, values: wp.array[int], length: int):
    for i in range(first + 1, length):
        values[i] += values[i - 1]


@wp.kernel
def _place(first: int, cell: wp.array[int], start: wp.array[int], rank: wp.array[int], order: wp.array[int]):
    i = wp.tid() + first
    order[start[cell[i]] + rank[i]] = i


@wp.kernel
def _sort_within_cells(first: int, start: wp.array[int], order: wp.array[int]):
    c = wp.tid() + first
    for a in range(start[c] + 1, start[c + 1]):
        moved = order[a]
        b = a - 1
        while b >= start[c] and order[b] > moved:
            order[b + 1] = order[b]
            b -= 1
        order[b + 1] = moved


def sort_into_cells(launch, grid: Grid, position, role, material, cell, rank, start, order) -> None:
    """Order particles by cell, and within a cell by their present place, so that the result is reproducible.

    Particles in the reservoir come last, by material: behind the cells of the grid, ``start`` has one cell a material.

    Args:
        launch: the executor.
        grid: the cells.
        position: (n,) [m]; role: (n,); material: (n,).
        cell, rank: (n,) scratch.
        start: (cells + materials + 1,) index of each cell's first particle in ``order``.
        order: (n,) on return the present index of the particle that shall stand at each place.
    """
    n = position.shape[0]
    launch(_find_cells, n, [grid, position, role, material, cell])
    launch(_clear, start.shape[0], [start])
    launch.whole(_count, n, [cell, start, rank])
    if launch.on_cuda:
        wp.utils.array_scan(start, start, inclusive=True)
    else:
        launch.whole(_running_sum, 1, [start, start.shape[0]])
    launch(_place, n, [cell, start, rank, order])
    launch(_sort_within_cells, start.shape[0] - 1, [start, order])
