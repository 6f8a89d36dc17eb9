"""The exact solution of Neumann: melt that fills half of space freezes from a plane of given temperature."""

from dataclasses import dataclass

import numpy as np
from scipy.special import erf, erfcx

from warpsph.scenarios.freezing.front import FreezingFront


@dataclass(frozen=True)
class Neumann(FreezingFront):
    """From a plane of constant temperature.

    Carslaw & Jaeger (1959), chapter XI; with the same properties in both phases equations (3.2) to (3.6) of Monaghan,
    Huppert & Worster (2005).
    """

    @property
    def plane(self) -> float:
        """Temperature [K] of the plane: the balance of heat at the front, solved for it."""
        s, ratio = self.similarity, np.sqrt(self.diffusivity_solid / self.diffusivity_liquid)
        latent = s * self.latent_heat * np.sqrt(np.pi) / self.heat_capacity_solid
        in_melt = self.conductivity_liquid / self.conductivity_solid * ratio * (self.start - self.melting)
        in_melt /= erfcx(s * ratio)  # the exponential over erfc, each of which falls below the smallest number
        return float(self.melting - erf(s) * np.exp(s**2) * (latent + in_melt))  # Monaghan (3.6), phases set apart

    def temperature(self, y: np.ndarray, time: float) -> np.ndarray:
        """T (n,) [K] at the distances ``y`` (n,) [m] from the plane, at a ``time`` [s] after the start."""
        s, ratio = self.similarity, np.sqrt(self.diffusivity_solid / self.diffusivity_liquid)
        eta = y / np.sqrt(4.0 * self.diffusivity_solid * time)  # Monaghan (3.4)
        solid = self.plane + (self.melting - self.plane) / erf(s) * erf(eta)  # Monaghan (3.2)
        ahead = np.maximum(eta, s) * ratio
        share = np.exp((s * ratio) ** 2 - ahead**2) * erfcx(ahead) / erfcx(s * ratio)  # a ratio of erfc
        liquid = self.start + (self.melting - self.start) * share  # Monaghan (3.3)
        return np.where(eta < s, solid, liquid)

    def heat(self, time: float) -> float:
        """Heat [J/m^2] that the plane has taken: 2 k (dT/dy) sqrt(t / (pi a))."""
        slope = (self.melting - self.plane) / erf(self.similarity) / np.sqrt(np.pi * self.diffusivity_solid)
        return float(2.0 * self.conductivity_solid * slope * np.sqrt(time))
