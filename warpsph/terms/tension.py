"""What all forms of surface tension have in common."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.model import Model
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.terms.weakly_compressible import WeaklyCompressible


@dataclass(frozen=True, eq=False)
class Tension(Term):
    """A form of surface tension by the colour field.

    Args:
        coefficient: sigma [N/m].
        threshold: gradient of the colour field, in units of 1/H, above which there is a surface.
    """

    coefficient: float
    threshold: float = 0.15

    def __post_init__(self) -> None:
        require(self, "coefficient", 0.0 < number(self.coefficient) < np.inf, "positive [N/m]")
        require(self, "threshold", 0.0 <= number(self.threshold) < np.inf, "zero or positive")

    needs = ("fluid", "a density by continuity")

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        """That of the shortest capillary wave (Morris 2000), which is fastest in the lightest fluid."""
        inertia = model.the(WeaklyCompressible).lightest(model, moving) * (0.5 * model.support) ** 3
        return {"surface tension": 0.25 * float(np.sqrt(inertia / (2.0 * np.pi * self.coefficient)))}
