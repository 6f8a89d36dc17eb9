"""Density of a fluid by the equation of continuity."""

from dataclasses import dataclass

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.kernels.flow.continuity import advance_density
from warpsph.terms.fluid import fluid_constants


@dataclass(frozen=True, eq=False)
class ContinuityDensity(Term):
    """Density that follows the flow (Monaghan 1994, section 2), in place of a sum.

    A sum finds too little of it at a free surface: the outermost rows fall onto each other before they bear any
    pressure.
    """

    provides = ("density", "a density by continuity")
    needs = ("fluid",)

    density_carry = Field(float, "kg/m^3", "what the sum of the density has lost", renewed=True)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"fluid": fluid_constants(model)}

    def find_density(self, launch: Launch) -> None:
        launch(advance_density)
        launch.meet()  # it has read velocities of neighbours, which a boundary may set now
