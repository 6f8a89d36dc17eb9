"""A speedometer of the shell."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Value
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.kernels.machine.speed import note_speed
from warpsph.terms.elasticity import Elasticity


@dataclass(frozen=True, eq=False)
class ShellSpeedometer(Term):
    """Keeps the highest speeds of free solid particles: a shell that jumps does so between two frames.

    What has fewer bonds than a particle inside a row of them is no shell but a grain that hangs in the melt, and goes
    with it.
    """

    needs = ("elasticity",)

    fastest_squared = Value(float, "m^2/s^2", "square of the highest speed of the shell since the last reading")
    fastest_grain_squared = Value(float, "m^2/s^2", "square of the highest speed of grains since the last reading")

    def constants(self, model: Model, state: State) -> dict[str, object]:
        ratio = round(model.the(Elasticity).reach(model) / model.spacing, 6)
        return {"row": 2 * (int(np.ceil(ratio)) - 1)}

    def read(self) -> tuple[float, float]:
        """The highest speeds of shell and grains since the last reading [m/s]."""
        return _highest(self.fastest_squared), _highest(self.fastest_grain_squared)

    def watch(self, launch: Launch) -> None:
        launch(note_speed)


def _highest(squared: wp.array) -> float:
    fastest = float(np.sqrt(squared.numpy()[0]))
    squared.zero_()
    return fastest
