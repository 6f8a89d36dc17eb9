"""The exact solution for melt that freezes around a line that takes heat at a constant rate."""

from dataclasses import dataclass

import numpy as np
from scipy.special import exp1


@dataclass(frozen=True)
class LineSink:
    """A front at ``2 similarity sqrt(a_solid t)`` around the line, a = conductivity / (density heat_capacity).

    Carslaw & Jaeger (1959), chapter XI; equations (3.7) to (3.10) of Monaghan, Huppert & Worster (2005), with their
    misprints put right. Temperatures in K, otherwise SI units.

    Args:
        similarity: lambda, which with the other numbers gives the strength of the sink.
        melting, start: melting point and temperature of the melt at the start.
    """

    similarity: float
    melting: float
    start: float
    density: float
    latent_heat: float
    heat_capacity_solid: float
    heat_capacity_liquid: float
    conductivity_solid: float
    conductivity_liquid: float

    @property
    def diffusivity_solid(self) -> float:
        """[m^2/s]."""
        return self.conductivity_solid / (self.density * self.heat_capacity_solid)

    @property
    def diffusivity_liquid(self) -> float:
        """[m^2/s]."""
        return self.conductivity_liquid / (self.density * self.heat_capacity_liquid)

    @property
    def strength(self) -> float:
        """Heat that the line takes [W/m]: the balance of heat at the front, solved for it."""
        square, ratio = self.similarity**2, self.diffusivity_solid / self.diffusivity_liquid
        latent = self.density * self.latent_heat * self.diffusivity_solid * square
        in_melt = self.conductivity_liquid * (self.start - self.melting) * np.exp(-square * ratio)
        return float(4.0 * np.pi * np.exp(square) * (latent + in_melt / exp1(square * ratio)))  # Monaghan (3.10)

    @property
    def relative_strength(self) -> float:
        """The paper's q', strength over 4 pi times latent heat, density and diffusivity of the solid."""
        return self.strength / (4.0 * np.pi * self.latent_heat * self.density * self.diffusivity_solid)

    def front(self, time: float | np.ndarray) -> np.ndarray:
        """Radius [m] of the front."""
        return 2.0 * self.similarity * np.sqrt(self.diffusivity_solid * np.asarray(time, float))

    def temperature(self, r: np.ndarray, time: float) -> np.ndarray:
        """T (n,) [K] at the distances ``r`` (n,) [m] from the line, at a ``time`` [s] after the start."""
        square, ratio = self.similarity**2, self.diffusivity_solid / self.diffusivity_liquid
        eta = r**2 / (4.0 * self.diffusivity_solid * time)
        solid = self.melting + self.strength / (4.0 * np.pi * self.conductivity_solid) * (exp1(square) - exp1(eta))
        warmth = (self.start - self.melting) / exp1(square * ratio)
        liquid = self.start - warmth * exp1(eta * ratio)
        return np.where(eta < square, solid, liquid)  # Monaghan (3.7), (3.9), without the misprints
