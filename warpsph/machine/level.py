"""The level gauge, which sets the casting and the pouring speed."""

from collections.abc import Sequence

import numpy as np
import warp as wp

from warpsph.core.term import BoundaryDevice
from warpsph.kernels.machine.gauge import PARTS, Flow, measure_level


class LevelGauge(BoundaryDevice):
    """Weighs a column of melt and derives the speeds from its height.

    The strand leaves with v = k p (Vijaykumar 2012, equation 6.2), where k is such that the target level gives the
    casting speed; the melt enters at the rate at which it leaves, raised in proportion to the shortage of level.

    Args:
        low, high: corners of the weighed column [m]; its height counts from ``low``.
        target_level: height of the melt at rest [m].
        casting_speed: speed of the strand at the target level [m/s].
        area_ratio: cross-section of the strand over that of the nozzle.
        gain: relative rise of the pouring speed per relative shortage of level.
        response: time over which the level is smoothed [s].

    Attributes:
        speeds: (3,) on the device: level [m], casting speed [m/s], pouring speed [m/s].
    """

    def __init__(
        self,
        low: Sequence[float],
        high: Sequence[float],
        target_level: float,
        casting_speed: float,
        area_ratio: float,
        gain: float = 40.0,
        response: float = 0.1,
    ):
        self.low, self.high = np.asarray(low, float), np.asarray(high, float)
        self.target_level, self.casting_speed, self.area_ratio = target_level, casting_speed, area_ratio
        self.gain, self.response = gain, response

    def bind(self, solver) -> None:
        super().bind(solver)
        model = solver.model
        weight = model.fluid.reference_density * float(np.linalg.norm(model.gravity))
        column = self.high - self.low
        section = column[0] * (column[2] if model.dimension == 3 else 1.0)
        flow = self.flow = Flow()
        flow.low, flow.high = wp.vec3(*self.low), wp.vec3(*self.high)
        flow.mass_per_height = model.fluid.reference_density * section / model.lattice_density()
        flow.response = self.response
        flow.pressure_per_height = weight
        flow.outflow_coefficient = self.casting_speed / (weight * self.target_level)
        flow.area_ratio = self.area_ratio
        flow.target_level = self.target_level
        flow.gain = self.gain
        self._parts = wp.zeros(PARTS, dtype=wp.float64, device=solver.executor.device)
        start = [self.target_level, self.casting_speed, self.casting_speed * self.area_ratio]
        self.speeds = wp.array(start, dtype=float, device=solver.executor.device)

    def after_heat(self, interval: float) -> None:
        s = self.state
        measure_level(self.launch, interval, self.flow, s.role, s.position, s.mass, self._parts, self.speeds)
