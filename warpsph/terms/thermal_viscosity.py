"""Viscosities that depend on the temperature."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.launch import Launch
from warpsph.core.materials import Material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, numbers, require
from warpsph.kernels.flow.thermal_viscosity import find_viscosity
from warpsph.terms.fluid import Fluid

ROUNDING = 1.0e-9  # relative
Curve = Sequence[tuple[float, float]]


@dataclass(frozen=True, eq=False)
class ThermalViscosity(Term):
    """Viscosity of some materials by their temperature, in any flow of a case that conducts heat.

    It is found where the temperature is, at every step with heat; a pair has the harmonic mean of its two. The
    viscosity of the material itself must be the highest of its curve: the time step goes by it.

    Args:
        curves: by the name of the material, its nodes (T [K], mu [Pa s]) of rising temperature; linear between,
            constant beyond.
    """

    curves: Mapping[str, Curve]

    needs = ("a flow", "temperature")

    viscosity = Fluid.viscosity

    def __post_init__(self) -> None:
        allowed = "nodes (T [K], mu [Pa s]) by name of a material, as in {'melt': ((1700.0, 0.01), (1900.0, 0.005))}"
        require(self, "curves", isinstance(self.curves, Mapping) and len(self.curves) > 0, allowed)
        for name, curve in self.curves.items():
            several = isinstance(curve, Sequence | np.ndarray) and not isinstance(curve, str) and len(curve) > 0
            require(self, "curves", isinstance(name, str) and several, allowed)
            nodes = np.array([numbers(node, 2) for node in curve])
            require(self, "curves", bool(np.all(np.isfinite(nodes)) and np.all(nodes >= 0.0)), allowed)
            rises = bool(np.all(np.diff(nodes[:, 0].astype(np.float32)) > 0.0))
            require(self, "curves", rises, f"{allowed}, the temperatures rising strictly, in single precision too")

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        viscosity = fields["viscosity"].copy()
        for name, curve in self.curves.items():
            index = model.index_of(name)
            _refuse_another_highest(model.materials[index], curve)
            mine = fields["material"] == index
            viscosity[mine] = np.interp(fields["temperature"][mine], *np.transpose(curve))
        return {"viscosity": viscosity}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        curves = [np.array(self.curves.get(material.name, np.zeros((0, 2))), float) for material in model.materials]
        counts = [len(curve) for curve in curves]
        nodes = np.zeros((2, len(curves), max(counts)))
        for index, curve in enumerate(curves):
            nodes[:, index, : len(curve)] = curve.T
        return {
            "curve_nodes": wp.array(counts, dtype=int, device=state.device),
            "curve_temperature": wp.array(nodes[0], dtype=float, device=state.device),
            "curve_viscosity": wp.array(nodes[1], dtype=float, device=state.device),
        }

    def find_temperature(self, launch: Launch) -> None:
        launch(find_viscosity)


def _refuse_another_highest(material: Material, curve: Curve) -> None:
    highest = max(number(viscosity) for _, viscosity in curve)
    if abs(material.viscosity - highest) > ROUNDING * highest:
        raise InputError(
            f"ThermalViscosity: {material.name} has a viscosity of {material.viscosity:g} Pa s and a curve up to "
            f"{highest:g} Pa s: give the material {highest:g}, by which the time step goes"
        )
