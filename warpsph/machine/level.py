"""The level gauge, which sets the casting and the pouring speed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Value
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, numbers, require
from warpsph.kernels.machine.gauge import PARTS, GaugeConstants, control, weigh
from warpsph.terms.weakly_compressible import WeaklyCompressible


@dataclass(frozen=True, eq=False)
class LevelGauge(Term):
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

    low: Sequence[float]
    high: Sequence[float]
    target_level: float
    casting_speed: float
    area_ratio: float
    gain: float = 40.0
    response: float = 0.1

    def __post_init__(self) -> None:
        require(
            self,
            "high",
            bool(np.all(np.less(numbers(self.low, 3), numbers(self.high, 3)))),
            "above low on each of three axes",
        )
        for name in ("target_level", "area_ratio", "response"):
            require(self, name, 0.0 < number(getattr(self, name)) < np.inf, "positive")
        for name in ("casting_speed", "gain"):
            require(self, name, bool(np.isfinite(number(getattr(self, name)))), "a number")

    needs = ("fluid", "conduction")

    speeds = Value(
        float,
        "",
        "level [m], casting speed and pouring speed [m/s]",
        start=lambda gauge: (gauge.target_level, gauge.casting_speed, gauge.casting_speed * gauge.area_ratio),
    )
    parts = Value(wp.float64, "kg", "partial sums of the weight", start=np.zeros(PARTS), scratch=True)

    def mean_density(self, model: Model) -> float:
        """Of the weakly compressible column [kg/m^3] that stands at rest up to the target level."""
        return model.the(WeaklyCompressible).column_density(model, self.target_level)

    def pressure_per_height(self, model: Model) -> float:
        """rho g [Pa/m] of that column."""
        return self.mean_density(model) * float(np.linalg.norm(model.gravity))

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return (1,)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        weight = self.pressure_per_height(model)
        column = np.asarray(self.high, float) - np.asarray(self.low, float)
        section = column[0] * (column[2] if model.dimension == 3 else 1.0)
        constants = GaugeConstants()
        constants.low, constants.high = wp.vec3(*self.low), wp.vec3(*self.high)
        fluid = model.the(WeaklyCompressible)
        weighed = fluid.particle_mass(model) / (fluid.reference_density * model.cell_volume)
        constants.mass_per_height = self.mean_density(model) * section * weighed
        constants.response = self.response
        constants.pressure_per_height = weight
        constants.outflow_coefficient = self.casting_speed / (weight * self.target_level)
        constants.area_ratio = self.area_ratio
        constants.target_level = self.target_level
        constants.gain = self.gain
        return {"gauge": constants}

    def after_heat(self, launch: Launch) -> None:
        launch(weigh, PARTS)
        launch.whole(control)
