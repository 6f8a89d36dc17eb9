"""Friction that brings a body to rest before something is done with it."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.particles.motion import damp


@dataclass(frozen=True, eq=False)
class Damping(Term):
    """Velocities decay at a rate, for a time.

    Args:
        rate: [1/s].
        until: when it ends [s].
    """

    rate: float
    until: float

    def __post_init__(self) -> None:
        for name in ("rate", "until"):
            require(self, name, 0.0 <= number(getattr(self, name)) < np.inf, "zero or positive")

    needs = ("precise motion",)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"damping_rate": self.rate, "damping_end": self.until}

    def kick(self, launch: Launch) -> None:
        launch(damp)
