"""What a run leaves."""

from dataclasses import dataclass, field

import numpy as np

from warpsph.core.quantity import Quantity
from warpsph.errors import InputError
from warpsph.nearest import did_you_mean


@dataclass
class Result:
    """The final state as NumPy arrays and the diagnostics as time series.

    ``positions`` (n, 3) [m] and ``fields`` (n, ...) hold every particle in the order of its id, those in the reservoir
    too; ``quantities`` says what the diagnostics are called and in which unit; ``status`` is "complete" or
    "interrupted"; ``materials`` are their names, by index; ``summary`` pairs a label with a text for people.
    """

    positions: np.ndarray
    fields: dict[str, np.ndarray]
    diagnostics: dict[str, np.ndarray]
    quantities: dict[str, Quantity]
    events: list[tuple[float, str]]
    time: float
    steps: int
    status: str
    wall_time: float
    materials: tuple[str, ...] = ()
    summary: dict[str, str] = field(default_factory=dict)

    def made_of(self, material: str) -> np.ndarray:
        """Which particles (n,) are made of a material.

        Raises:
            InputError: there is no such material.
        """
        if material not in self.materials:
            raise InputError(f"unknown material '{material}'{did_you_mean(material, self.materials)}")
        return self.fields["material"] == self.materials.index(material)
