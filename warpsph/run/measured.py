"""A diagnostic: a number measured in a run, with what it is called."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.quantity import Quantity, undeclared


@dataclass(frozen=True)
class Measured:
    """A value that an observer has found, declared where it is made.

    Args:
        value: a number, or an array of fixed length.
        unit: SI unit, "" where it has none.
        label: a few words.
        per_depth: whether it counts per metre of depth in the plane.
        panel: title under which a plot shows it together with others.
        over: name of the diagnostic over which an array is given, for example the heights of a profile.
        colours: name of the colour map of an array.
    """

    value: float | np.ndarray
    unit: str
    label: str
    per_depth: bool = False
    panel: str = ""
    over: str = ""
    colours: str = "viridis"

    def quantity(self, dimension: int) -> Quantity:
        """What a plot needs to know."""
        whole = f"({self.unit})" if "/" in self.unit or " " in self.unit else self.unit or "1"
        unit = f"{whole}/m" if self.per_depth and dimension == 2 else self.unit
        return Quantity(self.label, unit, self.colours, self.panel, self.over)


Values = dict[str, Measured | float | np.ndarray]


def value_of(given: Measured | float | np.ndarray) -> float | np.ndarray:
    """The bare value."""
    return given.value if isinstance(given, Measured) else given


def quantity_of(name: str, given: Measured | float | np.ndarray, dimension: int) -> Quantity:
    """What is known of a diagnostic; of one that is not declared, its name."""
    return given.quantity(dimension) if isinstance(given, Measured) else undeclared(name)
