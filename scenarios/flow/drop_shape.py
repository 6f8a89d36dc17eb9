"""Shapes of drops in the plane: an ellipse of particles, the modes of an outline, and the period of a swing."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import curve_fit


def ellipse(radius: float, elongation: float, spacing: float) -> np.ndarray:
    """Points (n, 3) [m] on rings around the centre, stretched along x and pressed along y by ``1 + elongation``.

    A lattice cut to an ellipse would have steps, each with a curvature of its own.
    """
    points = []
    for r in np.arange(0.5 * spacing, radius, spacing):
        n = round(2.0 * np.pi * r / spacing)
        angle = 2.0 * np.pi * np.arange(n) / n
        points.append(r * np.stack([np.cos(angle), np.sin(angle), np.zeros(n)], axis=1))
    return np.concatenate(points) * (1.0 + elongation, 1.0 / (1.0 + elongation), 1.0)


def shape_mode(x: np.ndarray, radius: float, n: int) -> float:
    """Amplitude a_n of a drop's outline r = R (1 + a_n cos n phi), from its particles ``x`` (m, 3) [m].

    The mean of r^n cos n phi over such a disc is R^n a_n to first order.
    """
    return float(np.mean(np.real((x[:, 0] + 1j * x[:, 1]) ** n)) / radius**n)


@dataclass(frozen=True)
class Swing:
    """A damped swing: the ``period`` [s] that it would have undamped, its ``damping`` rate [1/s], and ``amplitude``."""

    period: float
    damping: float
    amplitude: float


def swing_of(time: np.ndarray, values: np.ndarray, expected: float) -> Swing:
    """The damped swing A exp(-g t) cos(w t + phi) + c that fits ``values`` (n,) best, near the ``expected`` period [s].

    The first tenth of a period is left out: there the outline of lattice steps becomes smooth.
    """
    late = time > 0.1 * expected

    def damped(t, amplitude, damping, omega, angle, mean):
        return amplitude * np.exp(-damping * t) * np.cos(omega * t + angle) + mean

    start = (values[0], 0.0, 2.0 * np.pi / expected, 0.0, 0.0)
    (amplitude, damping, omega, _, _), _ = curve_fit(damped, time[late], values[late], p0=start, maxfev=20000)
    return Swing(float(2.0 * np.pi / np.hypot(omega, damping)), float(damping), float(abs(amplitude)))
