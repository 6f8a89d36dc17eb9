"""A weakly compressible flow that is calm at rest and exact at walls."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.bound import Bound
from warpsph.core.faces import require_faces
from warpsph.core.field import Field
from warpsph.core.labels import Phase, Role
from warpsph.core.launch import Launch
from warpsph.core.materials import Material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.waves import wave_rates
from warpsph.errors import InputError, number, require
from warpsph.kernels.basics import smoothing
from warpsph.kernels.basics.host import on_host
from warpsph.kernels.basics.roles import FLUID_ROLES
from warpsph.kernels.flow.corrected.forces import ADD_FLOW_FORCES
from warpsph.kernels.flow.corrected.gradients import FIND_GRADIENTS, compress
from warpsph.kernels.flow.corrected.scheme import FlowConstants, tell_parts
from warpsph.kernels.flow.corrected.shifting import shift_half
from warpsph.kernels.flow.corrected.solids import press_on_solids
from warpsph.kernels.flow.corrected.walls import continue_into_walls
from warpsph.kernels.solid.prestress import keep_flow_pressure
from warpsph.terms.fluid import Fluid
from warpsph.terms.weakly_compressible import SQUEEZED, WeaklyCompressible

SMOOTHING_KERNEL = "wendland_c2"
HALF_A_CELL = 0.51  # from the middle of a face to an edge, with a little more for rounding
LONGEST_DELAY = 5.0  # of the pressure: what is disordered gains energy from 20 on, in steps of any length
LONGEST_DELAY_AT_SURFACE = 0.5  # sheets two rows thick gain some from 1.5 on
ANISOTROPY = {2: 2.0, 3: 2.5}
LARGEST_RATIO = 10.0  # of two densities: layers at rest are calm up to 30, and fly apart at 100
MOST_SQUEEZED = 4.0  # compression at which a run counts as diverged; single particles under a jet pass 1 and recover
SAME_DENSITY = 1.0e-6  # relative difference
SOUND_STEP, VISCOUS_STEP = 1.0, 0.15  # longest steps in dx / c and dx^2 / nu
DAMPING_STEP = 1.0  # longest step over what velocities, and the density, take to decay; beyond 1.6 either diverges
SOLID_STEP = 0.5  # longest step in dx / c with solids: at 1 the shell of a casting mould diverged
SURFACE_STEP = 0.7  # the same with a free surface: at 1 impacts at Mach 0.3 may diverge


def _reference_density(model: Model) -> float:
    return model.the(CorrectedFluid).reference_density


def _has_elasticity(model: Model) -> bool:
    return any("elasticity" in term.provides for term in model.terms)


@dataclass(frozen=True, eq=False)
class CorrectedFluid(WeaklyCompressible):
    """Weakly compressible flow with gradients that are exact for linear fields, in two sweeps a step.

    Density by continuity with the diffusion of delta-SPH (Antuono et al. 2010), pressure differences and viscosity
    corrected by the moment matrix (Bonet & Lok 1999), walls after Adami, Hu & Adams (2012) with a velocity fitted
    through the wall's own, shifting after Sun et al. (2017).

    Each fluid has the density and the viscosity of its material, a pair the harmonic mean of the viscosities. All have
    one bulk modulus rho_0 c^2, so that compression goes on through an interface, and sound is faster in a lighter one.

    Args:
        reference_density: rho_0 [kg/m^3], that of one of the fluids.
        sound_speed: c [m/s] in that one, ten times the highest speed or more.
        free_surface: whether there is one: walls then do not pull, and the surface bears no tension.
        density_diffusion: delta.
        artificial_viscosity: alpha; it acts on what a velocity has beside its linear part.
        surface_viscosity: alpha at and near a free surface, None for the same. A fluid at rest feeds on the change from
            corrected to plain sums there: 0.2 calms it, and takes 0.2 % more of the energy of a patch of 50 rows that
            stretches to twice its length.
        bulk_delay: tau, by which pressure leads the compression, in h / c; at most 5, with a free surface 0.5.
        shifting: speed by which particles spread evenly, in h times the gradient of their concentration.
    """

    free_surface: bool = False
    density_diffusion: float = 0.1
    artificial_viscosity: float = 0.05
    surface_viscosity: float | None = None
    bulk_delay: float = 0.2
    shifting: float = 8.0

    def __post_init__(self) -> None:
        for name in ("density_diffusion", "artificial_viscosity", "bulk_delay", "shifting"):
            require(self, name, 0.0 <= number(getattr(self, name)) < np.inf, "zero or positive")
        if self.surface_viscosity is not None:
            require(self, "surface_viscosity", 0.0 <= number(self.surface_viscosity) < np.inf, "zero or positive")
        require(self, "free_surface", isinstance(self.free_surface, bool | np.bool_), "True or False")
        longest = LONGEST_DELAY_AT_SURFACE if self.free_surface else LONGEST_DELAY
        where = " with a free surface" if self.free_surface else ""
        bears = self.bulk_delay <= longest
        require(self, "bulk_delay", bears, f"at most {longest:g}{where}; artificial_viscosity damps more than that")
        super().__post_init__()

    provides = ("fluid", "a flow", "density", "a density by continuity")
    needs = ("forces", "second-order motion")

    density = Field(float, "kg/m^3", "density", start=_reference_density, written=True, renewed=True, colours="cividis")
    pressure = Fluid.pressure
    viscosity = Fluid.viscosity
    volume = Fluid.volume
    fluid_mass = Fluid.fluid_mass
    part = Field(int, "", "what it is to the flow: 0 nothing, 1 fluid, 2 solid, 3 wall", kept=False)
    compression = Field(float, "", "density over the reference density, less one", renewed=True)
    compression_slope = Field(wp.vec3, "1/m", "gradient of the compression", renewed=True)
    compression_rate = Field(float, "1/s", "rate of compression", kept=False)
    next_slope = Field(wp.vec3, "1/m", "gradient of the compression in this step", kept=False)
    divergence = Field(float, "1/s", "divergence of the velocity", kept=False)
    velocity_gradient = Field(wp.mat33, "1/s", "gradient of the velocity", kept=False)
    moment = Field(wp.mat33, "", "moment matrix of the neighbours", kept=False)
    surface = Field(int, "", "0 inside the fluid, 1 near its surface, 2 at it")
    is_near = Field(int, "", "whether a neighbour is at the surface", renewed=True)
    shift_velocity = Field(wp.vec3, "m/s", "velocity of the particle beside that of the fluid", renewed=True)
    ghost_velocity = Field(wp.vec3, "m/s", "velocity that a wall shows to the fluid")
    to_surface = Field(wp.vec3, "m", "way from a wall particle to the face of the wall")

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        require_faces(fields, particles.flows)
        mass = self.particle_mass(model)
        own = np.array([material.density for material in model.materials])[fields["material"]]
        moves = np.isin(fields["role"], (*FLUID_ROLES, Role.RESERVOIR)) & particles.flows
        free = (fields["role"] == Role.FREE) & particles.flows
        self._refuse_loose_solids(model, bool(np.any(fields["phase"][free] == Phase.SOLID)))
        self._refuse_densities(np.unique(own[moves & (fields["phase"] != Phase.SOLID)]))
        return {
            "mass": np.where(moves, own * model.cell_volume, fields["mass"]),
            "fluid_mass": np.where(particles.flows, mass, 0.0),
            "volume": np.where(particles.flows, model.cell_volume, 0.0),
            "viscosity": np.array([material.viscosity for material in model.materials])[fields["material"]],
            "ghost_velocity": fields["velocity"],
            "density": np.where(moves, own, self.reference_density) * (1.0 + fields["compression"]),
        }

    def _refuse_loose_solids(self, model: Model, there: bool) -> None:
        """Solid particles that are ``there``, or will be where something freezes, are held together by bonds only."""
        freezes = next((type(term).__name__ for term in model.terms if "a change of phase" in term.provides), None)
        if (there or freezes) and not _has_elasticity(model):
            found = f"{freezes} makes solids" if freezes else "some free particles are solid"
            raise InputError(f"CorrectedFluid: {found}, but nothing holds them together: add Elasticity to the terms")

    def _refuse_densities(self, flowing: np.ndarray) -> None:
        """Densities (n,) [kg/m^3] of what flows: one is the reference, and they do not differ too much."""
        if len(flowing) and flowing.max() > LARGEST_RATIO * flowing.min():
            raise InputError(
                f"CorrectedFluid: fluids of {flowing.min():g} and {flowing.max():g} kg/m^3: the heaviest may have "
                f"{LARGEST_RATIO:g} times the density of the lightest; leave the lightest out, behind a free surface"
            )
        if len(flowing) and np.abs(flowing / self.reference_density - 1.0).min() > SAME_DENSITY:
            raise InputError(
                f"CorrectedFluid: reference_density = {self.reference_density:g} kg/m^3 is that of none of the fluids; "
                f"give {flowing.max():g}"
            )

    def particle_mass(self, model: Model) -> float:
        return self.reference_density * model.cell_volume

    def column_density(self, model: Model, depth: float) -> float:
        return self.reference_density

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return self.device_constants(model)

    def device_constants(self, model: Model) -> dict[str, object]:
        return {"flow": flow_constants(model)}

    def reach(self, model: Model) -> float:
        return model.support

    def bounds(self, model: Model, state: State) -> dict[str, Bound]:
        return {"compression": Bound(-1.0, MOST_SQUEEZED, SQUEEZED), "pressure": Bound(cause=SQUEEZED)}

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        dx = model.spacing
        fastest = self.sound_speed * float(np.sqrt(self.reference_density / self.lightest(model, moving)))
        with_solids = _has_elasticity(model)
        sound_step = SOLID_STEP if with_solids else SURFACE_STEP if self.free_surface else SOUND_STEP
        steps = {"sound": sound_step * dx / fastest}
        if (thickest := self._largest_diffusivity([model.materials[m] for m in moving], with_solids)) > 0.0:
            steps["viscosity"] = VISCOUS_STEP * dx**2 / thickest
        return steps | self._damping_steps(model, fastest)

    def _largest_diffusivity(self, moving: list[Material], with_solids: bool) -> float:
        """The largest kinematic viscosity [m^2/s] of a pair: a mean of two fluids, that of the fluid for a solid."""
        pairs = [(own.density, own.viscosity, other.viscosity) for own in moving for other in moving]
        if with_solids:
            return max((viscosity / density for density, _, viscosity in pairs), default=0.0)
        return max((2.0 * a * b / (a + b) / density for density, a, b in pairs if a + b > 0.0), default=0.0)

    def _damping_steps(self, model: Model, fastest: float) -> dict[str, float]:
        """Longest steps [s] by what is damped, where sound is ``fastest`` [m/s]; explicit steps overshoot beyond it."""
        waves, h = wave_rates(model.lattice, SMOOTHING_KERNEL), 0.5 * model.support
        artificial = max(self.artificial_viscosity, self.surface_viscosity or 0.0) * h * fastest * waves.along
        delayed = self.bulk_delay * h / self.sound_speed * (fastest * waves.slope) ** 2
        rates = {
            "artificial viscosity and delay of the pressure": artificial + delayed,
            "diffusion of the density": 2.0 * self.density_diffusion * h * fastest * waves.spread,
        }
        return {reason: DAMPING_STEP / rate for reason, rate in rates.items() if rate > 0.0}

    def set_out(self, launch: Launch) -> None:
        launch(shift_half)

    def find_density(self, launch: Launch) -> None:
        launch(tell_parts)
        launch.meet()
        launch(FIND_GRADIENTS[launch.find("flow").dimension])
        launch.meet()

    def arrive(self, launch: Launch) -> None:
        launch(compress)
        launch(shift_half)

    def find_walls(self, launch: Launch) -> None:
        launch(continue_into_walls)

    def sum_forces(self, launch: Launch) -> None:
        launch(ADD_FLOW_FORCES[launch.find("flow").dimension])
        launch(press_on_solids)

    def keep_pressure(self, launch: Launch) -> None:
        launch(keep_flow_pressure)


def flow_constants(model: Model) -> FlowConstants:
    """Constants of the corrected flow for the device; h is half the support."""
    fluid = model.the(CorrectedFluid)
    H, dx = model.support, model.spacing
    h = 0.5 * H
    flow = FlowConstants()
    flow.support, flow.spacing, flow.volume = H, dx, model.cell_volume
    flow.beside = HALF_A_CELL * dx * float(np.sqrt(model.dimension - 1.0))
    flow.scale = model.cell_volume * smoothing.normalisation(SMOOTHING_KERNEL, model.dimension, H)
    flow.slope_scale = flow.scale / model.lattice.slope(SMOOTHING_KERNEL)
    flow.bulk_modulus = fluid.reference_density * fluid.sound_speed**2
    flow.bulk_delay = fluid.bulk_delay * h / fluid.sound_speed
    flow.diffusion = 2.0 * fluid.density_diffusion * h
    flow.artificial = fluid.artificial_viscosity * h
    at_surface = fluid.artificial_viscosity if fluid.surface_viscosity is None else fluid.surface_viscosity
    flow.artificial_at_surface = at_surface * h
    flow.quadratic = 2.0 * h * h
    flow.shifting = fluid.shifting * h
    flow.highest_shift_speed = 0.1 * fluid.sound_speed
    nearest = on_host(getattr(smoothing, f"{SMOOTHING_KERNEL}_value"))(dx * dx, H)
    flow.inverse_nearest = 1.0 / (flow.scale * float(nearest))
    flow.anisotropy = ANISOTROPY[model.dimension]
    flow.dimension = model.dimension
    flow.free_surface = int(fluid.free_surface)
    return flow
