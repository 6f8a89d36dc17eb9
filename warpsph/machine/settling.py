"""Drag at the beginning of a run, so that a start that is not quite at rest comes to rest."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.machine.settling import slow_down


@dataclass(frozen=True, eq=False)
class Settling(Term):
    """Slows all free particles down for a while.

    Args:
        rate: relative loss of velocity in unit time [1/s].
        until: time at which the drag ends [s].
    """

    rate: float
    until: float

    def __post_init__(self) -> None:
        require(self, "rate", 0.0 <= number(self.rate) < np.inf, "zero or positive [1/s]")
        require(self, "until", bool(np.isfinite(number(self.until))), "a time [s]")

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"rate": self.rate, "until": self.until}

    def move(self, launch: Launch) -> None:
        launch(slow_down)
