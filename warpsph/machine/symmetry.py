"""The plane of symmetry."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.labels import Role
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.periodic import axes_across
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, numbers, require
from warpsph.kernels.machine.symmetry import reflect


@dataclass(frozen=True, eq=False)
class SymmetryPlane(Term):
    """A plane that lets nothing through and no heat: dummies behind it, and a mirror for what crosses it all the same.

    The first layer of a solid at the plane can slide along it only.

    Args:
        normal: unit normal, pointing inside.
        offset: ``x . normal`` on the plane [m].
    """

    normal: Sequence[float]
    offset: float

    def __post_init__(self) -> None:
        length = float(np.linalg.norm(numbers(self.normal, 3)))
        require(self, "normal", abs(length - 1.0) < 1e-6, "a unit vector of three numbers")
        require(self, "offset", bool(np.isfinite(number(self.offset))), "a number [m]")

    def add_dummies(self, particles: Particles, points: np.ndarray, material: str, **fields: np.ndarray) -> None:
        """Add fixed dummies at ``points`` (n, 3) [m] behind the plane; they slip and conduct no heat."""
        particles.add(points, Role.DUMMY, material, **fields)

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return axes_across(self.normal)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"normal": wp.vec3(*self.normal), "offset": self.offset, "reach": model.spacing}

    def move(self, launch: Launch) -> None:
        launch(reflect)
