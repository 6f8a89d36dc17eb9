"""A floor on which particles fall."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.particles.floor import FloorConstants, reflect

ROUNDING = 1.0e-12  # of the share that is given back, where a slope in other units ends at 0


@dataclass(frozen=True, eq=False)
class Floor(Term):
    """The plane y = 0: what falls below it is reflected, at rest along it (Greenspan 1976, (3.1) and (5.1)).

    Args:
        restitution: share of the vertical speed that is given back, at least 0.
        hot: the same at the left end of the part that is hot; more than 1 heats.
        slope: by how much that falls in 1 m to the right [1/m].
        hot_half_width: half the width of that part, around x = 0 [m]; 0 for none.
    """

    restitution: float = 0.1
    hot: float = 1.0
    slope: float = 0.0
    hot_half_width: float = 0.0

    def __post_init__(self) -> None:
        for name in ("restitution", "hot", "hot_half_width"):
            require(self, name, 0.0 <= number(getattr(self, name)) < np.inf, "zero or positive")
        least = self.hot - 2.0 * number(self.slope) * self.hot_half_width
        require(
            self,
            "slope",
            least >= -ROUNDING * self.hot,
            "so small that the floor gives back a share of at least 0 everywhere",
        )

    needs = ("precise motion",)

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return (1,)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        base = FloorConstants()
        base.cold, base.hot = wp.float64(self.restitution), wp.float64(self.hot)
        base.slope, base.hot_half_width = wp.float64(self.slope), wp.float64(self.hot_half_width)
        return {"base": base}

    def move(self, launch: Launch) -> None:
        launch(reflect)
