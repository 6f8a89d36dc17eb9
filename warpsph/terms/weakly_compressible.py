"""What all formulations of a weakly compressible flow have in common."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.term import Term
from warpsph.errors import number, require

SOUND_LIMIT = 5.0  # times the speed of sound, at which a run counts as diverged
DENSEST = 2.0  # times the reference density, at which it does; (1.3) then has the pressure of a jet of 5.5 times sound

SQUEEZED = (
    "a time step beyond its limit, particles that overlap, or a sound speed below ten times the highest speed, so that "
    "what should be all but incompressible is squeezed or torn apart"
)


@dataclass(frozen=True, eq=False)
class WeaklyCompressible(Term):
    """A fluid whose pressure follows from a small compression.

    Args:
        reference_density: rho_0 [kg/m^3].
        sound_speed: c [m/s], ten times the highest speed or more.
    """

    reference_density: float
    sound_speed: float

    def __post_init__(self) -> None:
        require(self, "reference_density", 0.0 < number(self.reference_density) < np.inf, "positive [kg/m^3]")
        require(self, "sound_speed", 0.0 < number(self.sound_speed) < np.inf, "positive [m/s]")

    def device_constants(self, model: Model) -> dict[str, object]:
        """Its constants for the device, by the name that its kernels use."""
        raise NotImplementedError

    def particle_mass(self, model: Model) -> float:
        """Mass [kg], per metre of depth in 2D, of a particle of fluid."""
        raise NotImplementedError

    def column_density(self, model: Model, depth: float) -> float:
        """Mean density [kg/m^3] at which a column of this depth [m] stands at rest."""
        raise NotImplementedError

    def speed_limit(self, model: Model) -> float:
        return SOUND_LIMIT * self.sound_speed

    def lightest(self, model: Model, moving: tuple[int, ...]) -> float:
        """The least density [kg/m^3] of what moves, or the reference where that is less."""
        return min([self.reference_density, *(model.materials[m].density for m in moving)])

    def keep_pressure(self, launch: Launch) -> None:
        """Let the bonds of what has just frozen go on bearing the pressure of the fluid."""
        raise NotImplementedError

    def keep_density(self, launch: Launch) -> None:
        """Find what bonds that have come or gone give to the density; nothing where solids have none of the fluid."""


def largest_shared_viscosity(model: Model, moving: tuple[int, ...]) -> float:
    """The largest harmonic mean [Pa s] of the viscosity of what moves and that of anything beside it, walls too."""
    own = np.array([model.materials[m].viscosity for m in moving])[:, None]
    other = np.array([material.viscosity for material in model.materials])
    return float(np.max(2.0 * own * other / np.maximum(own + other, np.finfo(float).tiny), initial=0.0))
