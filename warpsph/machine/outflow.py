"""The outflow at the lower end of the simulated strand."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.errors import number, require
from warpsph.kernels.machine.outflow import hold_zone, pass_on
from warpsph.machine.exchange import ExchangePart
from warpsph.machine.level import LevelGauge


@dataclass(frozen=True, eq=False)
class Outflow(ExchangePart):
    """Withdraws the strand with v = k p (Vijaykumar 2012, section 6.3); what leaves goes back to the reservoir.

    Args:
        gauge: gives the speed.
        begin: height below which particles move with the casting speed [m].
        end: height below which they leave [m]; so does everything that falls there elsewhere.
        width: x, and in 3D z, up to which the strand reaches [m].
    """

    gauge: LevelGauge
    begin: float
    end: float
    width: float

    def __post_init__(self) -> None:
        require(self, "gauge", isinstance(self.gauge, LevelGauge), "a LevelGauge")
        require(self, "begin", bool(np.isfinite(number(self.begin))), "a height [m]")
        require(self, "end", number(self.end) <= self.begin, "a height [m] that is not above begin")
        require(self, "width", 0.0 < number(self.width) < np.inf, "positive [m]")

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return (1,)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return super().constants(model, state) | {
            "pressure_per_height": self.gauge.pressure_per_height(model),
            "begin": self.begin,
            "end": self.end,
            "width": self.width,
        }

    def prescribe(self, launch: Launch) -> None:
        launch(hold_zone, speeds=self.gauge.speeds)

    def after_heat(self, launch: Launch) -> None:
        launch(pass_on)
