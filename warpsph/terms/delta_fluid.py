"""Classic delta-SPH: one sweep over the neighbours a step, and forces that keep momentum."""

from dataclasses import dataclass
from typing import cast

import numpy as np
import warp as wp

from warpsph.core.bound import Bound
from warpsph.core.faces import require_faces
from warpsph.core.field import Field
from warpsph.core.labels import Phase
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.core.waves import wave_rates
from warpsph.errors import InputError, number, require
from warpsph.kernels.basics.host import on_host
from warpsph.kernels.basics.roles import FLUID_ROLES
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow.corrected.scheme import FlowConstants, tell_parts
from warpsph.kernels.flow.corrected.walls import continue_into_walls
from warpsph.kernels.flow.delta import compression_pressure, correct, predict, sum_delta_rates
from warpsph.terms.corrected_fluid import MOST_SQUEEZED, SAME_DENSITY, CorrectedFluid
from warpsph.terms.weakly_compressible import SOUND_LIMIT, SQUEEZED, largest_shared_viscosity

SOUND_STEP, VISCOUS_STEP, GRAVITY_STEP = 0.4, 0.125, 0.25  # longest steps in dx / c, h^2 / nu and sqrt(h / g)

DAMPING_STEP = 0.5  # longest step over what velocities, and the density, take to decay; beyond 1 either diverges


def _reference_density(model: Model) -> float:
    return model.the(DeltaFluid).reference_density


