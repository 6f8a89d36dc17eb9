"""Motion by Verlet steps: half the way, the density there, the other half, and the forces at its end."""

from dataclasses import dataclass

import warp as wp

from warpsph.core.dynamics import Dynamics
from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.motion import Motion
from warpsph.core.term import Term
from warpsph.kernels.basics.motion import advance_clock, drift, fall, kick


@dataclass(frozen=True, eq=False)
class Verlet(Motion):
    """Second-order steps in the place of the engine's motion and dynamics: half a kick, two half drifts, half a kick.

    Between the drifts other terms find the density of the middle of the step, after them the forces of its end. Fast
    forces, those of stiff solids, act in small steps of which each drift has one or more (Tuckerman, Berne & Martyna
    1992): the sums over neighbours need not follow them.
    """

    keeps_momentum = True
    provides = ("motion", "forces", "second-order motion", "small steps")

    acceleration = Dynamics.acceleration
    fast_acceleration = Field(wp.vec3, "m/s^2", "acceleration by fast forces", renewed=True)

    move = Term.move  # it has moved by then

    def set_out(self, launch: Launch) -> None:
        launch(kick, dt=0.5 * launch.find("dt"))

    def drift(self, launch: Launch) -> None:
        launch(drift, dt=launch.find("small_dt"))

    def sum_fast_forces(self, launch: Launch) -> None:
        launch(fall, gravity=wp.vec3(), acceleration=launch.find("fast_acceleration"))

    def kick_little(self, launch: Launch) -> None:
        launch(kick, dt=0.5 * launch.find("small_dt"), acceleration=launch.find("fast_acceleration"))

    def sum_forces(self, launch: Launch) -> None:
        launch(fall)

    def kick(self, launch: Launch) -> None:
        launch(kick, dt=0.5 * launch.find("dt"))
        launch.whole(advance_clock)
