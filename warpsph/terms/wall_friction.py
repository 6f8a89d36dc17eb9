"""Friction of a fluid that slips along walls because its boundary layer is thinner than the particles."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.dynamics import Dynamics
from warpsph.core.labels import Role
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError
from warpsph.kernels.flow.corrected.friction import rub_at_walls
from warpsph.terms.corrected_fluid import CorrectedFluid


@dataclass(frozen=True, eq=False)
class WallFriction(Term):
    """Turbulent friction on smooth walls, by the law of the wall, where the fluid would slip without any.

    Water of a metre a second has a boundary layer of a centimetre after a metre, and most of its shear within a
    fraction of a millimetre. Walls without viscosity slip; this term gives them the stress that the speed of the
    particles before them has above a smooth wall, by the viscosity of the fluid. Walls with a viscosity hold the fluid
    by themselves.
    """

    provides = ("friction at walls",)
    needs = ("forces", "a flow")

    acceleration = Dynamics.acceleration

    def constants(self, model: Model, state: State) -> dict[str, object]:
        flow = model.find(CorrectedFluid)
        if flow is None:
            raise InputError("WallFriction: it acts in the flow of CorrectedFluid; drop it, or take that flow")
        walls = np.isin(state.numpy("role"), (Role.WALL, Role.DUMMY)) & (state.numpy("fluid_mass") > 0.0)
        if not np.any(walls & (state.numpy("viscosity") == 0.0)):
            raise InputError(
                "WallFriction: the fluid slips along no wall; give a wall's material no viscosity, or drop the term"
            )
        return flow.device_constants(model)

    def sum_forces(self, launch: Launch) -> None:
        launch(rub_at_walls)
