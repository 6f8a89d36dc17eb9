"""Surface tension as published."""

from dataclasses import dataclass

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import require
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow.colour_field_tension import ColourFieldConstants, add_colour_field_tension
from warpsph.terms.surface_tension import capillary_step


@dataclass(frozen=True, eq=False)
class ColourFieldTension(Term):
    """The force of Vijaykumar (2012), section 2.3.2, which pulls on flat surfaces too.

    Args:
        coefficient: sigma [N/m].
        threshold: gradient of the colour field, in units of 1/H, above which there is a surface.
    """

    coefficient: float
    threshold: float = 0.15

    def __post_init__(self) -> None:
        require(self, "coefficient", 0.0 < self.coefficient < float("inf"), "positive [N/m]")
        require(self, "threshold", 0.0 <= self.threshold < float("inf"), "zero or positive")

    provides = ("surface tension",)
    needs = ("fluid", "a density by continuity")

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"colour_field": self._constants(model)}

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        return {"surface tension": capillary_step(model, self.coefficient)}

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
