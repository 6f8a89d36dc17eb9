"""The weakly compressible column at rest: its pressure, density and rows of particles (Vijaykumar 2012, 6.4-6.5)."""

import numpy as np

GAMMA = 7.0


def row_heights(rows: int, spacing: float, gravity: float, sound_speed: float) -> np.ndarray:
    """Heights (rows,) [m] of particle rows at rest above a floor at 0, the lowest first.

    Each row carries the weight of those above it; equation (6.4) with (6.5) and Tait's equation (1.5) gives in closed
    form how far the column settles.

    Args:
        rows: number of rows.
        spacing: distance of the rows in the uncompressed lattice [m].
        gravity: g [m/s^2], positive.
        sound_speed: c_s [m/s].
    """
    load = np.arange(rows, 0, -1) - 0.5  # rows above the centre of each row
    density_ratio = (1.0 + GAMMA * load * spacing * gravity / sound_speed**2) ** (1.0 / GAMMA)
    depth = _depth(density_ratio, gravity, sound_speed)
    floor = _depth((1.0 + GAMMA * rows * spacing * gravity / sound_speed**2) ** (1.0 / GAMMA), gravity, sound_speed)
    return floor - depth


def column_pressure(
    depth: np.ndarray | float, density: float, gravity: float, sound_speed: float
) -> np.ndarray | float:
    """Pressure [Pa] at a depth [m] below the free surface of the column at rest (errata of equation 6.4)."""
    ratio = (1.0 + (GAMMA - 1.0) * gravity * np.maximum(depth, 0.0) / sound_speed**2) ** (1.0 / (GAMMA - 1.0))
    return sound_speed**2 * density / GAMMA * (ratio**GAMMA - 1.0)


def _depth(density_ratio: np.ndarray | float, gravity: float, sound_speed: float) -> np.ndarray | float:
    return sound_speed**2 / ((GAMMA - 1.0) * gravity) * (density_ratio ** (GAMMA - 1.0) - 1.0)
