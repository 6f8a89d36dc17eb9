"""The exact solution for melt that freezes around a line that takes heat at a constant rate."""

from dataclasses import dataclass

import numpy as np
from scipy.special import exp1

from warpsph.scenarios.freezing.front import FreezingFront


@dataclass(frozen=True)
class LineSink(FreezingFront):
    """Around a line that takes heat.

    Carslaw & Jaeger (1959), chapter XI; equations (3.7) to (3.10) of Monaghan, Huppert & Worster (2005), with their
    misprints put right.
    """

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

    def temperature(self, r: np.ndarray, time: float) -> np.ndarray:
        """T (n,) [K] at the distances ``r`` (n,) [m] from the line, at a ``time`` [s] after the start."""
        square, ratio = self.similarity**2, self.diffusivity_solid / self.diffusivity_liquid
        eta = r**2 / (4.0 * self.diffusivity_solid * time)
        solid = self.melting + self.strength / (4.0 * np.pi * self.conductivity_solid) * (exp1(square) - exp1(eta))
        warmth = (self.start - self.melting) / exp1(square * ratio)
        liquid = self.start - warmth * exp1(eta * ratio)
        return np.where(eta < square, solid, liquid)  # Monaghan (3.7), (3.9), without the misprints
