"""Attraction and repulsion between particles."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, require
from warpsph.kernels.particles.pair_forces import PairConstants, add_pair_forces

ROUNDING = 1.0e-4  # relative; what single precision may lose of a distance, or a mass
BEYOND_ESCAPE = 100.0  # times the speed that frees a bound pair: nothing but a step that is too long gives it


@dataclass(frozen=True, eq=False)
class PairPotential(Term):
    """Particles attract each other by ``G m m / r^beta`` and repel by ``H m m / r^alpha`` (Greenspan 1976, (2.5)).

    Args:
        attraction: G [N m^beta / kg^2].
        repulsion: H [N m^alpha / kg^2].
        attraction_exponent: beta, a whole number of at least 2.
        repulsion_exponent: alpha, a whole number above beta.
        cutoff: distance [m] beyond which there is no force.
        mass: of the heaviest particle [kg], for the longest step and the speed limit; heavier ones are refused.
    """

    attraction: float
    repulsion: float
    attraction_exponent: int
    repulsion_exponent: int
    cutoff: float
    mass: float = 1.0

    def __post_init__(self) -> None:
        for name in ("attraction", "repulsion", "mass"):
            require(self, name, 0.0 < number(getattr(self, name)) < np.inf, "positive")
        beta, alpha = self.attraction_exponent, self.repulsion_exponent
        require(self, "attraction_exponent", isinstance(beta, int) and beta >= 2, "a whole number of at least 2")
        require(self, "repulsion_exponent", isinstance(alpha, int) and alpha > beta, "a whole number above beta")
        require(self, "cutoff", self.rest_length < number(self.cutoff) < np.inf, f"above {self.rest_length:.4g} m")

    keeps_momentum = True
    provides = ("pair potential",)
    needs = ("precise motion",)

    @property
    def rest_length(self) -> float:
        """Distance [m] at which a pair feels no force."""
        exponent = 1.0 / (self.repulsion_exponent - self.attraction_exponent)
        return float((self.repulsion / self.attraction) ** exponent)

    @property
    def stiffness(self) -> float:
        """Slope [N/m] of the force of a pair of 1 kg each at its rest length."""
        r, alpha, beta = self.rest_length, self.repulsion_exponent, self.attraction_exponent
        return self.attraction * (alpha - beta) / r ** (beta + 1)

    @property
    def depth(self) -> float:
        """Work [J] that parts a pair of 1 kg each at its rest length."""
        r, alpha, beta = self.rest_length, self.repulsion_exponent, self.attraction_exponent
        return self.attraction * r ** (1 - beta) * (1.0 / (beta - 1) - 1.0 / (alpha - 1))

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        heaviest = float(np.max(fields["mass"]))
        if heaviest > self.mass * (1.0 + ROUNDING):
            raise InputError(f"PairPotential: mass = {self.mass}: must be the heaviest particle's, {heaviest:g} kg")
        return {}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        pair = PairConstants()
        pair.attraction, pair.repulsion = wp.float64(self.attraction), wp.float64(self.repulsion)
        pair.attraction_exponent, pair.repulsion_exponent = self.attraction_exponent, self.repulsion_exponent
        pair.cutoff_squared = wp.float64(self.cutoff**2)
        return {"pair": pair}

    def reach(self, model: Model) -> float:
        return self.cutoff * (1.0 + ROUNDING)

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        """A tenth of the period of the fastest mode of a close-packed lattice, in which omega^2 = 8 k / m at most."""
        return {"vibration of bonds": 0.1 * 2.0 * np.pi / np.sqrt(8.0 * self.stiffness * self.mass)}

    def speed_limit(self, model: Model) -> float:
        return BEYOND_ESCAPE * float(np.sqrt(2.0 * self.depth * self.mass))

    def sum_forces(self, launch: Launch) -> None:
        launch(add_pair_forces)
