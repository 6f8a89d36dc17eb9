"""Heat conduction by enthalpy."""

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

SMOOTHING_KERNEL = "poly6"


@dataclass(frozen=True, eq=False)
class Conduction(Term):
    """Heat conduction by enthalpy (Vijaykumar 2012, chapter 3).

    Args:
        contact: conductivity [W/(m K)] of pairs of two materials, by their names, in place of the harmonic mean.
        longest_interval: largest time between two conduction steps [s], beside the stability limit.
    """

    contact: dict[tuple[str, str], float] = field(default_factory=dict)
    longest_interval: float = 1.0e-3

    def __post_init__(self) -> None:
        require(self, "longest_interval", number(self.longest_interval) > 0.0, "positive [s]")
        allowed = "conductivities [W/(m K)] by pair of names of materials, as in {('steel', 'copper'): 30.0}"
        require(self, "contact", isinstance(self.contact, dict), allowed)
        for pair, conductivity in self.contact.items():
            named = isinstance(pair, tuple) and len(pair) == 2 and all(isinstance(name, str) for name in pair)
            require(self, "contact", named and 0.0 <= number(conductivity) < np.inf, allowed)

    provides = ("conduction",)

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
        return {"enthalpy": enthalpy, "thermal_volume": volume}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        scale = normalisation(SMOOTHING_KERNEL, model.dimension, model.support) / model.lattice.slope(SMOOTHING_KERNEL)
        return {"table": self._table(model, state.device), "support": model.support, "scale": scale}

    def reach(self, model: Model) -> float:
        return model.support

    def longest_intervals(self, model: Model) -> dict[str, float]:
        """By pair of materials, and the longest interval asked for.

        Vijaykumar (2012), equation (7.7) with zeta = 0.1 and the support H, for the conductivity that the pair has.
        """
        limits = {"longest interval": self.longest_interval}
        contact = self._contact(model)
        for a, material in enumerate(model.materials):
            capacity = float(np.min(np.diff(material.enthalpies) / np.diff(material.temperatures)))
            for b, other in enumerate(model.materials):
                conductivity = contact[a, b]
                if conductivity < 0.0:
                    conductivity = _harmonic(_highest_conductivity(material), _highest_conductivity(other))
                if conductivity > 0.0:
                    limits[f"conduction {material.name}-{other.name} (7.7)"] = (
                        0.1 * material.density * capacity * model.support**2 / conductivity
                    )
        return limits

    def sum_heat(self, launch: Launch) -> None:
        launch(sum_heat)

    def add_heat(self, launch: Launch) -> None:
        launch(add_heat)

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

    def _contact(self, model: Model) -> np.ndarray:
        """Conductivity (materials, materials) [W/(m K)] of pairs, -1 for the harmonic mean."""
        contact = np.full((len(model.materials),) * 2, -1.0)
        for pair, conductivity in self.contact.items():
            a, b = (model.index_of(name) for name in pair)
            if contact[a, b] not in (-1.0, conductivity):
                raise InputError(f"Conduction: contact: {pair[0]} and {pair[1]} have two different conductivities")
            contact[a, b] = contact[b, a] = conductivity
        return contact

    def _table(self, model: Model, device: wp.Device) -> ThermalTable:
        """Enthalpy curves, melting ranges and conductivities of all materials, and of their contacts, on the device."""
        nodes = max(len(m.temperatures) for m in model.materials)
        temperature, enthalpy = (np.zeros((len(model.materials), nodes)) for _ in range(2))
        for index, material in enumerate(model.materials):
            highest = material.temperatures[-1] + np.arange(1, nodes - len(material.temperatures) + 1)
            temperature[index] = np.concatenate([material.temperatures, highest])
            enthalpy[index] = material.enthalpy(temperature[index])
        table: Any = ThermalTable()
        table.temperature = wp.array(temperature, dtype=float, device=device)
        table.enthalpy = wp.array(enthalpy, dtype=float, device=device)
        table.contact = wp.array(self._contact(model), dtype=float, device=device)
        for name in ("solidus", "liquidus", "conductivity_solid", "conductivity_liquid"):
            setattr(table, name, wp.array([getattr(m, name) for m in model.materials], dtype=float, device=device))
        return table


def contact_conductivity(model: Model, conductance: float) -> float:
    """Pair conductivity [W/(m K)] that gives a flat interface between two lattices this conductance [W/(m^2 K)]."""
    lattice = model.lattice
    return conductance * lattice.slope(SMOOTHING_KERNEL) / (2.0 * model.spacing * lattice.crossings(SMOOTHING_KERNEL))


def _highest_conductivity(material: Material) -> float:
    return max(material.conductivity_solid, material.conductivity_liquid)


def _harmonic(a: float, b: float) -> float:
    return 2.0 * a * b / (a + b) if a + b > 0.0 else 0.0
