"""Buoyancy of what is warmer, or holds more solute, than its surroundings."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.dynamics import Dynamics
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, numbers, require
from warpsph.kernels.flow.buoyancy import lift, lift_at_walls
from warpsph.terms.corrected_fluid import CorrectedFluid


@dataclass(frozen=True, eq=False)
class Buoyancy(Term):
    """The force -g beta (T - T_0) on liquid, and -g beta_C (C - C_0) by solute (Boussinesq).

    Args:
        expansion: beta [1/K], the part of its volume by which the liquid grows for each kelvin; 0 where temperature
            does not lift it.
        reference: T_0 [K], at which there is no force.
        solutal_expansion: beta_C, the same for the mass fraction of solute; negative for a solute that is heavy.
        reference_solute: C_0.
        gravity: g (3,) [m/s^2], by default that of the model. Where the model has none the pressure counts from that
            of the liquid at rest.
    """

    expansion: float = 0.0
    reference: float = 0.0
    solutal_expansion: float = 0.0
    reference_solute: float = 0.0
    gravity: Sequence[float] | None = None

    needs = ("forces", "fluid")
    follows = ("temperature", "solute")

    acceleration = Dynamics.acceleration

    def __post_init__(self) -> None:
        for name in ("expansion", "solutal_expansion", "reference", "reference_solute"):
            require(self, name, bool(np.isfinite(number(getattr(self, name)))), "a number")
        known = self.gravity is None or bool(np.all(np.isfinite(numbers(self.gravity, 3))))
        require(self, "gravity", known, "three numbers [m/s^2]")
        if self.expansion == self.solutal_expansion == 0.0:
            raise InputError("Buoyancy: nothing is buoyant: give expansion [1/K], solutal_expansion, or both")

    def allocate(self, model: Model, state: State) -> None:
        for coefficient, carrier, remedy in (
            (self.expansion, "temperature", "expansion needs a temperature in the same case: add Conduction"),
            (self.solutal_expansion, "solute", "solutal_expansion needs a solute in the same case: add Solute"),
        ):
            if coefficient != 0.0 and not hasattr(state, carrier):
                raise InputError(f"Buoyancy: {remedy}")
        if not np.any(self._gravity(model)):
            raise InputError("Buoyancy: the model has no gravity; give Buoyancy its own, as in gravity=(0, -9.81, 0)")
        if model.dimension == 2 and self._gravity(model)[2] != 0.0:
            raise InputError("Buoyancy: gravity leans out of the plane, in two dimensions")

    def constants(self, model: Model, state: State) -> dict[str, object]:
        flow = model.find(CorrectedFluid)
        modulus = flow.reference_density * flow.sound_speed**2 if flow else 0.0
        return {
            "lifts": self._lifts(model),
            "support": model.support,
            "volume_of_cell": model.cell_volume,
            "bulk_modulus": modulus,
        }

    def find_walls(self, launch: Launch) -> None:
        if launch.find("bulk_modulus") > 0.0:
            for carrier, reference, downward in launch.find("lifts"):
                launch(lift_at_walls, carrier=launch.find(carrier), reference=reference, downward=downward)

    def sum_forces(self, launch: Launch) -> None:
        for carrier, reference, downward in launch.find("lifts"):
            launch(lift, carrier=launch.find(carrier), reference=reference, downward=downward)

    def _gravity(self, model: Model) -> np.ndarray:
        return np.asarray(model.gravity if self.gravity is None else self.gravity, float)

    def _lifts(self, model: Model) -> list[tuple[str, float, wp.vec3]]:
        """The fields that lift: name, reference, and gravity times the coefficient of expansion."""
        fields = (
            ("temperature", self.reference, self.expansion),
            ("solute", self.reference_solute, self.solutal_expansion),
        )
        return [(name, start, wp.vec3(*(self._gravity(model) * beta))) for name, start, beta in fields if beta != 0.0]
