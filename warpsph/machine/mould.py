"""The mould: walls that oscillate along y."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.machine.mould import oscillate


@dataclass(frozen=True, eq=False)
class OscillatingMould(Term):
    """Moves every wall particle sinusoidally up and down (Vijaykumar 2012, sections 6.1 and 7.3).

    Args:
        stroke: distance between the turning points [m].
        frequency: [Hz].
    """

    stroke: float
    frequency: float

    def __post_init__(self) -> None:
        require(self, "stroke", bool(np.isfinite(number(self.stroke))), "a length [m]")
        require(self, "frequency", 0.0 <= number(self.frequency) < np.inf, "zero or positive [Hz]")

    provides = ("an oscillating mould",)

    rest_position = Field(wp.vec3, "m", "place in the middle of the stroke")

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        return {"rest_position": fields["position"]}

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return (1,)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"amplitude": 0.5 * self.stroke, "frequency": self.frequency}

    def move(self, launch: Launch) -> None:
        launch(oscillate)
