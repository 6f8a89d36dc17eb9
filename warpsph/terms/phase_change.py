"""The switch between fluid and solid."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.field import Field
from warpsph.core.labels import Phase
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.heat.phase import switch_phase


@dataclass(frozen=True, eq=False)
class PhaseChange(Term):
    """Switch between fluid and solid by the solid fraction, with hysteresis (Vijaykumar 2012, chapter 4).

    Args:
        freeze_above: solid fraction above which a particle turns solid.
        melt_below: solid fraction below which a solid particle melts.
    """

    freeze_above: float = 0.55
    melt_below: float = 0.45

    def __post_init__(self) -> None:
        require(self, "freeze_above", 0.0 <= number(self.freeze_above) < 1.0, "from 0 to less than 1")
        in_order = 0.0 < number(self.melt_below) <= self.freeze_above
        require(self, "melt_below", in_order, "positive and not above freeze_above")

    provides = ("a change of phase",)
    needs = ("conduction",)
    follows = ("conduction",)

    froze = Field(int, "", "whether it turned solid just now")

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        return {"froze": fields["phase"] == Phase.SOLID}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"freeze_above": self.freeze_above, "melt_below": self.melt_below}

    def change_phases(self, launch: Launch) -> None:
        launch(switch_phase)
