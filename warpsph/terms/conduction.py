"""Heat conduction by enthalpy."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsph.core.bound import Bound
from warpsph.core.content import Content
from warpsph.core.field import Field
from warpsph.core.labels import Phase, Role
from warpsph.core.lattice import Lattice
from warpsph.core.launch import Launch
from warpsph.core.materials import Material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.periodic import axes_across
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, require
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.heat.conduction import CONDUCTING, SUM_HEAT, ThermalTable, add_heat, update_temperature
from warpsph.kernels.heat.implicit_conduction import supply_no_heat
from warpsph.kernels.heat.walls import ADD_HEAT_OF_IMAGES, count_heat, find_walls_near
from warpsph.terms.conduction_equations import ConductionEquations
from warpsph.terms.heat_wall import LARGEST, HeatWall, refuse_misfits
from warpsph.terms.implicit_heat import ImplicitHeat
from warpsph.terms.integrators import EXPLICIT, INTEGRATORS, NO_LIMIT, Explicit, Implicit, Integrator
from warpsph.terms.profile import on_device
from warpsph.terms.walls_on_device import hold_walls, profiles_of, walls_on_device

MOST_WALLS = 30  # a bit each
DEFAULT_INTERVAL = 1.0e-3  # [s]
HEAT_LOST = 1.0e-6  # relative: pairs exchange heat exactly, but for the rounding of their rates in single precision
ROUNDING = 1.0e-3  # of the highest temperature that is given, by which one may be below 0 K
NO_NUMBER = "a source, a film or an interval that is far too large, or somebody has set it; look at observers and parts"
TOO_MUCH_TAKEN = (
    "more heat is taken from it than it holds; weaken the sinks or fluxes that take it, or take it for a shorter time"
)

# Longest interval by smoothing kernel, in rho c H^2 / k, and its source; what lattices bear, H = 2 to 3 dx.
STABLE = {
    "poly6": (0.1, "(7.7)", 0.1),  # Vijaykumar (7.7) with zeta = 0.1 and the support H
    "cubic_spline": (0.15 / 4.0, "(2.20)", 0.081),  # Monaghan (2.20), with H = 2h
}


@dataclass(frozen=True, eq=False)
class Conduction(Term):
    """Heat conduction by enthalpy (Vijaykumar 2012, chapter 3).

    Args:
        films: conductance [W/(m^2 K)] of a film between two materials, by their names; 0 lets no heat pass.
        longest_interval: largest time between two conduction steps [s], beside the stability limit; by default 1 ms. An
            implicit integrator has no such limit and must be given one.
        walls: planes on which temperature, film, flux or insulation is given.
        smoothing: name of the smoothing kernel, one of :data:`warpsph.kernels.heat.conduction.CONDUCTING`.
        support_ratio: its support over the spacing, by default that of the model; a cubic spline of smoothing length h
            has the support 2h.
        exact_on_lattice: whether the sum is divided by what the lattice makes of a linear profile.
        sharp_fronts: whether a particle of a pure substance that freezes has a front in it, solid on its colder side
            and liquid on the other, instead of one conductivity in between. For what is at rest on a lattice.
        integrator: ``Explicit()``, ``BackwardEuler()`` or ``CrankNicolson()``.

    One with walls belongs to one simulation; ``wall_conductance``, ``wall_outside`` and ``wall_flux`` (walls,) are then
    device arrays that may be changed during a run. What a wall has a profile of follows the profile; its entry there is
    the mean and to be left alone.
    """

    films: dict[tuple[str, str], float] = field(default_factory=dict)
    longest_interval: float | None = None
    walls: Sequence[HeatWall] = ()
    smoothing: str = "poly6"
    support_ratio: float | None = None
    exact_on_lattice: bool = True
    sharp_fronts: bool = False
    integrator: Integrator = EXPLICIT

    smoothing_kernels: ClassVar[tuple[str, ...]] = CONDUCTING
    heat_lost: ClassVar[float] = HEAT_LOST

    def __post_init__(self) -> None:
        given = self.longest_interval is not None
        require(self, "longest_interval", not given or number(self.longest_interval) > 0.0, "positive [s]")
        require(self, "integrator", isinstance(self.integrator, Integrator), INTEGRATORS)
        finite = given and np.isfinite(number(self.longest_interval))
        if isinstance(self.integrator, Implicit) and not finite:
            raise InputError(f"Conduction: longest_interval: {NO_LIMIT}")
        allowed = "conductances [W/(m^2 K)] by pair of names of materials, as in {('steel', 'copper'): 1500.0}"
        require(self, "films", isinstance(self.films, dict), allowed)
        for pair, conductance in self.films.items():
            named = isinstance(pair, tuple) and len(pair) == 2 and all(isinstance(name, str) for name in pair)
            require(self, "films", named and 0.0 <= number(conductance) <= LARGEST, allowed)
        several = isinstance(self.walls, Sequence) and all(isinstance(wall, HeatWall) for wall in self.walls)
        require(self, "walls", several, "a tuple of HeatWall")
        require(self, "walls", len(self.walls) <= MOST_WALLS, f"{MOST_WALLS} at most")
        known = self.smoothing_kernels
        require(self, "smoothing", self.smoothing in known, f"one of {', '.join(known)}")
        ratio = self.support_ratio
        require(self, "support_ratio", ratio is None or 1.2 <= number(ratio) <= 10.0, "from 1.2 to 10 spacings")

    provides = ("conduction", "temperature")

    temperature = Field(float, "K", "temperature", start=293.15, least=0.0, written=True, colours="inferno")
    enthalpy = Field(float, "J/kg", "specific enthalpy", compensated=True, written=True, colours="inferno")
    solid_fraction = Field(float, "", "solid fraction", written=True, colours="YlGnBu")
    conductivity = Field(float, "W/(m K)", "thermal conductivity")
    thermal_volume = Field(float, "m^3", "mass over the material's density (per metre of depth in 2D)")
    heat_rate = Field(float, "W", "heat gained in unit time (per metre of depth in 2D)", kept=False)
    held = Field(int, "", "whether the temperature stays and the heat is counted")
    heat_held = Field(wp.float64, "J", "heat taken while the temperature was held (per metre of depth in 2D)")

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        enthalpy = np.zeros(len(particles))
        for index, substance in enumerate(model.materials):
            mine = fields["material"] == index
            is_solid = fields["phase"][mine] == Phase.SOLID
            enthalpy[mine] = substance.start_enthalpy(fields["temperature"][mine], is_solid)
            colder = mine & particles.was_given("enthalpy") & (fields["enthalpy"] < substance.enthalpy(0.0))
            if np.any(colder):
                given = np.min(fields["enthalpy"][colder])
                raise InputError(
                    f"particles: 'enthalpy' = {given:g} J/kg: must not be below that of {substance.name} at 0 K, "
                    f"{substance.enthalpy(0.0):g} J/kg"
                )
        volume = np.where(particles.volume > 0.0, particles.volume, model.cell_volume)
        refuse_misfits(self.walls, self.lattice(model), particles.position)
        return {"enthalpy": enthalpy, "thermal_volume": volume}

    def allocate(self, model: Model, state: State) -> None:
        if isinstance(self.integrator, Explicit) and not self.walls:
            return
        if "_implicit" in self.__dict__ or self.arrays:
            raise InputError("this Conduction belongs to another simulation already; make a new one")
        if isinstance(self.integrator, Implicit):
            self.__dict__["_implicit"] = ImplicitHeat(self.integrator, self._equations(model), state)
        if self.walls:
            self.arrays.update(hold_walls(self.walls, state))

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return axes_across(*(wall.normal for wall in self.walls))

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {
            "table": self._table(model, state.device),
            "walls": walls_on_device(self.walls, self.arrays, model.spacing, state.count, state.device),
            "profiles": on_device(profiles_of(self.walls), state.device),
        }

    def lattice(self, model: Model) -> Lattice:
        """The lattice of particles, with the support of conduction."""
        return Lattice(model.dimension, model.spacing, self.support_ratio or model.support_ratio)

    def reach(self, model: Model) -> float:
        return self.lattice(model).support

    def longest_intervals(self, model: Model) -> dict[str, float]:
        """By pair of materials, for the conductivity that the pair has, and the longest interval asked for."""
        limits = {"longest interval": self.longest_interval or DEFAULT_INTERVAL}
        if isinstance(self.integrator, Implicit):
            return limits
        films, support = self._films(model), self.lattice(model).support
        share, equation = self.stable_share(model)
        for a, material in enumerate(model.materials):
            capacity = float(np.min(_heat_capacities(material)))
            for b, other in enumerate(model.materials):
                conductivity = _harmonic(_highest_conductivity(material), _highest_conductivity(other))
                if np.isfinite(films[a, b]):
                    conductivity = 0.5 * _harmonic(conductivity, films[a, b] * support)
                if conductivity > 0.0:
                    limits[f"conduction {material.name}-{other.name} {equation}"] = (
                        share * material.density * capacity * support**2 / conductivity
                    )
        return limits

    def stable_share(self, model: Model) -> tuple[float, str]:
        """Longest stable interval in rho c H^2 / k, and where it comes from."""
        share, equation, borne = STABLE[self.smoothing]
        if self.sharp_fronts:
            share = min(share, 0.5 * borne)  # a thin layer lets up to twice as much pass
        return share, equation

    def sum_heat(self, launch: Launch) -> None:
        if self.implicit is not None:
            launch(supply_no_heat)
            return
        launch(SUM_HEAT[self.sharp_fronts][self.smoothing])
        if self.walls:
            launch(find_walls_near, ago=launch.find("interval"))
            launch(ADD_HEAT_OF_IMAGES[self.sharp_fronts][self.smoothing])

    def add_heat(self, launch: Launch) -> None:
        if self.implicit is not None:
            launch.on_host(partial(self.implicit.advance, launch, launch.find("interval")))
            return
        launch(add_heat)
        if self.walls:
            launch(count_heat)

    def find_temperature(self, launch: Launch) -> None:
        launch(update_temperature)

    def summary(self) -> dict[str, str]:
        return {} if self.implicit is None else self.implicit.summary()

    def bounds(self, model: Model, state: State) -> dict[str, Bound]:
        outside = [np.max(w.profiles["outside"].table) if "outside" in w.profiles else w.outside for w in self.walls]
        highest = float(max([np.max(state.numpy("temperature")), *outside]))
        return {
            "enthalpy": Bound(cause=NO_NUMBER),
            "temperature": Bound(-ROUNDING * (highest or 1.0), cause=TOO_MUCH_TAKEN),
        }

    @property
    def implicit(self) -> ImplicitHeat | None:
        """What solves the steps of an implicit integrator, once it belongs to a simulation."""
        return self.__dict__.get("_implicit")

    @property
    def wall_conductance(self) -> wp.array:
        """Conductance (walls,) [W/(m^2 K)] of each wall."""
        return self.arrays["wall_conductance"]

    @property
    def wall_outside(self) -> wp.array:
        """Temperature (walls,) [K] of each wall, or behind its film."""
        return self.arrays["wall_outside"]

    @property
    def wall_flux(self) -> wp.array:
        """Flux (walls,) [W/m^2] that leaves by each wall, beside what passes its film."""
        return self.arrays["wall_flux"]

    def contents(self, model: Model, state: State) -> dict[str, Content]:
        return {"heat": self.heat_of(state, state.numpy("role") != Role.RESERVOIR)}

    def heat_of(self, state: State, which: np.ndarray) -> Content:
        """Heat of ``which`` (n,) of the particles [J], with what single precision has lost of it."""
        enthalpy = state.numpy("enthalpy").astype(float) - state.numpy("enthalpy_carry")
        heat = (state.numpy("mass") * enthalpy)[which]
        return Content(float(np.sum(heat)), float(np.sum(np.abs(heat))), "J", self.heat_lost)

    def gains(self, state: State) -> dict[str, dict[str, float | np.ndarray]]:
        held, walls = float(np.sum(state.numpy("heat_held"))), float(np.sum(self.heat_to_walls()))
        return {"heat": {"held particles": -held, "walls": -walls}}

    def heat_to_walls(self) -> np.ndarray:
        """Heat (walls,) [J] that each wall has taken so far (per metre of depth in 2D).

        What the ``held`` particles of a row on the wall have taken stands in ``heat_held``.
        """
        return self._of_walls("wall_heat")

    def rate_to_walls(self) -> np.ndarray:
        """Heat (walls,) [W] that each wall took in unit time in the last step with heat (per metre of depth in 2D)."""
        return self._of_walls("wall_rate")

    def _of_walls(self, name: str) -> np.ndarray:
        if not self.walls:
            return np.zeros(0)
        if name not in self.arrays:
            raise InputError("Conduction: it belongs to no simulation yet; build one first")
        return self.arrays[name].numpy().sum(axis=1, dtype=float)

    def _equations(self, model: Model) -> ConductionEquations:
        kept = any("conductivity" in term.provides for term in model.terms)
        same = all(material.conductivity_solid == material.conductivity_liquid for material in model.materials)
        return ConductionEquations(
            self.smoothing,
            self.sharp_fronts,
            mixing=not kept,
            bend=not (kept or same),
            change=any(len(profile.times) > 1 for profile in profiles_of(self.walls)),
            symmetric=all(wall.conductance in (0.0, np.inf) for wall in self.walls),
            walls=len(self.walls),
        )

    def _films(self, model: Model) -> np.ndarray:
        """Conductivity over distance (materials, materials) [W/(m^2 K)] in series with a pair, infinite without a film.

        Two lattices of one temperature each, with a film that hinders more than they do, then exchange the exact heat
        through a flat interface: pairs at an angle to it are longer than their way across.
        """
        lattice, films = self.lattice(model), np.full((len(model.materials),) * 2, np.inf)
        straight = 0.5 * lattice.slope(self.smoothing) / lattice.detour(self.smoothing)
        for pair, conductance in self.films.items():
            a, b = (model.index_of(name) for name in pair)
            if films[a, b] not in (np.inf, conductance * straight):
                raise InputError(f"Conduction: films: {pair[0]} and {pair[1]} have two different conductances")
            films[a, b] = films[b, a] = conductance * straight
        return films

    def _table(self, model: Model, device: wp.Device) -> ThermalTable:
        """Enthalpy curves, melting ranges, conductivities and films of all materials, on the device."""
        nodes = max(len(m.temperatures) for m in model.materials)
        temperature, enthalpy = (np.zeros((len(model.materials), nodes)) for _ in range(2))
        for index, material in enumerate(model.materials):
            highest = material.temperatures[-1] + np.arange(1, nodes - len(material.temperatures) + 1)
            temperature[index] = np.concatenate([material.temperatures, highest])
            enthalpy[index] = np.concatenate([material.enthalpies, material.enthalpy(highest)])
        table: Any = ThermalTable()
        table.temperature = wp.array(temperature, dtype=float, device=device)
        table.enthalpy = wp.array(enthalpy, dtype=float, device=device)
        table.film = wp.array(self._films(model), dtype=float, device=device)
        lattice = self.lattice(model)
        table.support = lattice.support
        table.scale = normalisation(self.smoothing, model.dimension, lattice.support)
        table.scale /= lattice.slope(self.smoothing) if self.exact_on_lattice else 1.0
        melting = np.array([material.melting_enthalpies for material in model.materials])
        table.enthalpy_solid = wp.array(melting[:, 0], dtype=float, device=device)
        table.enthalpy_liquid = wp.array(melting[:, 1], dtype=float, device=device)
        for name in ("solidus", "liquidus", "conductivity_solid", "conductivity_liquid"):
            setattr(table, name, wp.array([getattr(m, name) for m in model.materials], dtype=float, device=device))
        return table


def _heat_capacities(material: Material) -> np.ndarray:
    """The slopes [J/(kg K)] of the enthalpy curve that differ, infinite where latent heat passes at one temperature."""
    with np.errstate(divide="ignore"):
        slopes = np.diff(material.enthalpies) / np.diff(material.temperatures)
    return np.unique(np.round(slopes / slopes[0], 9)) * slopes[0]


def _highest_conductivity(material: Material) -> float:
    return max(material.conductivity_solid, material.conductivity_liquid)


def _harmonic(a: float, b: float) -> float:
    return 2.0 * a * b / (a + b) if a + b > 0.0 else 0.0
