"""Fluid between two plates that is set in motion: the exact series."""

from dataclasses import dataclass

import numpy as np

MODES = 200  # enough from a ten thousandth of the time H^2 / nu on


@dataclass(frozen=True)
class Channel:
    """Fluid at rest until a push along the plates, at y = 0 and y = H, or the motion of the plates begins.

    Morris, Fox & Zhu (1997), equations 21 and 22, for any two plates. Lengths in m, times in s.

    Args:
        height: H between the plates.
        viscosity: nu, kinematic [m^2/s].
        push: acceleration along the plates [m/s^2].
        lower, upper: speed of the plates [m/s]; None for one along which the fluid slips, at most one of them.
    """

    height: float
    viscosity: float
    push: float
    lower: float | None
    upper: float | None

    def velocity(self, y: np.ndarray, time: float) -> np.ndarray:
        """u (n,) [m/s] at ``y`` (n,) [m]."""
        y = np.asarray(y, float)
        first, second = self.lower, self.upper
        if first is None:
            y, first, second = self.height - y, second, first
        assert first is not None
        H, nu = self.height, self.viscosity
        bend = self.push / (2.0 * nu)
        if second is None:
            steady = first + bend * y * (2.0 * H - y)
            kH, ends = (np.arange(MODES) + 0.5) * np.pi, np.zeros(MODES)
        else:
            steady = first + (second - first) * y / H + bend * y * (H - y)
            kH = (np.arange(MODES) + 1.0) * np.pi
            ends = np.cos(kH)
        k = kH / H
        shares = (first - (second or 0.0) * ends) / k + self.push / nu * (
            1.0 - ends
        ) / k**3  # of the modes, times H / 2
        return steady - 2.0 / H * np.sin(np.outer(y, k)) @ (shares * np.exp(-nu * k**2 * time))
