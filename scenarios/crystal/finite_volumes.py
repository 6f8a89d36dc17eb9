"""Conduction on square cells by finite volumes: an independent reference for what the particles find."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix, diags
from scipy.sparse.linalg import splu

STAGE = 1.0 - np.sqrt(0.5)  # of the diagonally implicit Runge-Kutta method of two stages, second order and L-stable


@dataclass(frozen=True, eq=False)
class SquareCells:
    """A half plane of square cells, mirrored at x = 0; heat passes to the outside on its other three faces.

    Two cells exchange what passes their half cells in series, which is the harmonic mean of their conductivities; a
    cell and the outside what passes its half cell and the film.

    Args:
        spacing: edge of a cell [m].
        conductivity: (columns, rows) [W/(m K)].
        heat_capacity: (columns, rows) per volume [J/(m^3 K)].
        conductance, outside: [W/(m^2 K)] and [K] of the films on the right face (rows,), the lower one (columns,) and
            the upper one (columns,).
    """

    spacing: float
    conductivity: np.ndarray
    heat_capacity: np.ndarray
    conductance: Sequence[np.ndarray]
    outside: Sequence[np.ndarray]

    def temperature(self, start: np.ndarray, duration: float, steps: int = 400) -> np.ndarray:
        """Temperature (columns, rows) [K] after ``duration`` [s], from that at the ``start``."""
        matrix, gain = self._system
        heat = self.heat_capacity.ravel() * self.spacing**2
        dt = duration / steps
        solve = splu(csc_matrix(diags(heat) - STAGE * dt * matrix)).solve
        T = np.asarray(start, float).ravel()
        for _ in range(steps):
            first = solve(matrix @ T + gain)
            second = solve(matrix @ (T + (1.0 - STAGE) * dt * first) + gain)
            T = T + dt * ((1.0 - STAGE) * first + STAGE * second)
        return T.reshape(start.shape)

    @property
    def _system(self) -> tuple[csc_matrix, np.ndarray]:
        """What the cells gain in unit time and metre of depth [W/m]: a matrix times their temperatures, plus a rest."""
        k = self.conductivity
        number = np.arange(k.size).reshape(k.shape)
        rows, columns, values = [], [], []
        for a, b in ((np.s_[:-1, :], np.s_[1:, :]), (np.s_[:, :-1], np.s_[:, 1:])):
            link = (2.0 * k[a] * k[b] / (k[a] + k[b])).ravel()  # Rook et al. (23)
            here, there = number[a].ravel(), number[b].ravel()
            rows += [here, there, here, there]
            columns += [there, here, here, there]
            values += [link, link, -link, -link]
        gain = np.zeros(k.size)
        faces = (number[-1, :], number[:, 0], number[:, -1])
        for cells, conductance, outside in zip(faces, self.conductance, self.outside, strict=True):
            film = self.spacing / (1.0 / conductance + 0.5 * self.spacing / k.ravel()[cells])
            gain[cells] += film * outside
            rows, columns, values = [*rows, cells], [*columns, cells], [*values, -film]
        entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
        return coo_matrix(entries, shape=(k.size, k.size)).tocsc(), gain
