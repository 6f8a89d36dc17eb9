"""The water spray below the mould."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Value
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.errors import number, require
from warpsph.kernels.machine.rolls import RollConstants
from warpsph.kernels.machine.spray import SprayZones, WaterConstants, boil, emit, ride
from warpsph.machine.exchange import ExchangePart
from warpsph.machine.rolls import Rolls

STAND = 0.8  # distance of water from the strand that it stands on, in spacings


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

    def __post_init__(self) -> None:
        require(self, "low", bool(np.isfinite(number(self.low))), "a height [m]")
        require(self, "high", self.low <= number(self.high) < np.inf, "a height [m] that is not below low")
        require(self, "rate", 0.0 <= number(self.rate) < np.inf, "zero or positive [1/s]")
        require(self, "off", not np.isnan(number(self.off)), "a time [s]")


@dataclass(frozen=True, eq=False)
class Spray(ExchangePart):
    """Particles of water that fly to the strand, heat up on it, vanish when they have boiled, and are sprayed again.

    Vijaykumar (2012), section 6.4.

    Args:
        zones: where and how much.
        nozzle: x from which the water comes [m]; it flies in -x, and in 3D from the same z in -z.
        speed: of flight [m/s].
        near: distance to the strand at which water touches it [m].
        lost: distance from the axis at which water has missed the strand [m].
        temperature: of the water [K].
        boiled: temperature on the enthalpy curve of the water at which it has vanished [K].
        material: name of the water.
        end: height below which the water has left with the strand [m].
        rolls: which the water cannot run into; none by default.
        breadth: length of the sprayed faces across the strand [m], 0 in the plane.

    Attributes:
        sprayed: (zones,) on the device: particles sprayed so far.
        caught: (1,) on the device: particles that the strand has closed over, taken out.
        missing: (1,) on the device: particles that the reservoir could not give.
    """

    zones: Sequence[SprayZone]
    nozzle: float
    speed: float
    near: float
    lost: float
    temperature: float
    boiled: float
    material: str
    end: float = -np.inf
    rolls: Rolls | None = None
    breadth: float = 0.0

    def __post_init__(self) -> None:
        zones = isinstance(self.zones, Sequence) and all(isinstance(zone, SprayZone) for zone in self.zones)
        require(self, "zones", zones, "a list of SprayZone")
        for name in ("nozzle", "lost"):
            require(self, name, bool(np.isfinite(number(getattr(self, name)))), "a number [m]")
        for name, unit in (("speed", "m/s"), ("near", "m"), ("temperature", "K"), ("boiled", "K")):
            require(self, name, 0.0 < number(getattr(self, name)) < np.inf, f"positive [{unit}]")
        require(self, "breadth", 0.0 <= number(self.breadth) < np.inf, "zero or positive [m]")

    due = Value(float, "", "fraction of the next particle of each zone", start=lambda spray: [0.0] * len(spray.zones))
    sprayed = Value(int, "", "particles sprayed in each zone", start=lambda spray: [0] * len(spray.zones))
    caught = Value(int, "", "particles of water that the strand has closed over")
    missing = Value(int, "", "particles that the reservoir could not give")

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return (0, 1, 2)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        zones = SprayZones()
        for name in ("low", "high", "rate", "off"):
            setattr(zones, name, wp.array([getattr(z, name) for z in self.zones], dtype=float, device=state.device))
        water = WaterConstants()
        water.material = model.index_of(self.material)
        substance = model.materials[water.material]
        water.nozzle, water.speed, water.reach, water.lost = self.nozzle, self.speed, self.near, self.lost
        water.enthalpy = float(substance.enthalpy(self.temperature))
        water.boiled = float(substance.enthalpy(self.boiled))
        water.breadth, water.end = self.breadth, self.end
        water.spacing, water.stand = model.spacing, STAND * model.spacing
        rolls = self.rolls.pack(model, state) if self.rolls else _no_rolls(state)
        return super().constants(model, state) | {"zones": zones, "water": water, "rolls": rolls}

    def after_heat(self, launch: Launch) -> None:
        launch.meet()
        launch(ride)
        launch(boil)
        launch.whole(emit)
        self.start_anew(launch)


def _no_rolls(state: State) -> RollConstants:
    rolls = RollConstants()
    rolls.heights = wp.zeros(0, dtype=float, device=state.device)
    return rolls
