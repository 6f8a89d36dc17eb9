"""The outflow at the lower end of the simulated strand."""

from warpsph.core.term import BoundaryDevice, exchange_of
from warpsph.kernels.machine.outflow import hold_zone, pass_on
from warpsph.machine.level import LevelGauge


class Outflow(BoundaryDevice):
    """Withdraws the strand with v = k p (Vijaykumar 2012, section 6.3); what leaves goes back to the reservoir.

    Args:
        gauge: gives the speed.
        begin: height below which particles move with the casting speed [m].
        end: height below which they leave [m]; so does everything that falls there elsewhere.
        width: x, and in 3D z, up to which the strand reaches [m].
    """

    def __init__(self, gauge: LevelGauge, begin: float, end: float, width: float):
        self.gauge, self.begin, self.end, self.width = gauge, begin, end, width

    def bind(self, solver) -> None:
        super().bind(solver)
        self.exchange = exchange_of(solver)

    def after_density(self, dt: float) -> None:
        s = self.state
        hold_zone(
            self.launch,
            self.gauge.flow.pressure_per_height,
            self.gauge.speeds,
            s.role,
            s.position,
            s.velocity,
            s.pressure,
        )

    def after_heat(self, interval: float) -> None:
        pass_on(self.launch, self.begin, self.end, self.width, self.exchange)
