"""The inlet: a submerged nozzle fed from the reservoir."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Value
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.periodic import axes_across
from warpsph.core.state import State
from warpsph.errors import number, numbers, require
from warpsph.kernels.machine.inlet import InletConstants, lead, pour
from warpsph.machine.exchange import ExchangePart
from warpsph.machine.level import LevelGauge


@dataclass(frozen=True, eq=False)
class Inlet(ExchangePart):
    """Pours melt through a nozzle at the rate that the gauge asks for (Vijaykumar 2012, section 6.2).

    Args:
        gauge: gives the pouring speed.
        row: places (k, 3) of one row across the nozzle, at its start [m].
        direction: unit vector along the nozzle.
        length: distance from the row to the mouth, beyond which the melt is free [m].
        temperature: of the melt [K].
        material: name of the melt.

    Attributes:
        missing: (1,) on the device: particles that the reservoir could not give.
    """

    gauge: LevelGauge
    row: np.ndarray
    direction: Sequence[float]
    length: float
    temperature: float
    material: str | None = None

    def __post_init__(self) -> None:
        require(self, "gauge", isinstance(self.gauge, LevelGauge), "a LevelGauge")
        row = isinstance(self.row, np.ndarray) and self.row.ndim == 2 and self.row.shape[1] == 3 and len(self.row) > 0
        require(self, "row", row and bool(np.all(np.isfinite(self.row))), "places (k, 3), one or more [m]")
        length = float(np.linalg.norm(numbers(self.direction, 3)))
        require(self, "direction", abs(length - 1.0) < 1e-6, "a unit vector of three numbers")
        require(self, "length", 0.0 <= number(self.length) < np.inf, "zero or positive [m]")
        require(self, "temperature", 0.0 < number(self.temperature) < np.inf, "positive [K]")

    travel = Value(float, "m", "way of the last row from the start of the nozzle")
    missing = Value(int, "", "particles that the reservoir could not give")

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return axes_across(self.direction)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        constants = InletConstants()
        constants.direction, constants.spacing = wp.vec3(*self.direction), model.spacing
        constants.mouth = float(self.row[0] @ np.asarray(self.direction, float)) + self.length
        constants.material = model.index_of(self.material)
        constants.enthalpy = float(model.materials[constants.material].enthalpy(self.temperature))
        row: wp.array = wp.array(self.row, dtype=wp.vec3, device=state.device)
        return super().constants(model, state) | {"inlet": constants, "row": row}

    def after_heat(self, launch: Launch) -> None:
        launch(lead, speeds=self.gauge.speeds)
        launch.whole(pour, speeds=self.gauge.speeds)
        self.start_anew(launch)
