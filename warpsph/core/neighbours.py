"""The neighbour list of a simulation: when it is renewed, and the sorting that goes with it."""

import numpy as np
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.state import State
from warpsph.kernels.neighbours.cells import Grid, sort_into_cells
from warpsph.kernels.neighbours.lists import clear_flag, list_neighbours
from warpsph.kernels.neighbours.pairs import NeighbourList
from warpsph.kernels.neighbours.reorder import copy, invert, reorder, words
from warpsph.kernels.solid import bonds as bond_kernels


class Neighbours:
    """A list of all pairs within support + skin, renewed on the device when a particle has moved half the skin.

    Args:
        executor: launches.
        state: the particles; they are sorted by cell at every renewal.
        support: H [m].
        skin: added to the support [m].
        lower, upper: the box that holds most particles [m]; others are found too, only slower.
        dimension: 2 or 3.
        materials: number of materials (each has its place behind the grid for particles in the reservoir).

    Attributes:
        list: the rows of neighbours for the kernels.
        outdated: (1,) not zero when the list must be renewed before the next use.
        renewals: (1,) how often it has been renewed.
        longest_row: (1,) not zero when a row was too short for its neighbours.
        reservoir_start: (materials + 1,) at the last renewal, the index of the first particle in the reservoir by
            material, and the number of particles.
    """

    def __init__(
        self,
        executor: Executor,
        state: State,
        support: float,
        skin: float,
        lower: np.ndarray,
        upper: np.ndarray,
        dimension: int,
        materials: int,
        spacing: float,
    ):
        device = executor.device
        self.executor = executor
        self.state = state
        self.radius = support + skin
        self.half_skin = 0.5 * skin
        n = state.count

        self.grid = Grid()
        self.grid.origin = wp.vec3(*np.asarray(lower, float))
        self.grid.inverse_size = 1.0 / self.radius
        shape = np.maximum(np.ceil((np.asarray(upper) - np.asarray(lower)) / self.radius).astype(int), 1)
        self.grid.nx, self.grid.ny, self.grid.nz = (int(m) for m in shape)
        cells = int(np.prod(shape))

        self.list = NeighbourList()
        per_volume = {2: np.pi, 3: 4.0 / 3.0 * np.pi}[dimension] * (self.radius / spacing) ** dimension
        self.list.capacity = int(1.6 * per_volume) + 8
        self.list.count = wp.zeros(n, dtype=int, device=device)
        self.list.entry = wp.zeros(n * self.list.capacity, dtype=int, device=device)
        self.list.row_stride, self.list.entry_stride = (1, n) if executor.on_cuda else (self.list.capacity, 1)

        self.reference = wp.zeros(n, dtype=wp.vec3, device=device)
        self.outdated = wp.ones(1, dtype=int, device=device)
        self.renewals = wp.zeros(1, dtype=int, device=device)
        self.longest_row = wp.zeros(1, dtype=int, device=device)
        self._cell, self._rank, self._order, self._place = (wp.zeros(n, dtype=int, device=device) for _ in range(4))
        self._start = wp.zeros(cells + materials + 1, dtype=int, device=device)
        self.reservoir_start = self._start[cells:]
        self._spares: list[wp.array] = []
        self._spare_bonds = _like(state.bonds) if state.bonds is not None else None

    def renew_if_outdated(self) -> None:
        """Sort the particles and list the neighbours anew if ``outdated`` says so."""
        if not self._spares:  # once the devices have added their arrays
            self._spares = [
                wp.empty(words(array).shape, dtype=int, device=array.device) for array in self.state.arrays_to_keep()
            ]
        self.executor.when(self.outdated, self._renew)

    def _renew(self) -> None:
        launch, state = self.executor, self.state
        sort_into_cells(
            launch,
            self.grid,
            state.position,
            state.role,
            state.material,
            self._cell,
            self._rank,
            self._start,
            self._order,
        )
        reorder(launch, self._order, [words(array) for array in state.arrays_to_keep()], self._spares)
        if state.bonds is not None:
            invert(launch, self._order, self._place)
            bond_kernels.reorder_bonds(launch, self._order, self._place, state.bonds, self._spare_bonds)
        list_neighbours(
            launch, self.grid, self._start, state.position, state.role, self.radius, self.list, self.longest_row
        )
        if state.bonds is not None:
            bond_kernels.mark_bonded_neighbours(launch, self.list, state.bonds)
        copy(launch, words(state.position), words(self.reference))
        clear_flag(launch, self.outdated, self.renewals)


def _like(bonds: bond_kernels.BondList) -> bond_kernels.BondList:
    spare = bond_kernels.BondList()
    spare.capacity = bonds.capacity
    for name in ("count", "partner", "separation", "slope", "value"):
        setattr(spare, name, wp.empty_like(getattr(bonds, name)))
    return spare
