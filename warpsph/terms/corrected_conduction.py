"""Heat conduction between the particles of a flow, which stand on no lattice."""

from dataclasses import dataclass
from typing import Any, ClassVar

import warp as wp

from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.kernels.heat.corrected_conduction import (
    HeatWeights,
    carry_heat,
    find_temperature_gradient,
    sum_corrected_heat,
)
from warpsph.kernels.heat.walls import find_walls_near
from warpsph.terms.conduction import Conduction
from warpsph.terms.corrected_fluid import ANISOTROPY, SMOOTHING_KERNEL, CorrectedFluid
from warpsph.terms.integrators import Explicit

LOST_BY_SHIFTS = 1.0e-4  # relative; a convecting box of 10 rows, the coarsest, was off by up to 2.4e-5
STEP = 0.15  # longest interval in rho c dx^2 / k; twice as much was stable in sheared, disordered layers


@dataclass(frozen=True, eq=False)
class CorrectedConduction(Conduction):
    """Conduction whose pairs are weighted by the moment matrices of both particles, as those of the viscosity of
    :class:`~warpsph.terms.CorrectedFluid` are by that of one.

    What one particle gains the other one loses. Particles that are shifted take on the heat of the place where they
    are: in this alone the sum of heat is not kept exactly.

    Args:
        films, longest_interval, walls, support_ratio: as for :class:`~warpsph.terms.Conduction`; the others are not
            to be changed.
    """

    smoothing: str = SMOOTHING_KERNEL

    smoothing_kernels: ClassVar[tuple[str, ...]] = (SMOOTHING_KERNEL,)
    heat_lost: ClassVar[float] = LOST_BY_SHIFTS

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.sharp_fronts or not self.exact_on_lattice or not isinstance(self.integrator, Explicit):
            raise InputError(
                "CorrectedConduction: it knows no sharp_fronts, no sums without normalisation and explicit steps only; "
                "take Conduction for what stands on a lattice"
            )

    heat_moment = Field(wp.mat33, "", "moment matrix of the neighbours that conduct", kept=False)
    temperature_gradient = Field(wp.vec3, "K/m", "gradient of the temperature")
    shift_velocity = CorrectedFluid.shift_velocity

    def constants(self, model: Model, state: State) -> dict[str, object]:
        weights: Any = HeatWeights()
        weights.anisotropy, weights.dimension = ANISOTROPY[model.dimension], model.dimension
        return super().constants(model, state) | {"heat_weights": weights}

    def stable_share(self, model: Model) -> tuple[float, str]:
        return STEP / self.lattice(model).support_ratio ** 2, "of a flow"

    def initialise(self, launch: Launch) -> None:
        self._find_gradient(launch)

    def set_out(self, launch: Launch) -> None:
        launch(carry_heat)

    def sum_heat(self, launch: Launch) -> None:
        self._find_gradient(launch)
        launch(sum_corrected_heat)

    def _find_gradient(self, launch: Launch) -> None:
        if self.walls:
            launch(find_walls_near, ago=launch.find("interval"))
        launch(find_temperature_gradient)
