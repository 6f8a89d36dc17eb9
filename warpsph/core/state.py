"""What changes in a run: one array per quantity, one entry per particle."""

import numpy as np
import warp as wp

from warpsph.core.labels import Phase, Role
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.kernels.solid.bonds import BondList

WRITTEN_EVERY_STEP = {"acceleration", "surface_normal", "deformation", "stress", "heat_rate"}


class State:
    """Particles on the device, as a structure of arrays.

    Always: ``id`` (stable for the whole run), ``role``, ``material``, ``phase``, ``position`` [m] with
    ``position_carry``, ``velocity`` [m/s], ``mass`` [kg] (per metre of depth in 2D). With a fluid or elasticity:
    ``acceleration`` [m/s^2]. With a fluid: ``density`` [kg/m^3], ``pressure`` [Pa], ``volume`` [m^3 or m^2],
    ``viscosity`` [Pa s], and ``fluid_mass`` [kg], the mass with which a particle enters the sums of the fluid (walls
    count like the fluid, spray does not count). With conduction: ``enthalpy`` [J/kg] with ``enthalpy_carry``,
    ``temperature`` [K], ``solid_fraction``, ``conductivity`` [W/(m K)], ``thermal_volume``, ``heat_rate`` [W],
    ``held``, ``heat_held`` [J]. With phase change or elasticity: ``froze``. With surface tension: ``surface_normal``.
    With elasticity: ``bonds``, ``body_volume`` [m^3 or m^2], ``correction``, ``deformation``, ``stress``, and with
    contact ``body``. Devices may add arrays by :meth:`add`; arrays move with their particles when these are sorted.
    """

    def __init__(self, particles: Particles, model: Model, device: wp.Device):
        self.device = device
        self.count = n = len(particles)
        self.per_particle: dict[str, wp.array] = {}
        self.bonds: BondList | None = None
        role, material = particles.role, particles.material
        densities = np.array([m.density for m in model.materials])

        self.add("id", np.arange(n), int)
        self.add("role", role, int)
        self.add("material", material, int)
        self.add("position", particles.position, wp.vec3)
        self.add("position_carry", np.zeros((n, 3)), wp.vec3)
        self.add("velocity", particles.velocity, wp.vec3)
        volume = np.where(particles.volume > 0.0, particles.volume, model.cell_volume)
        mass = densities[material] * volume
        self.add("phase", particles.phase, int)
        if model.fluid is not None:
            lattice_mass = model.fluid.reference_density * model.cell_volume / model.lattice_density()
            fluid_mass = np.where(particles.flows, lattice_mass, 0.0)
            moves = np.isin(role, (Role.FREE, Role.INFLOW, Role.OUTFLOW, Role.RESERVOIR))
            mass = np.where(moves & particles.flows, fluid_mass, mass)
            self.add("fluid_mass", fluid_mass, float)
            self.add("density", np.full(n, model.fluid.reference_density), float)
            if model.fluid.continuity:
                self.add("density_carry", np.zeros(n), float)
            self.add("pressure", np.zeros(n), float)
            self.add("volume", fluid_mass / model.fluid.reference_density, float)
            self.add("viscosity", np.array([m.viscosity for m in model.materials])[material], float)
        if model.fluid is not None or model.elasticity is not None:
            self.add("acceleration", np.zeros((n, 3)), wp.vec3)
        self.add("mass", mass, float)
        if model.conduction is not None:
            enthalpy = np.zeros(n)
            for index, substance in enumerate(model.materials):
                mine = material == index
                enthalpy[mine] = substance.enthalpy(particles.temperature[mine])
            self.add("enthalpy", enthalpy, float)
            self.add("enthalpy_carry", np.zeros(n), float)
            self.add("temperature", particles.temperature, float)
            self.add("solid_fraction", np.zeros(n), float)
            self.add("conductivity", np.zeros(n), float)
            self.add("thermal_volume", volume, float)
            self.add("heat_rate", np.zeros(n), float)
            self.add("held", particles.held, int)
            self.add("heat_held", np.zeros(n), wp.float64)
        if model.phase_change is not None or model.elasticity is not None:
            self.add("froze", particles.phase == Phase.SOLID, int)
        if model.surface_tension is not None:
            self.add("surface_normal", np.zeros((n, 3)), wp.vec3)
        if model.elasticity is not None:
            self.bonds = _empty_bonds(n, model, device)
            if model.elasticity.contact:
                self.add("body", particles.body, int)
            self.add("body_volume", mass / densities[material], float)
            for name in ("correction", "deformation", "stress"):
                self.add(name, np.zeros((n, 3, 3)), wp.mat33)

    def add(self, name: str, values: np.ndarray, dtype: type) -> None:
        """Add a per-particle array under ``name`` with the given start values (n, ...)."""
        array = wp.array(np.ascontiguousarray(values), dtype=dtype, device=self.device)
        self.per_particle[name] = array
        setattr(self, name, array)

    def arrays_to_keep(self) -> list[wp.array]:
        """The arrays that must move with their particles; the others are written anew before they are read."""
        return [array for name, array in self.per_particle.items() if name not in WRITTEN_EVERY_STEP]

    def numpy(self, name: str) -> np.ndarray:
        """A copy of one array on the host."""
        return self.per_particle[name].numpy().copy()


def _empty_bonds(n: int, model: Model, device: wp.Device) -> BondList:
    bonds = BondList()
    bonds.capacity = int(1.6 * len(model.lattice_offsets())) + 4
    bonds.count = wp.zeros(n, dtype=int, device=device)
    bonds.partner = wp.zeros(n * bonds.capacity, dtype=int, device=device)
    bonds.separation = wp.zeros(n * bonds.capacity, dtype=wp.vec3, device=device)
    bonds.slope = wp.zeros(n * bonds.capacity, dtype=float, device=device)
    bonds.value = wp.zeros(n * bonds.capacity, dtype=float, device=device)
    return bonds
