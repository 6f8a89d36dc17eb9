"""Surface tension by the curvature of a fluid's surface."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Field
from warpsph.core.labels import Phase
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.kernels.basics.roles import FLUID_ROLES
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow.surface_tension import SurfaceConstants, add_surface_tension, find_surface_normal
from warpsph.terms.fluid import SAME_DENSITY
from warpsph.terms.tension import Tension
from warpsph.terms.weakly_compressible import WeaklyCompressible


@dataclass(frozen=True, eq=False)
class SurfaceTension(Tension):
    """Force along the normal of the surface, by the curvature of its normals.

    Parameters as of every :class:`~warpsph.terms.tension.Tension`.
    """

    provides = ("surface tension",)

    surface_normal = Field(wp.vec3, "1/m", "gradient of the colour field at the surface", kept=False)

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        liquid = np.isin(fields["role"], FLUID_ROLES) & particles.flows & (fields["phase"] != Phase.SOLID)
        reference = model.the(WeaklyCompressible).reference_density
        for index in np.unique(fields["material"][liquid]):
            material = model.materials[index]
            if abs(material.density / reference - 1.0) > SAME_DENSITY:
                raise InputError(
                    f"SurfaceTension: {material.name} of {material.density:g} kg/m^3 flows, but its force knows one "
                    f"density, {reference:g} kg/m^3; give all fluids the same, or take ColourFieldTension"
                )
        return {}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"surface": self._constants(model)}

    def sum_forces(self, launch: Launch) -> None:
        launch(find_surface_normal)

    def add_forces(self, launch: Launch) -> None:
        launch(add_surface_tension)

    def _constants(self, model: Model) -> SurfaceConstants:
        """Constants with which the force on a unit of surface is exact on the lattice."""
        constants = SurfaceConstants()
        rho_0 = model.the(WeaklyCompressible).reference_density
        constants.support = model.support
        constants.scale = normalisation("poly6", model.dimension, model.support) / rho_0
        constants.threshold = self.threshold / model.support
        chi, constants.depth = model.lattice.surface("poly6", constants.threshold)
        constants.strength = (model.dimension - 1) * self.coefficient / (chi * rho_0)
        return constants
