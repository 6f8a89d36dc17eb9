"""The line between what has frozen and what has not, in the plane."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import Stroke, withStroke
from scipy.ndimage import gaussian_filter

from warpsph.core.labels import Phase
from warpsph.pictures.parts import BESIDE_THE_FLUID, Fields
from warpsph.pictures.view import View

NAME = "edge of the shell"
CELLS = 2  # in a spacing
BLUR = 0.9  # in spacings: steps of single particles are smoothed, the shell is not
EMPTY = 0.3  # of the particles that there are inside a body
LINE: dict[str, Any] = {"colors": "white", "linewidths": 1.1}
RIM: Stroke = withStroke(linewidth=2.6, foreground="#26292e")


def solid_share(points: np.ndarray, fields: Fields, view: View) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Share of solid around the points of a grid.

    Returns:
        x (a,) and y (b,) of the grid [m], and the share (b, a) from 0 to 1, not a number where nothing is.
    """
    cell = max(view.spacing / CELLS, view.finest)
    x, y = (np.arange(low, high + cell, cell) for low, high in ((view.left, view.right), (view.bottom, view.top)))
    material = ~np.isin(fields["role"], BESIDE_THE_FLUID)
    solid = material & (fields["phase"] == Phase.SOLID)
    counts = [
        gaussian_filter(np.histogram2d(points[of, 1], points[of, 0], (y, x))[0], BLUR * CELLS)
        for of in (solid, material)
    ]
    share = np.where(counts[1] > EMPTY / CELLS**2, counts[0] / np.maximum(counts[1], 1e-9), np.nan)
    return 0.5 * (x[1:] + x[:-1]), 0.5 * (y[1:] + y[:-1]), share


def draw_edge(axes: Axes, points: np.ndarray, fields: Fields, view: View) -> list[Any]:
    """Draw the line, where there is one; return what can be removed again."""
    x, y, share = solid_share(points, fields, view)
    if not np.nanmin(share, initial=1.0) < 0.5 < np.nanmax(share, initial=0.0):
        return []
    line = axes.contour(x, y, share, [0.5], **LINE)
    line.set_path_effects([RIM])
    return [line]
