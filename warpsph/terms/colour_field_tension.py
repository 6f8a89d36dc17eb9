"""Surface tension as published."""

from dataclasses import dataclass

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow.colour_field_tension import ColourFieldConstants, add_colour_field_tension
from warpsph.terms.tension import Tension


@dataclass(frozen=True, eq=False)
class ColourFieldTension(Tension):
    """The force of Vijaykumar (2012), section 2.3.2, which pulls on flat surfaces too.

    Parameters as of every :class:`~warpsph.terms.tension.Tension`.
    """

    provides = ("surface tension",)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"colour_field": self._constants(model)}

    def add_forces(self, launch: Launch) -> None:
        launch(add_colour_field_tension)

    def _constants(self, model: Model) -> ColourFieldConstants:
        constants = ColourFieldConstants()
        constants.support = model.support
        constants.scale = normalisation("poly6", model.dimension, model.support)
        constants.dimension = model.dimension
        constants.tension = self.coefficient
        constants.threshold = self.threshold / model.support
        return constants
