"""A plate that cools from one temperature: the exact double series, each a product of two series along an edge.

Rook, Yildiz & Dost (2007), section 4.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

BISECTIONS = 60  # of an interval of pi/2, to the last bit
SMALLEST = 40.0  # modes that have decayed by more than exp(-40) are left out


@dataclass(frozen=True)
class Plate:
    """A plate of the temperature ``start`` [K] whose edges pass heat to ``outside`` [K].

    Lengths of its edges along x and y in m, diffusivity in m^2/s.
    """

    length: float
    height: float
    diffusivity: float
    start: float
    outside: float

    def temperature(self, position: np.ndarray, time: float) -> np.ndarray:
        """T (n,) [K] at ``position`` (n, 2 or 3) [m], from the corner of the plate at the origin."""
        along_x = self._of_each(position[:, 0], lambda x: self.profile(x, self.length, time))
        along_y = self._of_each(position[:, 1], lambda y: self.profile(y, self.height, time))
        return self.outside + (self.start - self.outside) * along_x * along_y

    def profile(self, x: np.ndarray, edge: float, time: float) -> np.ndarray:
        """What is left (n,) of a rise of 1 at ``x`` (n,) [m] along an edge of the length ``edge`` [m]."""
        if time <= 0.0:
            return np.ones_like(x)
        fourier = self.diffusivity * time / edge**2
        numbers, shares = self.modes(edge, np.sqrt(SMALLEST / fourier))
        return self.shape(np.outer(x / edge, numbers)) @ (shares * np.exp(-fourier * numbers**2))

    def modes(self, edge: float, largest: float) -> tuple[np.ndarray, np.ndarray]:
        """Wave numbers times ``edge``, those up to ``largest`` and at least one, and the shares of their modes."""
        raise NotImplementedError

    def shape(self, phase: np.ndarray) -> np.ndarray:
        """The shape of the modes at a ``phase``, wave number times place."""
        raise NotImplementedError

    @staticmethod
    def _of_each(x: np.ndarray, profile: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
        """The profile at ``x`` (n,), found once for each place: many particles share a row."""
        places, of_place = np.unique(np.asarray(x, float), return_inverse=True)
        return profile(places)[of_place.reshape(-1)]


@dataclass(frozen=True)
class FixedPlate(Plate):
    """All edges are kept at ``outside``. Rook, Yildiz & Dost (2007), equation (19), there with ``outside`` = 0."""

    def modes(self, edge: float, largest: float) -> tuple[np.ndarray, np.ndarray]:
        odd = np.arange(1.0, max(largest / np.pi, 1.0) + 1.0, 2.0)
        return np.pi * odd, 4.0 / (np.pi * odd)

    def shape(self, phase: np.ndarray) -> np.ndarray:
        return np.sin(phase)


@dataclass(frozen=True)
class ConvectivePlate(Plate):
    """Edges at x = 0 and y = 0 are insulated, the others have a film before ``outside``.

    Rook, Yildiz & Dost (2007), equations (20) and (21), there with ``outside`` = 0.

    Args:
        ratio: conductance of the film over the conductivity [1/m].
    """

    ratio: float

    def modes(self, edge: float, largest: float) -> tuple[np.ndarray, np.ndarray]:
        biot = self.ratio * edge
        numbers = film_roots(biot, int(largest / np.pi) + 1)
        return numbers, 2.0 * biot / ((numbers**2 + biot**2 + biot) * np.cos(numbers))

    def shape(self, phase: np.ndarray) -> np.ndarray:
        return np.cos(phase)


def film_roots(biot: float, count: int) -> np.ndarray:
    """The first positive roots z (count,) of z tan z = ``biot``: one in each interval from n pi to (n + 1/2) pi."""
    n = np.arange(count)
    sign = np.where(n % 2 == 0, 1.0, -1.0)
    low, high = np.pi * n, np.pi * (n + 0.5)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        below = sign * (middle * np.sin(middle) - biot * np.cos(middle)) < 0.0
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)
