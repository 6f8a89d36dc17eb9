"""Heat and freezing of a binary alloy: liquid and ice at the same places, the ice at first without mass."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.bound import Bound
from warpsph.core.content import Content
from warpsph.core.field import Field
from warpsph.core.labels import Role
from warpsph.core.launch import Launch
from warpsph.core.materials import Material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.periodic import axes_across
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, require
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.heat.alloy import SUM_ALLOY_HEAT, AlloyTable, add_alloy_heat, find_alloy_state, find_fractions
from warpsph.kernels.heat.freezing import freeze, gather_ice
from warpsph.kernels.heat.walls import count_heat
from warpsph.terms.alloy_equations import AlloyEquations
from warpsph.terms.alloy_limits import refuse_full_walls, refuse_start, report_beyond
from warpsph.terms.conduction import NO_NUMBER, Conduction
from warpsph.terms.heat_wall import HeatWall
from warpsph.terms.implicit_heat import ImplicitHeat
from warpsph.terms.integrators import EXPLICIT, INTEGRATORS, NO_LIMIT, Implicit, Integrator
from warpsph.terms.liquidus import Liquidus
from warpsph.terms.solute import LOST, SMOOTHING_KERNEL, Solute, planes, refuse_behind

SAFETY = 0.8  # of the step in which no temperature would pass the mean of those around it


@dataclass(frozen=True, eq=False)
class Alloy(Term):
    """A solution of which pure ice freezes (Monaghan, Huppert & Worster 2005, sections 4 and 5).

    The material of the model is the liquid. Each particle has besides its liquid some ice, at first none, of a
    temperature of its own. Liquid that is cooled below the liquidus forms ice, which goes to the ice of the
    neighbourhood, and keeps the solute. It takes the place of Conduction.

    Left out: ice that melts again, the solid that forms at the eutectic, motion of ice against liquid, and that ice
    takes more room than the liquid it has come from.

    Args:
        ice: its density, heat capacity and conductivity.
        latent_heat: of freezing [J/kg], at whatever temperature the ice forms.
        liquidus: of the solution.
        walls: planes of given temperature, or insulated, that bound the body.
        literal: conduct as printed in equation (4.2), which counts conduction within the mush twice.
        longest_interval: largest time between two steps with heat [s], beside the stability limit; an implicit
            integrator has no such limit and must be given one.
        integrator: ``Explicit()``, ``BackwardEuler()`` or ``CrankNicolson()``.

    One with walls belongs to one simulation.
    """

    ice: Material
    latent_heat: float
    liquidus: Liquidus
    walls: Sequence[HeatWall] = ()
    literal: bool = False
    longest_interval: float = np.inf
    integrator: Integrator = EXPLICIT

    def __post_init__(self) -> None:
        require(self, "ice", isinstance(self.ice, Material), "a Material")
        require(self, "latent_heat", 0.0 < number(self.latent_heat) < np.inf, "positive [J/kg]")
        require(self, "liquidus", isinstance(self.liquidus, Liquidus), "a Liquidus")
        require(self, "longest_interval", number(self.longest_interval) > 0.0, "positive [s]")
        require(self, "integrator", isinstance(self.integrator, Integrator), INTEGRATORS)
        if isinstance(self.integrator, Implicit) and not np.isfinite(self.longest_interval):
            raise InputError(f"Alloy: longest_interval: {NO_LIMIT}")
        several = isinstance(self.walls, Sequence) and all(isinstance(wall, HeatWall) for wall in self.walls)
        require(self, "walls", several, "a tuple of HeatWall")
        plain = all(wall.conductance in (0.0, np.inf) and wall.flux == 0.0 and not wall.profiles for wall in self.walls)
        require(self, "walls", plain, "of one temperature or insulated; films, fluxes and profiles are left out here")
        for wall in self.walls:
            if wall.conductance == np.inf and wall.outside < self.liquidus.lowest:
                raise InputError(
                    f"Alloy: a wall of {wall.outside:g} K is colder than the end of the liquidus, "
                    f"{self.liquidus.lowest:g} K: the solid that forms at the eutectic is left out; make it warmer"
                )

    provides = ("temperature", "freezing of an alloy")
    needs = ("solute",)

    temperature = Conduction.temperature
    solid_fraction = Conduction.solid_fraction
    thermal_volume = Conduction.thermal_volume
    solute = Solute.solute
    solute_mass = Solute.solute_mass
    liquid_mass = Solute.liquid_mass
    liquid_fraction = Solute.liquid_fraction
    ice_temperature = Field(
        float, "K", "temperature of the ice", start=293.15, least=0.0, written=True, colours="inferno"
    )
    ice_mass = Field(wp.float64, "kg", "mass of ice (per metre of depth in 2D)", least=0.0)
    liquid_heat = Field(wp.float64, "J", "heat of the liquid (per metre of depth in 2D)")
    ice_heat = Field(wp.float64, "J", "heat of the ice (per metre of depth in 2D)")
    heat_freed = Field(wp.float64, "J", "heat that freezing has set free (per metre of depth in 2D)")
    bulk_solute = Field(float, "", "mass fraction of solute in liquid and ice together")
    liquid_density = Field(float, "kg/m^3", "mass of liquid in a volume of both")
    ice_density = Field(float, "kg/m^3", "mass of ice in a volume of both")
    liquid_volume = Field(float, "m^3", "volume of liquid (per metre of depth in 2D)")
    ice_volume = Field(float, "m^3", "volume of ice (per metre of depth in 2D)")
    liquid_rate = Field(float, "W", "heat that the liquid gains in unit time (per metre of depth in 2D)", kept=False)
    ice_rate = Field(float, "W", "heat that the ice gains in unit time (per metre of depth in 2D)", kept=False)
    new_ice = Field(wp.float64, "kg m^2", "ice that has just frozen, over the sum of W", kept=False)
    new_heat = Field(wp.float64, "J m^2", "its heat, over the sum of W", kept=False)

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        if len(model.materials) != 1:
            raise InputError(f"Alloy: {len(model.materials)} materials; it needs a model of one, the liquid")
        refuse_behind(self.walls, model, particles.position)
        volume = np.where(particles.volume > 0.0, particles.volume, model.cell_volume)
        ice_temperature = np.where(
            particles.was_given("ice_temperature"), fields["ice_temperature"], fields["temperature"]
        )
        there = particles.role != Role.RESERVOIR
        real = {name: values[there] for name, values in fields.items()}
        refuse_start(self.liquidus, self.ice.density, particles.position[there], volume[there], real)
        ratio = model.materials[0].density / self.ice.density
        refuse_full_walls(self.walls, self.liquidus, ratio, model.support, particles.position[there], real)
        capacity_liquid, capacity_ice = _capacity(model.materials[0]), _capacity(self.ice)
        reference = self.liquidus.temperatures[0]
        return {
            "thermal_volume": volume,
            "ice_temperature": ice_temperature,
            "liquid_heat": fields["liquid_mass"] * capacity_liquid * (fields["temperature"] - reference),
            "ice_heat": fields["ice_mass"] * capacity_ice * (ice_temperature - reference),
        }

    def allocate(self, model: Model, state: State) -> None:
        if self.arrays:
            raise InputError("this Alloy belongs to another simulation already; make a new one")
        each = (len(self.walls), state.count)
        taken, rate = (
            wp.zeros(each, dtype=wp.float64, device=state.device),
            wp.zeros(each, dtype=float, device=state.device),
        )
        self.arrays["wall_heat"] = state.hold("alloy.wall_heat", taken)
        self.arrays["wall_rate"] = state.hold("alloy.wall_rate", rate, scratch=True)
        if isinstance(self.integrator, Implicit):
            self.__dict__["_implicit"] = ImplicitHeat(self.integrator, AlloyEquations(len(self.walls)), state)

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return axes_across(*(wall.normal for wall in self.walls))

    def constants(self, model: Model, state: State) -> dict[str, object]:
        mirrors: Any = planes(self.walls, model, state.device)
        mirrors.taken, mirrors.rate = self.arrays["wall_heat"], self.arrays["wall_rate"]
        return {"alloy": self._table(model, state.device), "walls": mirrors}

    def reach(self, model: Model) -> float:
        return model.support

    def longest_intervals(self, model: Model) -> dict[str, float]:
        """Of the ice, which conducts best and weighs least: an empty one follows liquid and ice around it.

        No temperature may pass the mean of those that it is drawn to. As printed, an empty one is drawn three times.
        """
        around, here = model.lattice.coupling(SMOOTHING_KERNEL)
        k_l, k_i = model.materials[0].conductivity_liquid, self.ice.conductivity_solid
        if self.literal:
            pull = k_i * (around + 2.0 * (around + here))
        else:
            pull = max(k_i * around, 0.5 * (k_l + k_i) * (around + here))
        if isinstance(self.integrator, Implicit):
            return {"longest interval": self.longest_interval}
        limit = SAFETY * self.ice.density * _capacity(self.ice) / pull
        return {"longest interval": self.longest_interval, "conduction in ice (2.20)": limit}

    def sum_heat(self, launch: Launch) -> None:
        if self.implicit is None:
            launch(SUM_ALLOY_HEAT[float])

    def add_heat(self, launch: Launch) -> None:
        if self.implicit is not None:
            launch.on_host(partial(self.implicit.advance, launch, launch.find("interval")))
            return
        launch(add_alloy_heat)
        if self.walls:
            launch(count_heat)

    def after_heat(self, launch: Launch) -> None:
        launch(freeze)
        launch(gather_ice)

    def find_temperature(self, launch: Launch) -> None:
        launch(find_fractions)
        launch(find_alloy_state)

    def summary(self) -> dict[str, str]:
        return {} if self.implicit is None else self.implicit.summary()

    def bounds(self, model: Model, state: State) -> dict[str, Bound]:
        return {name: Bound(cause=NO_NUMBER) for name in ("temperature", "ice_temperature", "solid_fraction")}

    def check(self, state: State) -> None:
        report_beyond(state, self.liquidus)

    @property
    def implicit(self) -> ImplicitHeat | None:
        """What solves the steps of an implicit integrator, once it belongs to a simulation."""
        return self.__dict__.get("_implicit")

    def contents(self, model: Model, state: State) -> dict[str, Content]:
        heat = state.numpy("liquid_heat") + state.numpy("ice_heat") - state.numpy("heat_freed")
        mass = state.numpy("liquid_mass") + state.numpy("ice_mass")
        solute = state.numpy("solute_mass")
        return {
            "heat": Content(float(np.sum(heat)), float(np.sum(np.abs(heat))), "J", LOST),
            "mass of liquid and ice": Content(float(np.sum(mass)), float(np.sum(mass)), "kg", LOST),
            "solute": Content(float(np.sum(solute)), float(np.sum(solute)), "kg", LOST),
        }

    def gains(self, state: State) -> dict[str, dict[str, float | np.ndarray]]:
        return {"heat": {"walls": -float(np.sum(self.heat_to_walls()))}}

    def heat_to_walls(self) -> np.ndarray:
        """Heat (walls,) [J] that each wall has taken so far (per metre of depth in 2D)."""
        return self.arrays["wall_heat"].numpy().sum(axis=1)

    def _table(self, model: Model, device: wp.Device) -> AlloyTable:
        liquid, lattice = model.materials[0], model.lattice
        W = normalisation(SMOOTHING_KERNEL, model.dimension, model.support)
        walls = [wall.outside if wall.conductance == np.inf else np.inf for wall in self.walls]
        table: Any = AlloyTable()
        table.concentration = wp.array(list(self.liquidus.concentrations), dtype=wp.float64, device=device)
        table.melting = wp.array(list(self.liquidus.temperatures), dtype=wp.float64, device=device)
        table.reference = self.liquidus.temperatures[0]
        table.latent_heat = self.latent_heat
        table.capacity_liquid, table.capacity_ice = _capacity(liquid), _capacity(self.ice)
        table.conductivity_liquid, table.conductivity_ice = liquid.conductivity_liquid, self.ice.conductivity_solid
        table.density_liquid, table.density_ice = liquid.density, self.ice.density
        table.literal = int(self.literal)
        table.wall_concentration = wp.array(self.liquidus.concentration(np.array(walls)), dtype=float, device=device)
        table.support = model.support
        table.slope_scale = W / lattice.slope(SMOOTHING_KERNEL)
        table.value_scale = W / lattice.density(SMOOTHING_KERNEL)
        return table


def _capacity(material: Material) -> float:
    """Heat capacity [J/(kg K)], the same at all temperatures.

    Raises:
        InputError: it is not.
    """
    capacities = np.diff(material.enthalpies) / np.diff(material.temperatures)
    if np.ptp(capacities) > 1e-9 * capacities[0]:
        raise InputError(
            f"Alloy: the heat capacity of {material.name} changes with its temperature; give a constant one"
        )
    return float(capacities[0])
