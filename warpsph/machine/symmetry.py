"""The plane of symmetry."""

from collections.abc import Sequence

import numpy as np

from warpsph.core.labels import Role
from warpsph.core.particles import Particles
from warpsph.core.term import BoundaryDevice
from warpsph.kernels.machine.symmetry import reflect


class SymmetryPlane(BoundaryDevice):
    """A plane that lets nothing through and no heat: dummies behind it, and a mirror for what crosses it all the same.

    The first layer of a solid at the plane can slide along it only.

    Args:
        normal: unit normal, pointing inside.
        offset: ``x . normal`` on the plane [m].
    """

    def __init__(self, normal: Sequence[float], offset: float):
        self.normal, self.offset = np.asarray(normal, float), offset

    def add_dummies(self, particles: Particles, points: np.ndarray, material: int) -> None:
        """Add fixed dummies at ``points`` (n, 3) [m] behind the plane; they slip and conduct no heat."""
        particles.add(points, Role.DUMMY, material)

    def after_move(self, dt: float) -> None:
        s = self.state
        reach = self.solver.model.spacing
        reflect(self.launch, dt, self.normal, self.offset, reach, s.role, s.phase, s.position, s.velocity)
