"""What the cases of freezing have in common: how heat is conducted, and how latent heat passes."""

from enum import StrEnum
from typing import Any

from pydantic import model_validator

from warpsph.cases.scenario import parameter
from warpsph.core.materials import Material, melting_material
from warpsph.core.term import Term
from warpsph.scenarios.conduction.time_stepping import ConductingScenario, Stepping
from warpsph.terms import Conduction, PhaseChange, WholePhases

SOURCE = "Monaghan, Huppert & Worster (2005)"
LONGEST_EXPLICIT = 0.15  # Monaghan (2.20)


class Phases(StrEnum):
    """How a particle conducts while it freezes."""

    STORED = "stored"  # like liquid, until all its latent heat is gone: as published
    CURVE = "curve"  # between liquid and solid, by its solid fraction
    FRONT = "front"  # like the solid towards colder particles, like the liquid towards warmer ones


class Freezing(ConductingScenario):
    """A pure substance at rest that freezes, by the cubic spline."""

    smoothing_length: float = parameter(
        1.2, "", "smoothing length h of the cubic spline over the spacing", ge=1, le=1.5
    )
    exact_on_lattice: bool = parameter(True, "", "whether conduction is divided by what the lattice makes of it")
    phases: Phases = parameter(Phases.FRONT, "", "how particles conduct that freeze: front, curve, or stored")
    step: float = parameter(
        LONGEST_EXPLICIT,
        "",
        "time step over density heat_capacity h^2 / conductivity; 0.15 if explicit",
        ge=1e-6,
        le=150,
    )

    @model_validator(mode="after")
    def _check_step(self) -> "Freezing":
        if self.integrator is Stepping.EXPLICIT and self.step > LONGEST_EXPLICIT:
            raise ValueError(
                f"step = {self.step}: {LONGEST_EXPLICIT} at most with integrator = explicit; take another one, or less"
            )
        return self

    @property
    def method(self) -> str:
        """How it conducts, for the names of checks."""
        steps = "" if self.integrator is Stepping.EXPLICIT else f", {self.integrator.value}, step {self.step:g}"
        return self.phases.value + ("" if self.exact_on_lattice else ", sum as published") + steps

    def longest_step(self, spacing: float, diffusivity: float) -> float:
        """Time step [s] for the highest diffusivity [m^2/s]."""
        return self.step * (self.smoothing_length * spacing) ** 2 / diffusivity  # Monaghan (2.20)

    def physics(self, longest: float, **further: Any) -> tuple[Conduction, Term]:
        """Conduction, with ``further`` arguments, and the change of phase; ``longest`` is the time step [s]."""
        conduction = Conduction(
            longest_interval=longest,
            integrator=self.stepping,
            smoothing="cubic_spline",
            support_ratio=2.0 * self.smoothing_length,
            exact_on_lattice=self.exact_on_lattice,
            sharp_fronts=self.phases is Phases.FRONT,
            **further,
        )
        return conduction, WholePhases() if self.phases is Phases.STORED else PhaseChange()


def pure_substance(name: str, melting: float, source: str, **properties: float) -> Material:
    """A material with one melting point [K] and the ``properties`` of an exact solution."""
    return melting_material(
        name,
        density=properties["density"],
        heat_capacity=properties["heat_capacity_solid"],
        heat_capacity_liquid=properties["heat_capacity_liquid"],
        latent_heat=properties["latent_heat"],
        solidus=melting,
        liquidus=melting,
        conductivity_solid=properties["conductivity_solid"],
        conductivity_liquid=properties["conductivity_liquid"],
        viscosity=0.0,
        source=source,
    )
