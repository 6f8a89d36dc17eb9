"""Where columns of particles have a given temperature."""

import numpy as np


def isotherm(height: np.ndarray, temperature: np.ndarray, level: float) -> np.ndarray:
    """Height (columns,) [m] at which each column first reaches ``level`` [K], from below; linear between rows.

    Args:
        height: of the rows (rows,) [m], rising.
        temperature: (columns, rows) [K].
        level: [K]; a column that is hotter all over has its lowest row there, one that is colder its uppermost.
    """
    above = np.argmax(temperature >= level, axis=1)
    above[np.all(temperature < level, axis=1)] = len(height) - 1
    below = np.maximum(above - 1, 0)
    column = np.arange(len(temperature))
    low, high = temperature[column, below], temperature[column, above]
    share = np.clip((level - low) / np.where(high > low, high - low, 1.0), 0.0, 1.0)
    return height[below] + share * (height[above] - height[below])
