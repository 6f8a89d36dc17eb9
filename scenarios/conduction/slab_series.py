"""Conduction through a slab between two faces: the exact solution, a series of its modes."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import trapezoid
from scipy.optimize import brentq

MODES = 60  # enough from a hundredth of the time L^2 / diffusivity on


@dataclass(frozen=True)
class Face:
    """``conductance (T - outside) + flux`` [W/m^2] leaves the slab; the conductance is infinite for a given T."""

    conductance: float
    outside: float
    flux: float


@dataclass(frozen=True)
class Slab:
    """A slab of one temperature at the start, with what happens on its faces at x = 0 and x = ``thickness``.

    Separation of variables, as in Carslaw & Jaeger (1959), chapter III. Lengths in m, conductivity in W/(m K),
    diffusivity in m^2/s, ``start`` in K.
    """

    thickness: float
    conductivity: float
    diffusivity: float
    start: float
    left: Face
    right: Face

    def temperature(self, x: np.ndarray, time: float) -> np.ndarray:
        """T (n,) [K] at ``x`` (n,) [m]."""
        return self._at(x, time)[0]

    def flux(self, time: float) -> tuple[float, float]:
        """What leaves by the left and by the right face [W/m^2]."""
        slope = self._at(np.array([0.0, self.thickness]), time)[1]
        return float(self.conductivity * slope[0]), float(-self.conductivity * slope[1])

    def _at(self, x: np.ndarray, time: float) -> tuple[np.ndarray, np.ndarray]:
        """Temperature and its gradient (n,) at ``x`` (n,)."""
        fine = np.linspace(0.0, self.thickness, 4001)
        final, slope = self._in_the_end(x, time)
        rest = self.start - self._in_the_end(fine, 0.0)[0]
        for k in self._wave_numbers():
            shape = self._mode(k, fine)[0]
            share = trapezoid(rest * shape, fine) / trapezoid(shape**2, fine)
            share *= np.exp(-self.diffusivity * k**2 * time)
            mode, steepness = self._mode(k, x)
            final, slope = final + share * mode, slope + share * steepness
        return final, slope

    def _ends(self) -> list[tuple[float, float]]:
        """For each face (a, b), so that its modes have a T = b dT/dn: (1, 0) at given temperature, (0, 1) insulated."""
        faces = (self.left, self.right)
        return [(1.0, 0.0) if np.isinf(f.conductance) else (f.conductance / self.conductivity, 1.0) for f in faces]

    def _mode(self, k: float, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Shape of a mode, and its slope; the constant where k is 0."""
        (a, b), _ = self._ends()
        if k == 0.0:
            return np.ones_like(x), np.zeros_like(x)
        return b * k * np.cos(k * x) + a * np.sin(k * x), k * (a * np.cos(k * x) - b * k * np.sin(k * x))

    def _wave_numbers(self) -> list[float]:
        """Wave numbers [1/m] of the first modes."""
        (a_left, _), (a, b) = self._ends()
        end = np.array([self.thickness])

        def misfit(k: float) -> float:
            shape, slope = self._mode(k, end)
            return float(a * shape[0] + b * slope[0])

        grid = np.linspace(1e-3, MODES, 20 * MODES + 7) * np.pi / self.thickness
        values = [misfit(k) for k in grid]
        changes = [i for i in range(len(grid) - 1) if values[i] * values[i + 1] < 0.0]
        roots = [float(brentq(misfit, grid[i], grid[i + 1], xtol=1e-12)) for i in changes]
        return ([0.0] if a_left == a == 0.0 else []) + roots

    def _in_the_end(self, x: np.ndarray, time: float) -> tuple[np.ndarray, np.ndarray]:
        """What the temperature tends to, and its gradient; where no face gives a temperature it rises for ever."""
        L, k, faces = self.thickness, self.conductivity, (self.left, self.right)
        if self.left.conductance == self.right.conductance == 0.0:
            bend = -(self.left.flux + self.right.flux) / (k * L)  # d2T/dx2
            slope = self.left.flux / k
            return slope * x + 0.5 * bend * x**2 + self.diffusivity * bend * time, slope + bend * x
        rows, sides = [], []
        for face, at, sign in zip(faces, (0.0, L), (1.0, -1.0), strict=True):
            # of T = c0 + c1 x the flux sign k c1 leaves by each face
            if np.isinf(face.conductance):
                rows.append([1.0, at])
                sides.append(face.outside)
            else:
                rows.append([face.conductance, face.conductance * at - sign * k])
                sides.append(face.conductance * face.outside - face.flux)
        c = np.linalg.solve(rows, sides)
        return c[0] + c[1] * x, np.full_like(x, c[1])
