"""The rolls that support the strand below the mould."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import lattice
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.machine.rolls import RollConstants, press
from warpsph.terms.elasticity import Elasticity

# In spacings, from the surface; a shell pressed by melt of a hundred spacings, with rolls every ten, is half as deep.
REACH = 1.0


@dataclass(frozen=True, eq=False)
class Rolls(Term):
    """Smooth cylinders that touch the strand and keep its shell from bulging; they turn without friction.

    A roll made of particles would be a rough block, on which the bulges of a shell catch and from which they snap.

    Args:
        face: distance of the cold faces from the axis of the strand [m]; rolls stand before the face at x, in 3D also
            at z.
        heights: of the axes [m].
        radius: [m].
    """

    face: float
    heights: Sequence[float] | np.ndarray
    radius: float

    def __post_init__(self) -> None:
        for name in ("face", "radius"):
            require(self, name, 0.0 < number(getattr(self, name)) < np.inf, "positive [m]")
        listed = isinstance(self.heights, Sequence | np.ndarray) and np.ndim(self.heights) == 1
        finite = listed and bool(np.all(np.isfinite([number(height) for height in self.heights])))
        require(self, "heights", finite, "a list of numbers [m]")

    needs = ("elasticity",)
    follows = ("fluid",)

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return (0, 1, 2)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"rolls": self.pack(model, state)}

    def pack(self, model: Model, state: State) -> RollConstants:
        """Its constants for the device; four spacings deep in a roll, it is as stiff as the solid is over one."""
        lame_lambda, lame_mu = model.the(Elasticity).lame
        rolls = RollConstants()
        rolls.face, rolls.radius, rolls.clearance = self.face, self.radius, 0.5 * model.spacing
        rolls.heights = wp.array(np.asarray(self.heights, float), dtype=float, device=state.device)
        rolls.reach = REACH * model.spacing
        rolls.stiffness = (lame_lambda + 2.0 * lame_mu) / 8.0 * model.spacing ** (model.dimension - 3)
        return rolls

    def surface(self, spacing: float, length: float = 0.0) -> np.ndarray:
        """Points (n, 3) [m] that show the rolls in a picture, of ``length`` [m] along z, 0 in the plane."""
        radius = self.radius - 0.5 * spacing
        number = max(round(2.0 * np.pi * radius / spacing), 6)
        angle = 2.0 * np.pi * np.arange(number) / number
        ring = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(number)])
        rings = [ring + np.array([self.face + self.radius, height, 0.0]) for height in self.heights]
        points = np.concatenate(rings) if rings else np.zeros((0, 3))
        along = lattice((0.0, 0.0, 0.0), (spacing, spacing, length), spacing)[:, 2] if length > 0.0 else np.zeros(1)
        return np.concatenate([points + np.array([0.0, 0.0, z]) for z in along])

    def sum_forces(self, launch: Launch) -> None:
        if "fast_acceleration" not in launch:
            launch(press)

    def sum_fast_forces(self, launch: Launch) -> None:
        launch(press, acceleration=launch.find("fast_acceleration"))
