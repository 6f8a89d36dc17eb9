"""A source of heat that drives particles away from itself."""

from collections.abc import Sequence, Sized
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, numbers, require
from warpsph.kernels.particles.source import drive_away


@dataclass(frozen=True, eq=False)
class DrivingSource(Term):
    """A source that accelerates particles away from itself by strength / R^2 (Greenspan 1976, (4.1)).

    Args:
        position: (3,) [m].
        source_reach: distance [m] from which on it does nothing.
        strengths: one after the other [m^3/s^2].
        until: the times [s] to which they hold.
    """

    position: Sequence[float]
    source_reach: float
    strengths: Sequence[float]
    until: Sequence[float]

    def __post_init__(self) -> None:
        require(self, "position", bool(np.all(np.isfinite(numbers(self.position, 3)))), "three numbers [m]")
        require(self, "source_reach", 0.0 < number(self.source_reach) < np.inf, "positive [m]")
        count = len(self.strengths) if isinstance(self.strengths, Sized) else -1
        listed = count >= 0 and bool(np.all(np.isfinite(numbers(self.strengths, count))))
        require(self, "strengths", listed, "a list of numbers [m^3/s^2]")
        until = numbers(self.until, count)
        rising = bool(np.all(np.diff((0.0, *until)) > 0.0))
        require(self, "until", rising, "as many rising times [s] as there are strengths")

    needs = ("precise motion",)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {
            "source": wp.vec3d(*self.position),
            "source_reach": self.source_reach,
            "until": wp.array(np.asarray(self.until), dtype=wp.float64, device=state.device),
            "strength": wp.array(np.asarray(self.strengths), dtype=wp.float64, device=state.device),
        }

    def kick(self, launch: Launch) -> None:
        launch(drive_away)
