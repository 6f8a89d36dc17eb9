"""The switch between liquid and solid when all latent heat has passed."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.labels import Phase
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError
from warpsph.kernels.heat.whole_phases import switch_whole_phase
from warpsph.terms.conduction import Conduction
from warpsph.terms.phase_change import PhaseChange


@dataclass(frozen=True, eq=False)
class WholePhases(Term):
    """A particle keeps its phase, and the conductivity of it, until all its latent heat has passed.

    Monaghan, Huppert & Worster (2005), section 3: the heat lost at the melting temperature is stored, and when it has
    reached the latent heat the particle turns solid. Solid melts when all of it has come back. Without this term the
    conductivity follows the solid fraction.
    """

    provides = ("a change of phase", "conductivity")
    needs = ("conduction",)
    follows = ("conduction",)

    froze = PhaseChange.froze

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        return {"froze": fields["phase"] == Phase.SOLID}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        conduction = model.find(Conduction)
        if conduction is None:
            raise InputError("WholePhases reads the curves of Conduction; another conduction was given")
        if conduction.sharp_fronts:
            raise InputError(
                "WholePhases and Conduction(sharp_fronts=True) exclude each other: one conductivity, or two"
            )
        return {"table": conduction.constants(model, state)["table"]}

    def change_phases(self, launch: Launch) -> None:
        launch(switch_whole_phase)
