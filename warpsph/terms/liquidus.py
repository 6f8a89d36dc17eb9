"""The liquidus of a binary alloy, and where it ends."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsph.errors import InputError, number, require, shown


@dataclass(frozen=True, eq=False)
class Liquidus:
    """The temperature below which liquid freezes, over the mass fraction of the solute.

    Args:
        concentrations: nodes, from 0 up to the eutectic, rising strictly.
        temperatures: at the nodes [K], falling strictly; linear between.
    """

    concentrations: Sequence[float]
    temperatures: Sequence[float]

    def __post_init__(self) -> None:
        C, T = _numbers(self.concentrations), _numbers(self.temperatures)
        several = len(C) >= 2 and bool(np.all(np.isfinite(C)))
        rising = several and C[0] == 0.0 and C[-1] < 1.0 and bool(np.all(np.diff(C) > 0.0))
        require(self, "concentrations", rising, "two or more mass fractions that rise strictly, from 0 to less than 1")
        falling = len(T) == len(C) and bool(np.all(np.isfinite(T)) and np.all(np.diff(T) < 0.0) and T[-1] > 0.0)
        require(self, "temperatures", falling, "as many temperatures [K], that fall strictly")

    @classmethod
    def straight(cls, pure: float, slope: float, lowest: float) -> "Liquidus":
        """A straight one from the melting point of the ``pure`` solvent [K] down to the eutectic, ``lowest`` [K].

        ``slope`` is Gamma [K] of Monaghan et al. (2005), by how much it falls over a unit of concentration.
        """
        for name, value, holds, allowed in (
            ("pure", pure, 0.0 < number(pure) < np.inf, "a temperature [K]"),
            ("lowest", lowest, 0.0 < number(lowest) < number(pure), "a temperature [K] below that of the pure solvent"),
            ("slope", slope, number(pure) - number(lowest) < number(slope) < np.inf, "more than pure - lowest [K]"),
        ):
            if not holds:
                raise InputError(f"Liquidus.straight: {name} = {shown(value)}: must be {allowed}")
        return cls((0.0, (pure - lowest) / slope), (pure, lowest))

    @property
    def lowest(self) -> float:
        """Temperature [K] of its end, the eutectic."""
        return float(self.temperatures[-1])

    def temperature(self, concentration: float | np.ndarray) -> np.ndarray:
        """[K] at a concentration; constant beyond the end."""
        return np.asarray(np.interp(concentration, self.concentrations, self.temperatures))

    def concentration(self, temperature: float | np.ndarray) -> np.ndarray:
        """Of the liquid that is in equilibrium with ice at a temperature [K]; 0 above the first node."""
        return np.asarray(np.interp(temperature, self.temperatures[::-1], self.concentrations[::-1]))


def _numbers(values: Any) -> np.ndarray:
    """Values as numbers, NaN for those that are none; nothing where they are no sequence."""
    listed = isinstance(values, Iterable) and not isinstance(values, str)
    return np.array([number(value) for value in values] if listed else [])
