"""A speedometer of the shell."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.field import Value
from warpsph.core.launch import Launch
from warpsph.core.term import Term
from warpsph.kernels.machine.speed import note_speed


@dataclass(frozen=True, eq=False)
class ShellSpeedometer(Term):
    """Keeps the highest speed of free solid particles: a shell that jumps does so between two frames."""

    fastest_squared = Value(float, "m^2/s^2", "square of the highest speed of solid particles since the last reading")

    def read(self) -> float:
        """The highest speed since the last reading [m/s]."""
        fastest = float(np.sqrt(self.fastest_squared.numpy()[0]))
        self.fastest_squared.zero_()
        return fastest

    def watch(self, launch: Launch) -> None:
        launch(note_speed)
