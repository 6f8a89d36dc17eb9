"""Surface tension by the curvature of a fluid's surface."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import require
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow.surface_tension import SurfaceConstants, add_surface_tension, find_surface_normal
from warpsph.terms.fluid import Fluid


@dataclass(frozen=True, eq=False)
class SurfaceTension(Term):
    """Force along the normal of the surface, by the curvature of its normals.

    Args:
        coefficient: sigma [N/m].
        threshold: gradient of the colour field, in units of 1/H, above which there is a surface.
    """

    coefficient: float
    threshold: float = 0.15

    def __post_init__(self) -> None:
        require(self, "coefficient", 0.0 < self.coefficient < float("inf"), "positive [N/m]")
        require(self, "threshold", 0.0 <= self.threshold < float("inf"), "zero or positive")

    provides = ("surface tension",)
    needs = ("fluid", "a density by continuity")

    surface_normal = Field(wp.vec3, "1/m", "gradient of the colour field at the surface", kept=False)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"surface": self._constants(model)}

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        return {"surface tension": capillary_step(model, self.coefficient)}

    def sum_forces(self, launch: Launch) -> None:
        launch(find_surface_normal)

    def add_forces(self, launch: Launch) -> None:
        launch(add_surface_tension)

    def _constants(self, model: Model) -> SurfaceConstants:
        """Constants with which the force on a unit of surface is exact on the lattice."""
        constants = SurfaceConstants()
        rho_0 = model.the(Fluid).reference_density
        constants.support = model.support
        constants.scale = normalisation("poly6", model.dimension, model.support) / rho_0
        constants.threshold = self.threshold / model.support
        chi, constants.depth = model.lattice.surface("poly6", constants.threshold)
        constants.strength = (model.dimension - 1) * self.coefficient / (chi * rho_0)
        return constants


def capillary_step(model: Model, coefficient: float) -> float:
    """Longest stable step [s] for the shortest capillary wave (Morris 2000)."""
    inertia = model.the(Fluid).reference_density * (0.5 * model.support) ** 3 / (2.0 * np.pi * coefficient)
    return 0.25 * float(np.sqrt(inertia))
