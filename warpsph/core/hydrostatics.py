"""The weakly compressible column at rest: its pressure, density and rows of particles (Vijaykumar 2012, 6.4-6.5).

The equations follow from dp/dz = -rho g with p = 0 at the surface and Tait's equation (1.5); gravity is positive.
"""

import numpy as np

from warpsph.core.equation_of_state import stiffness
from warpsph.kernels.flow.equation_of_state import GAMMA


def column_density(depth: np.ndarray | float, density: float, gravity: float, sound_speed: float) -> np.ndarray | float:
    """Density [kg/m^3] at a depth [m] below the free surface; ``density`` is the reference density."""
    return density * (1.0 + _compression(depth, gravity, sound_speed)) ** (1.0 / (GAMMA - 1.0))


def column_pressure(
    depth: np.ndarray | float, density: float, gravity: float, sound_speed: float
) -> np.ndarray | float:
    """Pressure [Pa] at a depth [m] below the free surface."""
    ratio = np.log1p(_compression(depth, gravity, sound_speed)) / (GAMMA - 1.0)  # logarithm of density over reference
    return stiffness(density, sound_speed) * np.expm1(GAMMA * ratio)


def depth_of_pressure(
    pressure: np.ndarray | float, density: float, gravity: float, sound_speed: float
) -> np.ndarray | float:
    """Depth [m] at which the column has a pressure [Pa], which is also the weight above a unit of area."""
    ratio = (1.0 + GAMMA * np.asarray(pressure) / (sound_speed**2 * density)) ** (1.0 / GAMMA)
    return sound_speed**2 / ((GAMMA - 1.0) * gravity) * (ratio ** (GAMMA - 1.0) - 1.0)


def row_heights(rows: int, spacing: float, gravity: float, sound_speed: float) -> np.ndarray:
    """Heights (rows,) [m] of particle rows at rest above a floor at 0, the lowest first.

    Each row carries the weight of those above it; ``spacing`` [m] is their distance in the uncompressed lattice.
    """
    weight = gravity * spacing  # of a row, over the density
    depth = depth_of_pressure(weight * (np.arange(rows, 0, -1) - 0.5), 1.0, gravity, sound_speed)
    return np.asarray(depth_of_pressure(weight * rows, 1.0, gravity, sound_speed) - depth)


def _compression(depth: np.ndarray | float, gravity: float, sound_speed: float) -> np.ndarray | float:
    return (GAMMA - 1.0) * gravity * np.maximum(depth, 0.0) / sound_speed**2
