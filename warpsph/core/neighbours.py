"""The neighbour list of a simulation: when it is renewed, and the sorting that goes with it."""

from collections.abc import Callable

import numpy as np
import warp as wp

from warpsph.core.footprint import row_capacity
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.periodic import PeriodicBox
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.kernels.neighbours.cells import (
    Grid,
    clear,
    count_particles,
    find_cells,
    place_particles,
    sort_within_cells,
)
from warpsph.kernels.neighbours.lists import clear_flag, list_neighbours
from warpsph.kernels.neighbours.pairs import NeighbourList
from warpsph.kernels.neighbours.reorder import COPY, GATHER
from warpsph.kernels.neighbours.scan import PARTS, sum_before_parts, sum_parts, sum_within_parts

MOST_CELLS = 2**25


class Neighbours:
    """A list of all pairs within reach + skin, renewed on the device when a particle has moved half the skin.

    The state gets ``neighbours``, the rows for the kernels; ``outdated`` (1,), not zero when the list must be renewed
    before the next use; ``reference`` (n,), the positions at which it was made; ``renewals`` (1,), how often;
    ``longest_row`` (1,), not zero when a row was too short; and ``reservoir_start`` (materials + 1,), the index of the
    first particle in the reservoir by material, and the number of particles.

    Args:
        launch: launches.
        model: gives dimension, spacing and number of materials.
        state: the particles; they are sorted by cell at every renewal.
        reach: farthest distance of two neighbours [m].
        skin: added to the reach [m].
        lower, upper: the box (3,) that holds most particles [m]; others are found too, only slower. Along periodic axes
            it is that of the model; in the plane it has one layer of cells.
        before_sorting: done before particles are sorted.
        on_sorted: done when the particles have been sorted; ``order`` and ``place`` are known to its launches.
        on_listed: done when the list has been made.

    Raises:
        InputError: the box is too large for the reach, or a period of it too short.
    """

    def __init__(
        self,
        launch: Launch,
        model: Model,
        state: State,
        reach: float,
        skin: float,
        lower: np.ndarray,
        upper: np.ndarray,
        before_sorting: Callable[[], None] = lambda: None,
        on_sorted: Callable[[], None] = lambda: None,
        on_listed: Callable[[], None] = lambda: None,
    ):
        self.state = state
        self.radius, self.half_skin = reach + skin, 0.5 * skin
        self._before_sorting, self._on_sorted, self._on_listed = before_sorting, on_sorted, on_listed
        lower, upper = np.array(lower, float), np.array(upper, float)
        lower[model.dimension :] = upper[model.dimension :] = 0.0
        self.grid = _grid(lower, upper, self.radius, model.periodic)
        self._cells = self.grid.nx * self.grid.ny * self.grid.nz
        self._places = self._cells + len(model.materials)
        self._hold_arrays(launch.executor.on_cuda, model)
        self.launch = launch.within({"grid": self.grid, "radius": self.radius})
        types = {name: field.dtype for field in state.fields.values() for name in (field.name, field.carry_name)}
        self._moves = [
            (types[name], array, state.hold(f"spare.{name}", wp.empty_like(array), scratch=True))
            for name, array in state.kept.items()
        ]

    def renew_if_outdated(self) -> None:
        """Sort the particles and list the neighbours anew if ``outdated`` says so."""
        self.launch.when("outdated", self._renew)

    def _renew(self) -> None:
        self._before_sorting()
        self._sort_into_cells()
        with self.launch.section():
            for dtype, array, spare in self._moves:
                self.launch(GATHER[dtype], source=array, target=spare)
        with self.launch.section():
            for dtype, array, spare in self._moves:
                self.launch(COPY[dtype], source=spare, target=array)
        self._on_sorted()
        self.launch(list_neighbours)
        self._on_listed()
        self.launch(COPY[wp.vec3], source=self.state.position, target=self.state.reference)
        self.launch.whole(clear_flag, flag=self.state.outdated, counter=self.state.renewals)

    def _sort_into_cells(self) -> None:
        """Order particles by cell, and within a cell by their present place, so that the result is reproducible.

        Particles in the reservoir come last, by material: behind the cells of the grid, ``start`` has one a material.
        """
        launch, start = self.launch, self.state.start
        launch(find_cells)
        launch(clear, self._places + 1, values=start)
        launch.whole(count_particles, launch.count)
        launch(sum_parts, PARTS, values=start)
        launch.whole(sum_before_parts)
        launch(sum_within_parts, PARTS, values=start)
        launch(place_particles)
        launch(sort_within_cells, self._places)

    def _hold_arrays(self, on_cuda: bool, model: Model) -> None:
        state, n = self.state, self.state.count
        rows = NeighbourList()
        rows.capacity = row_capacity(model, self.radius)
        rows.count = wp.zeros(n, dtype=int, device=state.device)
        rows.entry = wp.zeros(n * rows.capacity, dtype=int, device=state.device)
        if model.periodic is not None:
            rows.periodic = -1
            rows.period, rows.inverse_period = wp.vec3(*model.periodic.lengths), wp.vec3(*model.periodic.inverse)
        rows.row_stride, rows.entry_stride = (1, n) if on_cuda else (rows.capacity, 1)
        state.hold_list("neighbours", rows)
        state.hold("reference", wp.zeros(n, dtype=wp.vec3, device=state.device))
        state.hold("outdated", wp.ones(1, dtype=int, device=state.device))
        for name in ("renewals", "longest_row"):
            state.hold(name, wp.zeros(1, dtype=int, device=state.device))
        state.hold("start", wp.zeros(self._places + 1, dtype=int, device=state.device))
        state.hold("reservoir_start", state.start[self._cells :])
        for name, size in (("cell", n), ("rank", n), ("order", n), ("place", n), ("row_length", n), ("parts", PARTS)):
            state.hold(name, wp.zeros(size, dtype=int, device=state.device), scratch=True)


def _grid(lower: np.ndarray, upper: np.ndarray, radius: float, periodic: PeriodicBox | None) -> Grid:
    """Cells as wide as ``radius`` [m] from ``lower`` to ``upper``; along periodic axes a whole number of wider ones."""
    cells, size = np.maximum(np.ceil((upper - lower) / radius), 1.0), np.full(3, radius)
    grid = Grid()
    if periodic is not None:
        axes = list(periodic.axes)
        cells[axes] = periodic.cells(radius)[axes]
        size[axes] = periodic.edges[axes] / cells[axes]
        lower = np.where(periodic.edges > 0.0, periodic.lower, lower)
        grid.wraps = wp.vec3i(*(int(axis in axes) for axis in range(3)))
    grid.origin, grid.inverse_size = wp.vec3(*lower), wp.vec3(*(1.0 / size))
    if np.prod(cells) > MOST_CELLS:
        upper = np.where(periodic.edges > 0.0, lower + periodic.edges, upper) if periodic else upper
        corners = " to ".join(f"({', '.join(f'{x:.6g}' for x in corner)})" for corner in (lower, upper))
        raise InputError(
            f"the box from {corners} m has {np.prod(cells):.2g} cells of {radius:.3g} m, "
            f"{MOST_CELLS:.2g} at most; give lower and upper around where most particles are"
        )
    grid.nx, grid.ny, grid.nz = (int(m) for m in cells)
    return grid
