"""Weakly compressible flow: equation of state, pressure and viscosity, and the pressure of walls."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.bound import Bound
from warpsph.core.equation_of_state import stiffness
from warpsph.core.field import Field
from warpsph.core.hydrostatics import column_pressure
from warpsph.core.labels import Phase, Role
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.kernels.basics.roles import FLUID_ROLES
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow.fluid import FluidConstants
from warpsph.kernels.flow.forces import add_fluid_forces
from warpsph.kernels.flow.wall_pressure import extrapolate_pressure
from warpsph.kernels.solid.prestress import keep_density, keep_pressure
from warpsph.terms.phase_change import PhaseChange
from warpsph.terms.weakly_compressible import DENSEST, SQUEEZED, WeaklyCompressible, largest_shared_viscosity

SAME_DENSITY = 1.0e-6  # relative difference


def _reference_density(model: Model) -> float:
    return model.the(Fluid).reference_density


@dataclass(frozen=True, eq=False)
class Fluid(WeaklyCompressible):
    """Weakly compressible flow (Vijaykumar 2012, chapters 1 and 2); a second term finds its density.

    Args:
        reference_density: rho_0 [kg/m^3].
        sound_speed: c_s [m/s], ten times the highest speed or more.
        tension: whether pressure may fall below zero; forbid it where there is a free surface.
    """

    tension: bool = False

    keeps_momentum = True
    provides = ("fluid", "a flow")
    needs = ("forces", "density")
    follows = ("density",)

    density = Field(float, "kg/m^3", "density", start=_reference_density, written=True, renewed=True, colours="cividis")
    pressure = Field(float, "Pa", "pressure", written=True, colours="cividis")
    volume = Field(float, "m^3", "volume (area in 2D)")
    viscosity = Field(float, "Pa s", "viscosity")
    fluid_mass = Field(float, "kg", "mass in the sums of the fluid: walls count like it, spray does not")
    bonded_density = Field(float, "kg/m^3", "what bonded neighbours give to the density")

    def particle_mass(self, model: Model) -> float:
        """That with which the lattice has the reference density."""
        return self.reference_density * model.cell_volume / model.lattice.density()

    def column_density(self, model: Model, depth: float) -> float:
        gravity = float(np.linalg.norm(model.gravity))
        weight = column_pressure(depth, self.reference_density, gravity, self.sound_speed)
        return float(weight) / (gravity * depth)

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        if np.any(fields["density"] <= 0.0):
            raise InputError("particles: 'density' was given values that are not positive [kg/m^3]")
        cells = np.where(particles.volume > 0.0, particles.volume / model.cell_volume, 1.0)
        fluid_mass = np.where(particles.flows, self.particle_mass(model) * cells, 0.0)
        moves = np.isin(fields["role"], (*FLUID_ROLES, Role.RESERVOIR)) & particles.flows
        flowing = moves & (fields["phase"] != Phase.SOLID)
        self._refuse_other_densities(model, fields["material"][moves if model.find(PhaseChange) else flowing])
        densities = np.array([material.density for material in model.materials])[fields["material"]]
        like_the_fluid = np.abs(densities / self.reference_density - 1.0) < SAME_DENSITY
        return {
            "fluid_mass": fluid_mass,
            "mass": np.where(flowing | (moves & like_the_fluid), fluid_mass, fields["mass"]),
            "volume": fluid_mass / self.reference_density,
            "viscosity": np.array([material.viscosity for material in model.materials])[fields["material"]],
        }

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return self.device_constants(model)

    def device_constants(self, model: Model) -> dict[str, object]:
        return {"fluid": fluid_constants(model)}

    def reach(self, model: Model) -> float:
        return model.support

    def _refuse_other_densities(self, model: Model, materials: np.ndarray) -> None:
        """Its sums know one density: of all that flows, or can melt."""
        for index in np.unique(materials):
            material = model.materials[index]
            if abs(material.density / self.reference_density - 1.0) > SAME_DENSITY:
                raise InputError(
                    f"Fluid: {material.name} of {material.density:g} kg/m^3 flows or can melt, but this formulation "
                    f"knows one density of fluids, {self.reference_density:g} kg/m^3; give them the same"
                )

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        """Vijaykumar (2012), equation (7.6) with h = H/2, because the formula comes from a kernel with support 2h.

        A solid that is lighter than the fluid is driven by the same forces.
        """
        h, lightest = 0.5 * model.support, self.lightest(model, moving)
        fastest = self.sound_speed * float(np.sqrt(self.reference_density / lightest))
        drag = 2.0 * 4.9633 * largest_shared_viscosity(model, moving) / (h * lightest)
        return {"sound and viscosity (7.6)": 0.5 * h / (fastest + drag)}

    def bounds(self, model: Model, state: State) -> dict[str, Bound]:
        densest = DENSEST * max(self.reference_density, float(np.max(state.numpy("density"))))
        return {"density": Bound(0.0, densest, SQUEEZED), "pressure": Bound(cause=SQUEEZED)}

    def find_walls(self, launch: Launch) -> None:
        launch(extrapolate_pressure)

    def sum_forces(self, launch: Launch) -> None:
        launch(add_fluid_forces)

    def keep_pressure(self, launch: Launch) -> None:
        launch(keep_pressure)

    def keep_density(self, launch: Launch) -> None:
        launch(keep_density)


def fluid_constants(model: Model) -> FluidConstants:
    """Constants of the flow: smoothing kernels normalised so that their sums are exact on the lattice."""
    fluid, lattice = model.the(Fluid), model.lattice
    constants = FluidConstants()
    constants.support = model.support
    constants.density_scale = normalisation("poly6", model.dimension, model.support)
    constants.reference_density = fluid.reference_density
    constants.stiffness = stiffness(fluid.reference_density, fluid.sound_speed)
    constants.lowest_pressure = -1.0e30 if fluid.tension else 0.0
    gradient = lattice.slope("spiky") / lattice.density()
    viscosity = lattice.curvature("viscosity") / lattice.density()
    constants.pressure_scale = normalisation("spiky", model.dimension, model.support) / gradient
    constants.bond_damping = model.dimension + 2.0
    constants.viscosity_scale = normalisation("viscosity", model.dimension, model.support) / viscosity
    return constants
