"""The inlet: a submerged nozzle fed from the reservoir."""

from collections.abc import Sequence

import numpy as np
import warp as wp

from warpsph.core.term import BoundaryDevice, exchange_of
from warpsph.kernels.machine.inlet import Nozzle, pour
from warpsph.machine.level import LevelGauge


class Inlet(BoundaryDevice):
    """Pours melt through a nozzle at the rate that the gauge asks for (Vijaykumar 2012, section 6.2).

    Args:
        gauge: gives the pouring speed.
        row: places (k, 3) of one row across the nozzle, at its start [m].
        direction: unit vector along the nozzle.
        length: distance from the row to the mouth, beyond which the melt is free [m].
        temperature: of the melt [K].
        material: index of the melt.
    """

    def __init__(
        self,
        gauge: LevelGauge,
        row: np.ndarray,
        direction: Sequence[float],
        length: float,
        temperature: float,
        material: int = 0,
    ):
        self.gauge, self.row, self.direction, self.length = gauge, row, np.asarray(direction, float), length
        self.temperature, self.material = temperature, material

    def bind(self, solver) -> None:
        super().bind(solver)
        device = solver.executor.device
        self.exchange = exchange_of(solver)
        nozzle = self.nozzle = Nozzle()
        nozzle.direction, nozzle.spacing = wp.vec3(*self.direction), solver.model.spacing
        nozzle.mouth = float(self.row[0] @ self.direction) + self.length
        nozzle.enthalpy = float(solver.model.materials[self.material].enthalpy(self.temperature))
        nozzle.material = self.material
        self._row = wp.array(self.row, dtype=wp.vec3, device=device)
        self._travel = wp.zeros(1, dtype=float, device=device)
        self.missing = wp.zeros(1, dtype=int, device=device)

    def after_heat(self, interval: float) -> None:
        pour(
            self.launch,
            interval,
            self.nozzle,
            self._row,
            self.gauge.speeds,
            self.solver.neighbours.reservoir_start,
            self._travel,
            self.missing,
            self.exchange,
        )
