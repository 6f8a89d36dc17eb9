"""The water spray below the mould."""

from collections.abc import Sequence
from dataclasses import dataclass

import warp as wp

from warpsph.core.term import BoundaryDevice, exchange_of
from warpsph.kernels.machine.spray import Water, Zones, spray


@dataclass(frozen=True)
class SprayZone:
    """A stretch of the strand that is sprayed evenly.

    Args:
        low, high: its ends [m].
        rate: particles a second.
        off: time at which it fails [s].
    """

    low: float
    high: float
    rate: float
    off: float = 1.0e9


class Spray(BoundaryDevice):
    """Particles of water that fly to the strand, heat up on it, vanish when they have boiled, and are sprayed again.

    Vijaykumar (2012), section 6.4.

    Args:
        zones: where and how much.
        nozzle: x from which the water comes [m]; it flies in -x, and in 3D from the same z in -z.
        speed: of flight [m/s].
        reach: distance to the strand at which water touches it [m].
        lost: distance from the axis at which water has missed the strand [m].
        temperature: of the water [K].
        boiled: temperature on the enthalpy curve of the water at which it has vanished [K].
        material: index of water.
        breadth: length of the sprayed faces across the strand [m], 0 in the plane.
    """

    def __init__(
        self,
        zones: Sequence[SprayZone],
        nozzle: float,
        speed: float,
        reach: float,
        lost: float,
        temperature: float,
        boiled: float,
        material: int,
        breadth: float = 0.0,
    ):
        self.zones, self.nozzle, self.speed, self.reach, self.lost = list(zones), nozzle, speed, reach, lost
        self.temperature, self.boiled, self.material, self.breadth = temperature, boiled, material, breadth

    def bind(self, solver) -> None:
        super().bind(solver)
        device = solver.executor.device
        self.exchange = exchange_of(solver)
        zones = self._zones = Zones()
        for name in ("low", "high", "rate", "off"):
            setattr(zones, name, wp.array([getattr(z, name) for z in self.zones], dtype=float, device=device))
        substance = solver.model.materials[self.material]
        water = self._water = Water()
        water.nozzle, water.speed, water.reach, water.lost = self.nozzle, self.speed, self.reach, self.lost
        water.enthalpy = float(substance.enthalpy(self.temperature))
        water.boiled = float(substance.enthalpy(self.boiled))
        water.material, water.breadth = self.material, self.breadth
        self._due = wp.zeros(len(self.zones), dtype=float, device=device)
        self.sprayed = wp.zeros(len(self.zones), dtype=int, device=device)
        self.missing = wp.zeros(1, dtype=int, device=device)

    def after_heat(self, interval: float) -> None:
        spray(
            self.launch,
            interval,
            self._zones,
            self._water,
            self.solver.neighbours.list,
            self.solver.time,
            self.solver.neighbours.reservoir_start,
            self._due,
            self.sprayed,
            self.missing,
            self.exchange,
        )
