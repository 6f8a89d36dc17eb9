"""What every particle has, the clock, and how positions advance."""

from dataclasses import dataclass
from typing import ClassVar

import warp as wp

from warpsph.core.content import Content
from warpsph.core.field import Field
from warpsph.core.guard import watch
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.momentum import mass_by_id, momentum
from warpsph.core.periodic import box_constants
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.kernels.basics.motion import advance_clock, drift
from warpsph.kernels.neighbours.wrapping import wrap


@dataclass(frozen=True, eq=False)
class Motion(Term):
    """Positions follow velocities (n, 3) [m/s], compensated; the clock counts steps and simulated time."""

    keeps_momentum = True
    provides: ClassVar[tuple[str, ...]] = ("motion",)

    id = Field(int, "", "number of the particle", written=True)
    role = Field(int, "", "who moves it", written=True)
    material = Field(int, "", "material", written=True)
    phase = Field(int, "", "phase", written=True)
    position = Field(wp.vec3, "m", "position", compensated=True)
    velocity = Field(wp.vec3, "m/s", "velocity", written=True)
    mass = Field(float, "kg", "mass (per metre of depth in 2D)")

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return box_constants(model.periodic)

    def contents(self, model: Model, state: State) -> dict[str, Content]:
        return {"mass": mass_by_id(state)} | momentum(model, state, state.numpy("velocity"))

    def wrap(self, launch: Launch) -> None:
        launch(wrap)

    def kick(self, launch: Launch) -> None:
        launch.whole(advance_clock)

    def move(self, launch: Launch) -> None:
        launch(drift)

    def watch(self, launch: Launch) -> None:
        watch(launch)
