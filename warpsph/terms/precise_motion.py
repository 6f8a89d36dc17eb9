"""Motion in double precision, for systems in which the smallest difference grows."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.content import Content
from warpsph.core.field import Field, Value
from warpsph.core.guard import watch
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.momentum import mass_by_id, momentum
from warpsph.core.motion import Motion
from warpsph.core.particles import Particles
from warpsph.core.periodic import box_constants
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError
from warpsph.kernels.basics.motion import advance_clock
from warpsph.kernels.neighbours.wrapping import wrap_precisely
from warpsph.kernels.particles.motion import drift_precisely, fall_precisely, keep_step, kick_precisely, show


@dataclass(frozen=True, eq=False)
class PreciseMotion(Term):
    """Leap-frog steps of Greenspan (1976), (2.1) to (2.3), in the place of the engine's motion and dynamics.

    Forces add to ``precise_acceleration``; velocities stand in the middle of a step, but at the start. Position and
    velocity in single precision, for the neighbour list, pictures and files, follow.
    """

    keeps_momentum = True
    provides = ("motion", "forces", "precise motion")

    id = Motion.id
    role = Motion.role
    material = Motion.material
    phase = Motion.phase
    position = Motion.position
    velocity = Motion.velocity
    mass = Motion.mass
    precise_position = Field(wp.vec3d, "m", "position in double precision")
    precise_velocity = Field(wp.vec3d, "m/s", "velocity in double precision")
    precise_acceleration = Field(wp.vec3d, "m/s^2", "acceleration in double precision", kept=False)
    last_step = Value(wp.float64, "s", "length of the step before")

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        for term in model.terms:
            if "forces" in term.needs:
                name = type(term).__name__
                raise InputError(f"{name} sums forces in single precision, which PreciseMotion does not read; drop one")
        return {"precise_position": fields["position"], "precise_velocity": fields["velocity"]}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"precise_gravity": wp.vec3d(*model.gravity)} | box_constants(model.periodic)

    def contents(self, model: Model, state: State) -> dict[str, Content]:
        return {"mass": mass_by_id(state)} | momentum(model, state, state.numpy("precise_velocity"))

    def wrap(self, launch: Launch) -> None:
        launch(wrap_precisely)
        launch(show)

    def sum_forces(self, launch: Launch) -> None:
        launch(fall_precisely)

    def kick(self, launch: Launch) -> None:
        launch(kick_precisely)

    def move(self, launch: Launch) -> None:
        launch(drift_precisely)

    def watch(self, launch: Launch) -> None:
        launch(show)
        watch(launch)
        launch.whole(keep_step)
        launch.whole(advance_clock)
