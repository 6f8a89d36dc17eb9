"""Density of a fluid by a sum over its neighbours."""

from dataclasses import dataclass

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.kernels.flow.density import sum_density
from warpsph.terms.fluid import fluid_constants


@dataclass(frozen=True, eq=False)
class SummedDensity(Term):
    """Density from where the masses are (Vijaykumar 2012, equation 2.1); too low beside a free surface."""

    provides = ("density",)
    needs = ("fluid",)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"fluid": fluid_constants(model)}

    def find_density(self, launch: Launch) -> None:
        launch(sum_density)
