"""The equations of an implicit step of conduction, in bodies with one temperature at each place."""

from dataclasses import dataclass

from warpsph.core.launch import Launch
from warpsph.kernels.heat.implicit_conduction import FIND_ITERATE, begin_conduction, count_conduction, end_conduction
from warpsph.kernels.heat.rows import FIND_ROWS
from warpsph.kernels.heat.walls import find_walls_near
from warpsph.terms.implicit_heat import Equations


@dataclass
class ConductionEquations(Equations):
    """See :class:`warpsph.terms.implicit_heat.Equations`.

    Args:
        smoothing, sharp_fronts: of the conduction.
        mixing: whether conductivities are mixed from those of the phases, by the solid fraction.
        bend, change, symmetric, walls: as there.
    """

    smoothing: str
    sharp_fronts: bool
    mixing: bool
    bend: bool
    change: bool
    symmetric: bool
    walls: int
    families = 1

    def begin(self, launch: Launch) -> None:
        launch(begin_conduction)

    def find_iterate(self, launch: Launch) -> None:
        launch(FIND_ITERATE[self.mixing])

    def find_rows(self, launch: Launch, ago: float) -> None:
        if self.walls:
            launch(find_walls_near, ago=ago)
        launch(FIND_ROWS[self.sharp_fronts][self.smoothing])

    def count(self, launch: Launch, part: float) -> None:
        launch(count_conduction, part=part)

    def end(self, launch: Launch) -> None:
        launch(end_conduction)