@dataclass(frozen=True, eq=False)
class DeltaFluid(Term):
    """Weakly compressible flow as most programs have it, for comparisons: no corrected gradients, no shifting.

    Continuity with density diffusion, p_i + p_j, artificial and laminar viscosity; walls as those of
    :class:`~warpsph.terms.corrected_fluid.CorrectedFluid`. Steps are leapfrogs whose rates are found once, from
    velocities and densities carried on by the rates before.

    Args:
        reference_density: rho_0 [kg/m^3].
        sound_speed: c [m/s], ten times the highest speed or more.
        free_surface: whether there is one: walls then do not pull.
        density_diffusion: delta.
        artificial_viscosity: alpha; in the plane it acts like a kinematic viscosity of alpha h c / 8.
        exponent: gamma of Tait's equation of state; 1 makes pressure linear in density.
        background_pressure: added to it everywhere [Pa], at most rho_0 c^2: what is disordered flies apart with it.
    """

    reference_density: float
    sound_speed: float
    free_surface: bool = False
    density_diffusion: float = 0.1
    artificial_viscosity: float = 0.02
    exponent: float = 1.0
    background_pressure: float = 0.0

    def __post_init__(self) -> None:
        for name in ("density_diffusion", "artificial_viscosity", "background_pressure"):
            require(self, name, 0.0 <= number(getattr(self, name)) < np.inf, "zero or positive")
        require(self, "reference_density", 0.0 < number(self.reference_density) < np.inf, "positive [kg/m^3]")
        require(self, "sound_speed", 0.0 < number(self.sound_speed) < np.inf, "positive [m/s]")
        require(self, "free_surface", isinstance(self.free_surface, bool | np.bool_), "True or False")
        stiff = number(self.background_pressure) <= self.bulk_modulus
        allowed = f"at most rho_0 c^2 = {self.bulk_modulus:g} Pa; a higher sound_speed allows more"
        require(self, "background_pressure", stiff, allowed)
        require(self, "exponent", 1.0 <= number(self.exponent) <= 10.0, "from 1, linear, to 10")

    keeps_momentum = True
    provides = ("a flow",)
    needs = ("second-order motion",)

    density = Field(float, "kg/m^3", "density", start=_reference_density, written=True, renewed=True, colours="cividis")
    pressure = CorrectedFluid.pressure
    viscosity = CorrectedFluid.viscosity
    fluid_mass = CorrectedFluid.fluid_mass
    part = CorrectedFluid.part
    compression = CorrectedFluid.compression
    ghost_velocity = CorrectedFluid.ghost_velocity
    to_surface = CorrectedFluid.to_surface
    compression_rate = Field(float, "1/s", "rate of compression", renewed=True)
    last_acceleration = Field(wp.vec3, "m/s^2", "acceleration one step ago", kept=False)
    last_rate = Field(float, "1/s", "rate of compression one step ago", kept=False)

    @property
    def bulk_modulus(self) -> float:
        """rho_0 c^2 [Pa]."""
        return self.reference_density * self.sound_speed**2

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        require_faces(fields, particles.flows)
        free = np.isin(fields["role"], FLUID_ROLES) & particles.flows
        self._refuse_solids(model, fields["phase"][free])
        self._refuse_other_densities(model, fields["material"][free])
        s = fields["compression"]
        pressure = on_host(cast(wp.Function, compression_pressure))(s, self.bulk_modulus, self.exponent)
        mass = np.full(len(particles), self.reference_density * model.cell_volume)
        return {
            "mass": mass,
            "fluid_mass": mass,
            "viscosity": np.array([material.viscosity for material in model.materials])[fields["material"]],
            "ghost_velocity": fields["velocity"],
            "density": self.reference_density * (1.0 + s),
            "pressure": self.background_pressure + pressure,
        }

    def _refuse_solids(self, model: Model, phases: np.ndarray) -> None:
        """Fluid would bear on them as on walls, and nothing on them."""
        for term in model.terms:
            if "elasticity" in term.provides or "a change of phase" in term.provides:
                raise InputError(
                    f"DeltaFluid and {type(term).__name__} exclude each other: it knows no solids but walls; "
                    "take CorrectedFluid or Fluid"
                )
        if np.any(phases == Phase.SOLID):
            raise InputError("DeltaFluid: it knows no solids but walls; take CorrectedFluid or Fluid for free ones")

    def _refuse_other_densities(self, model: Model, materials: np.ndarray) -> None:
        for index in np.unique(materials):
            material = model.materials[index]
            if abs(material.density / self.reference_density - 1.0) > SAME_DENSITY:
                raise InputError(
                    f"DeltaFluid: {material.name} of {material.density:g} kg/m^3 flows, but this formulation knows one "
                    f"density, reference_density = {self.reference_density:g} kg/m^3; give them the same, or take "
                    "CorrectedFluid"
                )

    def constants(self, model: Model, state: State) -> dict[str, object]:
        H, dx, h = model.support, model.spacing, 0.5 * model.support
        flow = FlowConstants()
        flow.support, flow.spacing, flow.volume = H, dx, model.cell_volume
        flow.slope_scale = model.cell_volume * normalisation("wendland_c2", model.dimension, H)
        flow.bulk_modulus = self.bulk_modulus
        flow.diffusion = 2.0 * self.density_diffusion * h
        flow.artificial = self.artificial_viscosity * h
        flow.free_surface = int(self.free_surface)
        return {"flow": flow, "exponent": self.exponent, "background_pressure": self.background_pressure}

    def reach(self, model: Model) -> float:
        return model.support

    def bounds(self, model: Model, state: State) -> dict[str, Bound]:
        return {"compression": Bound(-1.0, MOST_SQUEEZED, SQUEEZED), "pressure": Bound(cause=SQUEEZED)}

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        h, g = 0.5 * model.support, float(np.linalg.norm(model.gravity))
        stiffest = float(np.sqrt(self.sound_speed**2 + 2.0 * self.background_pressure / self.reference_density))
        steps = {"sound": SOUND_STEP * model.spacing / stiffest}
        if (viscosity := largest_shared_viscosity(model, moving)) > 0.0:
            steps["viscosity"] = VISCOUS_STEP * h**2 * self.reference_density / viscosity
        if g > 0.0:
            steps["gravity"] = GRAVITY_STEP * np.sqrt(h / g)
        waves = wave_rates(model.lattice, "wendland_c2")
        rates = {
            "artificial viscosity": self.artificial_viscosity * h * self.sound_speed * waves.along,
            "diffusion of the density": 2.0 * self.density_diffusion * h * self.sound_speed * waves.spread,
        }
        return steps | {reason: DAMPING_STEP / rate for reason, rate in rates.items() if rate > 0.0}

    def speed_limit(self, model: Model) -> float:
        return SOUND_LIMIT * self.sound_speed

    def arrive(self, launch: Launch) -> None:
        launch(predict)

    def find_walls(self, launch: Launch) -> None:
        launch(tell_parts)
        launch.meet()
        launch(continue_into_walls)

    def sum_forces(self, launch: Launch) -> None:
        launch(sum_delta_rates)

    def kick(self, launch: Launch) -> None:
        launch(correct)
