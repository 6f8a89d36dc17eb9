"""The equations of an implicit step of a binary alloy: its liquid and its ice have a temperature each."""

import warp as wp

from warpsph.core.launch import Launch
from warpsph.kernels.heat.alloy import SUM_ALLOY_HEAT
from warpsph.kernels.heat.implicit_alloy import begin_alloy, end_alloy, find_alloy_iterate, find_alloy_rows
from warpsph.kernels.heat.walls import count_heat
from warpsph.terms.implicit_heat import Equations


class AlloyEquations(Equations):
    """See :class:`warpsph.terms.implicit_heat.Equations`.

    Of ice behind a wall of given temperature there is as much as is in equilibrium there, not as much as before it:
    the rows are not symmetric.

    Args:
        walls: number of walls.
    """

    families = 2
    bend = False
    change = False
    symmetric = False

    def __init__(self, walls: int):
        self.walls = walls

    def begin(self, launch: Launch) -> None:
        launch(begin_alloy)

    def find_iterate(self, launch: Launch) -> None:
        launch(find_alloy_iterate)

    def find_rows(self, launch: Launch, ago: float) -> None:
        launch(find_alloy_rows)

    def count(self, launch: Launch, part: float) -> None:
        if self.walls:
            temperature = launch.find("solution").temperature
            liquid, ice = temperature[: launch.count], temperature[launch.count :]
            launch(SUM_ALLOY_HEAT[wp.float64], temperature=liquid, ice_temperature=ice)
            launch(count_heat, interval=part)

    def end(self, launch: Launch) -> None:
        launch(end_alloy)
