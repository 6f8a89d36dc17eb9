"""The exact motion of an ellipse of inviscid fluid whose velocity is linear in space."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp


@dataclass(frozen=True)
class StretchedEllipse:
    """A circle of ``radius`` R [m] that starts with u = (A x, -A y), ``rate`` A [1/s], and stretches along x.

    Its velocity remains (sigma x, -sigma y), its pressure a paraboloid that is zero at the outline (Monaghan 1994).
    """

    radius: float
    rate: float

    def semi_axes(self, times: np.ndarray) -> np.ndarray:
        """Half the length and half the width (n, 2) [m] at times (n,) [s] that rise from 0 on."""
        start = [self.radius, self.radius, self.rate]
        path = solve_ivp(_change, (0.0, max(float(times[-1]), 1e-12)), start, t_eval=times, rtol=1e-10, atol=1e-12)
        return path.y[:2].T

    def pressure(self, points: np.ndarray, density: float) -> np.ndarray:
        """Pressure (n,) [Pa] at points (n, 3) [m] of the circle at the start."""
        return 0.5 * density * self.rate**2 * np.maximum(self.radius**2 - np.sum(points**2, axis=1), 0.0)


def _change(time: float, state: np.ndarray) -> list[float]:
    """Of the semi-axes and of sigma: sigma' + sigma^2 = 2 p_0 / (rho a^2), -sigma' + sigma^2 = 2 p_0 / (rho b^2)."""
    a, b, sigma = state
    return [sigma * a, -sigma * b, sigma**2 * (b**2 - a**2) / (a**2 + b**2)]
