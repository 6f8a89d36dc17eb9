"""Motion by Verlet steps: half the way, the density there, the other half, and the forces at its end."""

from dataclasses import dataclass

import warp as wp

from warpsph.core.dynamics import Dynamics
from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.motion import Motion
from warpsph.core.periodic import box_constants
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.kernels.basics.motion import advance_clock, drift_little, fall, kick_half, kick_little, rest, watch
from warpsph.kernels.neighbours.wrapping import wrap


@dataclass(frozen=True, eq=False)
class Verlet(Term):
    """Second-order steps in the place of the engine's motion and dynamics: half a kick, two half drifts, half a kick.

    Between the drifts other terms find the density of the middle of the step, after them the forces of its end. Fast
    forces, those of stiff solids, act in small steps of which each drift has one or more (Tuckerman, Berne & Martyna
    1992): the sums over neighbours need not follow them.
    """

    provides = ("motion", "forces", "second-order motion", "small steps")

    id = Motion.id
    role = Motion.role
    material = Motion.material
    phase = Motion.phase
    position = Motion.position
    velocity = Motion.velocity
    mass = Motion.mass
    acceleration = Dynamics.acceleration
    fast_acceleration = Field(wp.vec3, "m/s^2", "acceleration by fast forces", renewed=True)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return box_constants(model.periodic)

    def wrap(self, launch: Launch) -> None:
        launch(wrap)

    def set_out(self, launch: Launch) -> None:
        launch(kick_half)

    def drift(self, launch: Launch) -> None:
        launch(drift_little)

    def sum_fast_forces(self, launch: Launch) -> None:
        launch(rest)

    def kick_little(self, launch: Launch) -> None:
        launch(kick_little)

    def sum_forces(self, launch: Launch) -> None:
        launch(fall)

    def kick(self, launch: Launch) -> None:
        launch(kick_half)
        launch.whole(advance_clock)

    def watch(self, launch: Launch) -> None:
        launch(watch)
