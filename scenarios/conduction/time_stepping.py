"""How cases of conduction go through time: the integrator and its step."""

from enum import StrEnum

from warpsph.cases.scenario import Scenario, parameter
from warpsph.terms import BackwardEuler, CrankNicolson, Explicit
from warpsph.terms.integrators import Integrator


class Stepping(StrEnum):
    """The integrators, by the names that a case gives."""

    EXPLICIT = "explicit"
    BACKWARD_EULER = "backward_euler"
    CRANK_NICOLSON = "crank_nicolson"


class ConductingScenario(Scenario):
    """A case whose heat may be conducted by any of the integrators."""

    integrator: Stepping = parameter(
        Stepping.EXPLICIT, "", "how steps of conduction are made: explicit, backward_euler, crank_nicolson"
    )
    step: float = parameter(
        1e6, "s", "longest step of conduction; explicit ones are shorter where stability asks for it", ge=1e-9, le=1e6
    )
    damped_steps: int = parameter(
        2, "", "first steps of crank_nicolson that are two halves of backward_euler each", ge=0, le=1000
    )
    tolerance: float = parameter(1e-5, "", "rest of an implicit step over the heat that it moves", ge=1e-12, le=1e-2)

    @property
    def stepping(self) -> Integrator:
        """The integrator."""
        if self.integrator is Stepping.BACKWARD_EULER:
            return BackwardEuler(tolerance=self.tolerance)
        if self.integrator is Stepping.CRANK_NICOLSON:
            return CrankNicolson(tolerance=self.tolerance, damped_steps=self.damped_steps)
        return Explicit()
