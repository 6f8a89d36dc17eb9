"""How forces change velocities."""

from dataclasses import dataclass

import warp as wp

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.term import Term
from warpsph.kernels.basics.motion import fall, kick


@dataclass(frozen=True, eq=False)
class Dynamics(Term):
    """Semi-implicit Euler steps: gravity and the forces of all terms change velocities, which then move positions."""

    keeps_momentum = True
    provides = ("forces",)
    follows = ("motion",)

    acceleration = Field(wp.vec3, "m/s^2", "acceleration")

    def sum_forces(self, launch: Launch) -> None:
        launch(fall)

    def kick(self, launch: Launch) -> None:
        launch(kick)
