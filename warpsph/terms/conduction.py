"""Heat conduction by enthalpy."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.materials import Material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import DivergenceError, InputError, number, require
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.heat.conduction import ThermalTable, add_heat, sum_heat, update_temperature
from warpsph.kernels.heat.walls import HeatWalls, add_heat_of_images, count_heat, find_walls_near
from warpsph.terms.heat_wall import SLACK, HeatWall, refuse_misfits

SMOOTHING_KERNEL = "poly6"
MOST_WALLS = 30  # a bit each


@dataclass(frozen=True, eq=False)
class Conduction(Term):
    """Heat conduction by enthalpy (Vijaykumar 2012, chapter 3).

    Args:
        films: conductance [W/(m^2 K)] of a film between two materials, by their names; 0 lets no heat pass.
        longest_interval: largest time between two conduction steps [s], beside the stability limit.
        walls: planes on which temperature, film, flux or insulation is given.

    One with walls belongs to one simulation; ``wall_conductance``, ``wall_outside`` and ``wall_flux`` (walls,) are then
    device arrays that may be changed during a run.
    """

    films: dict[tuple[str, str], float] = field(default_factory=dict)
    longest_interval: float = 1.0e-3
    walls: Sequence[HeatWall] = ()

    def __post_init__(self) -> None:
        require(self, "longest_interval", number(self.longest_interval) > 0.0, "positive [s]")
        allowed = "conductances [W/(m^2 K)] by pair of names of materials, as in {('steel', 'copper'): 1500.0}"
        require(self, "films", isinstance(self.films, dict), allowed)
        for pair, conductance in self.films.items():
            named = isinstance(pair, tuple) and len(pair) == 2 and all(isinstance(name, str) for name in pair)
            require(self, "films", named and 0.0 <= number(conductance) < np.inf, allowed)
        several = isinstance(self.walls, Sequence) and all(isinstance(wall, HeatWall) for wall in self.walls)
        require(self, "walls", several, "a tuple of HeatWall")
        require(self, "walls", len(self.walls) <= MOST_WALLS, f"{MOST_WALLS} at most")

    provides = ("conduction", "temperature")

    temperature = Field(float, "K", "temperature", start=293.15, written=True, colours="inferno")
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
            enthalpy[mine] = substance.enthalpy(fields["temperature"][mine])
        volume = np.where(particles.volume > 0.0, particles.volume, model.cell_volume)
        refuse_misfits(self.walls, model, particles.position)
        return {"enthalpy": enthalpy, "thermal_volume": volume}

    def allocate(self, model: Model, state: State) -> None:
        def hold(name: str, array: wp.array, scratch: bool = False) -> None:
            self.arrays[name] = state.hold(f"conduction.{name}", array, scratch)

        if not self.walls:
            return
        if self.arrays:
            raise InputError("this Conduction belongs to another simulation already; make a new one")
        for name in ("conductance", "outside", "flux"):
            given = [getattr(wall, name) for wall in self.walls]
            hold(f"wall_{name}", wp.array(given, dtype=float, device=state.device))
        each = (len(self.walls), state.count)
        hold("wall_heat", wp.zeros(each, dtype=wp.float64, device=state.device))
        hold("wall_rate", wp.zeros(each, dtype=float, device=state.device), scratch=True)
        for name in ("near_walls", "behind_walls"):
            hold(name, wp.zeros(state.count, dtype=int, device=state.device), scratch=True)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"table": self._table(model, state.device), "walls": self._planes(model, state.device)}

    def reach(self, model: Model) -> float:
        return model.support

    def longest_intervals(self, model: Model) -> dict[str, float]:
        """By pair of materials, and the longest interval asked for.

        Vijaykumar (2012), equation (7.7) with zeta = 0.1 and the support H, for the conductivity that the pair has.
        """
        limits = {"longest interval": self.longest_interval}
        films = self._films(model)
        for a, material in enumerate(model.materials):
            capacity = float(np.min(np.diff(material.enthalpies) / np.diff(material.temperatures)))
            for b, other in enumerate(model.materials):
                conductivity = _harmonic(_highest_conductivity(material), _highest_conductivity(other))
                if np.isfinite(films[a, b]):
                    conductivity = 0.5 * _harmonic(conductivity, films[a, b] * model.support)
                if conductivity > 0.0:
                    limits[f"conduction {material.name}-{other.name} (7.7)"] = (
                        0.1 * material.density * capacity * model.support**2 / conductivity
                    )
        return limits

    def sum_heat(self, launch: Launch) -> None:
        launch(sum_heat)
        if self.walls:
            launch(find_walls_near)
            launch(add_heat_of_images)

    def add_heat(self, launch: Launch) -> None:
        launch(add_heat)
        if self.walls:
            launch(count_heat)

    def find_temperature(self, launch: Launch) -> None:
        launch(update_temperature)

    def check(self, state: State) -> None:
        bad = np.flatnonzero(~np.isfinite(state.numpy("enthalpy")))
        if len(bad):
            place = ", ".join(f"{x:.4g}" for x in state.numpy("position")[bad[0]])
            raise DivergenceError(
                f"the enthalpy of particle {state.numpy('id')[bad[0]]} at ({place}) m is not a number before "
                f"t = {float(state.time.numpy()[0]):.6g} s"
            )

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

    def heat_to_walls(self) -> np.ndarray:
        """Heat (walls,) [J] that each wall has taken so far (per metre of depth in 2D).

        What the ``held`` particles of a row on the wall have taken stands in ``heat_held``.
        """
        return self.arrays["wall_heat"].numpy().sum(axis=1)

    def rate_to_walls(self) -> np.ndarray:
        """Heat (walls,) [W] that each wall took in unit time in the last step with heat (per metre of depth in 2D)."""
        return self.arrays["wall_rate"].numpy().sum(axis=1, dtype=float)

    def _films(self, model: Model) -> np.ndarray:
        """Conductivity over distance (materials, materials) [W/(m^2 K)] in series with a pair, infinite without a film.

        Two lattices of one temperature each, with a film that hinders more than they do, then exchange the exact heat
        through a flat interface: pairs at an angle to it are longer than their way across.
        """
        lattice, films = model.lattice, np.full((len(model.materials),) * 2, np.inf)
        straight = 0.5 * lattice.slope(SMOOTHING_KERNEL) / lattice.detour(SMOOTHING_KERNEL)
        for pair, conductance in self.films.items():
            a, b = (model.index_of(name) for name in pair)
            if films[a, b] not in (np.inf, conductance * straight):
                raise InputError(f"Conduction: films: {pair[0]} and {pair[1]} have two different conductances")
            films[a, b] = films[b, a] = conductance * straight
        return films

    def _planes(self, model: Model, device: wp.Device) -> HeatWalls:
        """The walls on the device."""
        planes: Any = HeatWalls()
        if self.walls:
            planes.normal = wp.array([wall.normal for wall in self.walls], dtype=wp.vec3d, device=device)
            planes.offset = wp.array([wall.offset for wall in self.walls], dtype=wp.float64, device=device)
            planes.conductance, planes.outside, planes.flux = self.wall_conductance, self.wall_outside, self.wall_flux
            planes.slack = SLACK * model.spacing
            planes.rate, planes.taken = self.arrays["wall_rate"], self.arrays["wall_heat"]
            planes.near, planes.behind = self.arrays["near_walls"], self.arrays["behind_walls"]
        return planes

    def _table(self, model: Model, device: wp.Device) -> ThermalTable:
        """Enthalpy curves, melting ranges, conductivities and films of all materials, on the device."""
        nodes = max(len(m.temperatures) for m in model.materials)
        temperature, enthalpy = (np.zeros((len(model.materials), nodes)) for _ in range(2))
        for index, material in enumerate(model.materials):
            highest = material.temperatures[-1] + np.arange(1, nodes - len(material.temperatures) + 1)
            temperature[index] = np.concatenate([material.temperatures, highest])
            enthalpy[index] = material.enthalpy(temperature[index])
        table: Any = ThermalTable()
        table.temperature = wp.array(temperature, dtype=float, device=device)
        table.enthalpy = wp.array(enthalpy, dtype=float, device=device)
        table.film = wp.array(self._films(model), dtype=float, device=device)
        table.support = model.support
        table.scale = normalisation(SMOOTHING_KERNEL, model.dimension, model.support)
        table.scale /= model.lattice.slope(SMOOTHING_KERNEL)
        for name in ("solidus", "liquidus", "conductivity_solid", "conductivity_liquid"):
            setattr(table, name, wp.array([getattr(m, name) for m in model.materials], dtype=float, device=device))
        return table


def _highest_conductivity(material: Material) -> float:
    return max(material.conductivity_solid, material.conductivity_liquid)


def _harmonic(a: float, b: float) -> float:
    return 2.0 * a * b / (a + b) if a + b > 0.0 else 0.0
