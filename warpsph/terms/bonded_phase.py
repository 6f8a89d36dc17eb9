"""Solid or fluid, for particles that attract each other."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.motion import Motion
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.particles.phases import find_means, find_solids, gather_energy


@dataclass(frozen=True, eq=False)
class BondedPhase(Term):
    """A particle is solid while it forms a triangle with two others, all of them calm (Greenspan 1976, 4 and 5).

    Args:
        bond: all sides of the triangle are shorter than this [m].
        interval: time over which the mean velocity is found, and after which phases are found anew [s]. Frames that are
            closer together, or not whole intervals apart, shorten it until it fits between them; the step is then
            shortened with it, because an interval keeps its number of steps.
        highest_speed: of a calm particle, by its mean velocity [m/s].
        highest_energy: of a calm particle, below which its mean kinetic energy since the start must be [J].
    """

    bond: float
    interval: float
    highest_speed: float = np.inf
    highest_energy: float = np.inf

    def __post_init__(self) -> None:
        for name in ("bond", "interval"):
            require(self, name, 0.0 < number(getattr(self, name)) < np.inf, "positive")
        for name in ("highest_speed", "highest_energy"):
            require(self, name, number(getattr(self, name)) > 0.0, "positive, or infinite for no limit")

    provides = ("a change of phase",)
    needs = ("precise motion",)

    phase = Motion.phase
    mean_velocity = Field(wp.vec3, "m/s", "mean velocity", written=True)
    mean_energy = Field(float, "J", "mean kinetic energy", written=True, colours="inferno")
    energy_sum = Field(wp.float64, "J", "kinetic energies of all steps, added up")
    place_before = Field(wp.vec3d, "m", "place an interval ago")

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {
            "bond_squared": self.bond**2,
            "highest_speed": self.highest_speed,
            "highest_energy": self.highest_energy,
        }

    def reach(self, model: Model) -> float:
        return self.bond

    def longest_intervals(self, model: Model) -> dict[str, float]:
        return {"mean velocity": self.interval}

    def facts(self) -> dict[str, Any]:
        """How long bonds are [m], and above which mean speed [m/s] a particle is fast."""
        return {"bond": self.bond} | ({"fast": self.highest_speed} if np.isfinite(self.highest_speed) else {})

    def watch(self, launch: Launch) -> None:
        launch(gather_energy)

    def find_temperature(self, launch: Launch) -> None:
        launch(find_means)

    def change_phases(self, launch: Launch) -> None:
        launch(find_solids)
