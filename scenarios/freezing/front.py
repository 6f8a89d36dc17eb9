"""What the exact solutions of freezing share: the numbers of the problem, and a front that goes as the root of time."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class FreezingFront:
    """A front at ``2 similarity sqrt(a_solid t)``, a = conductivity / (density heat_capacity).

    Temperatures in K, otherwise SI units.

    Args:
        similarity: lambda, which with the other numbers gives how strongly heat is taken.
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

    def front(self, time: float | np.ndarray) -> np.ndarray:
        """Distance [m] of the front from where heat is taken."""
        return 2.0 * self.similarity * np.sqrt(self.diffusivity_solid * np.asarray(time, float))  # Monaghan (3.5)
