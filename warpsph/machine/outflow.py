"""The outflow at the lower end of the simulated strand."""

from dataclasses import dataclass

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
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
