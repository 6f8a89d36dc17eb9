"""A fluid that fills a closed box and therefore keeps its volume."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Value
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError
from warpsph.kernels.basics.roles import FLUID_ROLES
from warpsph.kernels.flow.corrected.enclosed import PARTS, find_excess, sum_compression, take_excess
from warpsph.terms.corrected_fluid import CorrectedFluid


@dataclass(frozen=True, eq=False)
class Enclosed(Term):
    """The mean compression of a fluid between walls or in a periodic box stays what it is at the start.

    Nothing passes through the walls, so the divergence of the velocity is zero on average (Gauss). Corrected sums are
    exact for linear velocities but do not have this mean: where the velocity jumps, as in the corner under a sliding
    lid, and where it is bent at walls, each step leaves a rest, of first order in the spacing, which would gather in
    the mean pressure. It is taken from all particles alike, a step later.
    """

    provides = ("an enclosed flow",)
    needs = ("a flow",)

    excess = Value(float, "", "mean compression above that of the start")
    compression_parts = Value(wp.float64, "", "partial sums of the compression", start=np.zeros(PARTS), scratch=True)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        flow = model.find(CorrectedFluid)
        if flow is None:
            raise InputError("Enclosed: it keeps the compression of CorrectedFluid; drop it, or take that flow")
        if flow.free_surface:
            raise InputError("Enclosed: the flow has a free surface and does not fill its box; drop one of the two")
        fluid = np.isin(state.numpy("role"), FLUID_ROLES)
        if not np.any(fluid):
            raise InputError("Enclosed: there is no fluid whose compression could be kept; add particles of it")
        return {
            "fluid_count": int(fluid.sum()),
            "mean_at_start": float(state.numpy("compression")[fluid].astype(float).mean()),
            "bulk_modulus": flow.reference_density * flow.sound_speed**2,
        }

    def arrive(self, launch: Launch) -> None:
        launch(take_excess)

    def find_walls(self, launch: Launch) -> None:
        launch(sum_compression, PARTS)

    def sum_forces(self, launch: Launch) -> None:
        launch.whole(find_excess)
