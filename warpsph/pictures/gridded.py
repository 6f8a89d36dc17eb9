"""What particles carry, on the points of a grid in the plane."""

import numpy as np
from scipy.ndimage import gaussian_filter

from warpsph.pictures.parts import BESIDE_THE_FLUID, Fields
from warpsph.pictures.view import View

EMPTY = 0.3  # of the particles that there are inside a body


def gridded(
    points: np.ndarray, fields: Fields, values: np.ndarray, view: View, cell: float, blur: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Smooth means of the values of the simulated material.

    Args:
        points: places (n, 3) [m].
        fields: with the role (n,).
        values: one number a particle (n,).
        view: where the grid lies.
        cell: its edge, in spacings.
        blur: width over which values are averaged, in cells.

    Returns:
        x (a,) and y (b,) of the grid [m], and the means (b, a), not a number where nothing is.
    """
    edge = max(cell * view.spacing, view.finest)
    x, y = (np.arange(low, high + edge, edge) for low, high in ((view.left, view.right), (view.bottom, view.top)))
    of = ~np.isin(fields["role"], BESIDE_THE_FLUID) & np.isfinite(values)
    places = points[of, 1], points[of, 0]
    counts = gaussian_filter(np.histogram2d(*places, (y, x))[0], blur)
    sums = gaussian_filter(np.histogram2d(*places, (y, x), weights=values[of])[0], blur)
    means = np.where(counts > EMPTY * cell**2, sums / np.maximum(counts, 1e-9), np.nan)
    return 0.5 * (x[1:] + x[:-1]), 0.5 * (y[1:] + y[:-1]), means
