"""Values between particles: a parabola fitted to those around."""

import numpy as np
from scipy.spatial import cKDTree

REACH = 2.6  # spacings: some twenty neighbours in the plane, for the six numbers of a parabola
NEIGHBOURS = 24
UNKNOWNS = 6


def fitted(places: np.ndarray, points: np.ndarray, values: np.ndarray, spacing: float) -> np.ndarray:
    """Values (m, ...) at ``places`` (m, 2) [m] in the plane, of third order in the spacing inside and at walls alike.

    Weighted least squares of a parabola over the nearest particles; not a number where fewer than six are left.

    Args:
        places: where values are wanted (m, 2) [m].
        points: of the particles (n, 2) [m].
        values: theirs (n, ...).
        spacing: of the particles [m].
    """
    there = np.isfinite(points).all(axis=1) & np.isfinite(values).all(axis=tuple(range(1, values.ndim)))
    points, values = points[there], values[there]
    if len(points) < UNKNOWNS:
        return np.full((len(places), *values.shape[1:]), np.nan)
    distance, near = cKDTree(points).query(places, min(NEIGHBOURS, len(points)))
    found = []
    for place, r, k in zip(places, distance, near, strict=True):
        x, y = ((points[k] - place) / spacing).T
        terms = np.column_stack([np.ones_like(x), x, y, x * x, x * y, y * y])
        weight = np.exp(-((r / (REACH / 2.0 * spacing)) ** 2))
        found.append(np.linalg.lstsq(terms * weight[:, None], values[k] * _over(weight, values), rcond=None)[0][0])
    return np.array(found)


def _over(weight: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Weights with as many axes as the values have."""
    return weight.reshape(-1, *(1,) * (values.ndim - 1))
