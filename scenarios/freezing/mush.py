"""The growth of an ideal mush from a cold wall into a half space: a function of height over the root of time.

Everything is at rest, ice and liquid have one temperature and conduct beside each other, the liquid of the mush is
everywhere on its straight liquidus, and each place keeps its mass; the solute diffuses in the liquid. It is the mush of
Worster (1986) for phases of two densities that do not flow.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.integrate import OdeSolution, solve_ivp
from scipy.optimize import brentq
from scipy.special import erfc, erfcx

NEAREST = 0.02  # of the front: below, diffusion from the wall, which the last slope goes on through, is left out
MOST_CALLS = 5000  # of an integration that gets through
NO_ICE = 1e-8  # of the volume: rounding
REACHED = 0  # status of an integration that nothing has ended before its end
HALVINGS = 10  # on the way from a front with a mush to one without
TRIED = np.geomspace(1e-4, 10.0, 80)  # fronts, over the width of the layer of heat in the liquid


@dataclass(frozen=True)
class Mush:
    """A solution of which ice grows.

    Args:
        concentration: mass fraction of the solute at the start.
        wall, far: temperature of the wall, and of the liquid at the start [K].
        pure: melting point of the solvent [K].
        slope: of the straight liquidus [K], Gamma.
        latent_heat: [J/kg].
        density_liquid, density_ice: of the solution at the start, and of the ice [kg/m^3].
        capacity_liquid, capacity_ice: [J/(kg K)].
        conductivity_liquid, conductivity_ice: [W/(m K)].
        diffusivity: of the solute, times the density [kg/(m s)].
        literal: whether the mush conducts as two families do by equation (4.2) of Monaghan et al. (2005) as printed.
    """

    concentration: float
    wall: float
    far: float
    pure: float
    slope: float
    latent_heat: float
    density_liquid: float
    density_ice: float
    capacity_liquid: float
    capacity_ice: float
    conductivity_liquid: float
    conductivity_ice: float
    diffusivity: float
    literal: bool = False

    @property
    def liquidus(self) -> float:
        """Temperature [K] at which the solution of the start begins to freeze."""
        return self.pure - self.slope * self.concentration

    @cached_property
    def front_temperature(self) -> float:
        """Temperature [K] of the front; solute that has diffused ahead of it makes it colder than the liquidus."""
        return self._start(self._front)[0] if np.isfinite(self._front) else self.liquidus

    def front(self, time: float) -> float:
        """Thickness [m] of the mush at a time [s]; not a number where there is no such solution."""
        return self._front * float(np.sqrt(time))

    def temperature(self, height: np.ndarray, time: float) -> np.ndarray:
        """[K] at a height [m] above the wall and a time [s]."""
        reduced = np.asarray(height, float) / np.sqrt(time)
        ahead = erfc(reduced / self._width) / erfc(self._front / self._width)
        ahead = self.far - (self.far - self.front_temperature) * ahead
        nearest = NEAREST * self._front
        temperature, slope, _ = self._profile(np.clip(reduced, nearest, self._front))
        return np.where(reduced < self._front, temperature - slope * np.maximum(nearest - reduced, 0.0), ahead)

    def ice(self, height: np.ndarray, time: float) -> np.ndarray:
        """Volume fraction of ice."""
        reduced = np.asarray(height, float) / np.sqrt(time)
        share = self._profile(np.clip(reduced, NEAREST * self._front, self._front))[2]
        return np.where(reduced < self._front, share * self.density_liquid / self.density_ice, 0.0)

    def solute(self, height: np.ndarray, time: float) -> np.ndarray:
        """Mass fraction of the solute in the liquid."""
        reduced = np.asarray(height, float) / np.sqrt(time)
        ahead = np.zeros_like(reduced)
        if (width := 2.0 * np.sqrt(self.diffusivity / self.density_liquid)) > 0.0:
            z, z_front = np.maximum(reduced, self._front) / width, self._front / width
            ahead = np.exp(z_front**2 - z**2) * erfcx(z) / erfcx(z_front)  # a ratio of erfc that does not underflow
        at_front = (self.pure - self.front_temperature) / self.slope
        ahead = self.concentration + (at_front - self.concentration) * ahead
        return np.where(reduced < self._front, (self.pure - self.temperature(height, time)) / self.slope, ahead)

    @property
    def _width(self) -> float:
        """Of the layer of heat in the liquid, over sqrt(t)."""
        return 2.0 * float(np.sqrt(self.conductivity_liquid / (self.density_liquid * self.capacity_liquid)))

    def _start(self, front: float) -> tuple[float, float]:
        """Temperature and its slope at a front (reduced), where the liquid ahead is just not undercooled.

        Gradients of temperature and liquidus are then equal, and the mush begins without ice.
        """
        heat = 2.0 / (self._width * np.sqrt(np.pi) * erfcx(front / self._width))  # slope over difference
        raised = 0.0
        if (width := 2.0 * np.sqrt(self.diffusivity / self.density_liquid)) > 0.0:
            solute = 2.0 / (width * np.sqrt(np.pi) * erfcx(front / width))
            raised = (self.far - self.liquidus) * heat / (solute - heat)
        temperature = self.liquidus - raised
        return temperature, (self.far - temperature) * heat

    def _mushy(self, reduced: float, y: np.ndarray) -> list[float]:
        """Derivatives of temperature, its slope and the mass fraction of ice: balances of solute and of heat."""
        temperature, slope, ice = y
        ratio = self.density_liquid / self.density_ice
        k_i, k_l = ratio * ice * self.conductivity_ice, (1.0 - ratio * ice) * self.conductivity_liquid
        conductivity, more = k_i + k_l, self.conductivity_ice - self.conductivity_liquid
        if self.literal:
            more += 4.0 * (self.conductivity_ice * k_l**2 - self.conductivity_liquid * k_i**2) / conductivity**2
            conductivity += 4.0 * k_i * k_l / conductivity
        more *= ratio  # by the mass fraction of ice
        capacity = self.capacity_liquid + (self.capacity_ice - self.capacity_liquid) * ice
        drift, D = 0.5 * reduced * self.density_liquid, self.diffusivity
        bends = np.array([D * (1.0 - ratio * ice), conductivity])
        freezes = np.array(
            [drift * (self.pure - temperature) - D * ratio * slope, more * slope - drift * self.latent_heat]
        )
        known = -drift * slope * np.array([1.0 - ice, capacity])
        bend, grows = np.linalg.solve(np.column_stack([bends, freezes]), known)
        return [slope, bend, grows]

    def _integrated(self, front: float) -> OdeSolution | None:
        """Temperature, slope and mass fraction of ice; None where no mush with such a front is so deep."""
        calls = iter(range(MOST_CALLS))

        def mushy(reduced: float, y: np.ndarray) -> list[float]:
            if next(calls, None) is None:
                raise ArithmeticError
            return self._mushy(reduced, y)

        def least(reduced: float, y: np.ndarray) -> float:
            """Volume fraction of ice or of liquid; asked at steps that are taken, not at those that are tried."""
            ice = y[2] * self.density_liquid / self.density_ice
            return float(min(ice + NO_ICE, 1.0 - ice))

        start = [*self._start(front), 0.0]
        try:
            found = solve_ivp(
                mushy,
                (front, NEAREST * front),
                start,
                rtol=1e-8,
                atol=1e-9,
                dense_output=True,
                events=_falls_to_zero(least),
            )
        except (ArithmeticError, np.linalg.LinAlgError):
            return None
        return found.sol if found.status == REACHED else None

    def _misses(self, front: float) -> float:
        """By how much the wall would be too warm [K]; not a number where no mush with such a front is so deep."""
        profile = self._integrated(front)
        if profile is None:
            return np.nan
        temperature, slope, _ = profile(NEAREST * front)
        return float(temperature - slope * NEAREST * front) - self.wall

    @cached_property
    def _front(self) -> float:
        """Front over sqrt(t); not a number where there is none."""
        low, too_warm = np.nan, np.nan
        for high in self._width * TRIED:
            still_too_warm = self._misses(high)
            if np.isfinite(front := self._between(low, too_warm, high, still_too_warm, HALVINGS)):
                return front
            low, too_warm = high, still_too_warm
        return np.nan

    def _between(self, low: float, too_warm: float, high: float, still_too_warm: float, halvings: int) -> float:
        """The front between two that miss the wall by so much [K]; not a number where none is found.

        Where one of them has no mush so deep, the wall may be met on the way from the other one to there.
        """
        if too_warm > 0.0 >= still_too_warm:
            try:
                return float(brentq(self._misses, low, high, rtol=1e-10))
            except ValueError:  # one between them has no mush so deep
                return np.nan
        up_to_here = too_warm > 0.0 and np.isnan(still_too_warm)
        from_here = np.isnan(too_warm) and still_too_warm <= 0.0
        if not (up_to_here or from_here) or halvings == 0 or np.isnan(low):
            return np.nan
        middle = 0.5 * (low + high)
        halfway = self._misses(middle)
        first = self._between(low, too_warm, middle, halfway, halvings - 1)
        return first if np.isfinite(first) else self._between(middle, halfway, high, still_too_warm, halvings - 1)

    @cached_property
    def _profile(self) -> Callable[[np.ndarray], np.ndarray]:
        """Temperature, slope and mass fraction of ice over the reduced height."""
        profile = self._integrated(self._front) if np.isfinite(self._front) else None
        return profile or (lambda reduced: np.full((3, *np.shape(reduced)), np.nan))


def _falls_to_zero(event: Any) -> Any:
    """An event that ends an integration where it comes down to zero."""
    event.terminal, event.direction = True, -1.0
    return event
