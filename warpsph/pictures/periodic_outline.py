"""The outline of a periodic box: thin dashed lines where what leaves on one side comes in on the other."""

from itertools import product

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from warpsph.pictures.view import View

COLOUR = "#8a8f98"


def outline(view: View) -> np.ndarray:
    """Ends (m, 2, 3) [m] of the edges that bound a periodic axis; along the other axes they end with the view."""
    box = view.periodic
    if box is None:
        return np.zeros((0, 2, 3))
    if view.camera:
        low, high = view.camera.low, view.camera.high
    else:
        low, high = np.array([view.left, view.bottom, 0.0]), np.array([view.right, view.top, 0.0])
    lower, edges = np.asarray(box.lower), box.edges
    ends = np.stack([np.where(edges > 0.0, lower, low), np.where(edges > 0.0, lower + edges, high)])
    lines = []
    for along in range(3 if view.camera else 2):
        others = [axis for axis in range(3) if axis != along]
        if any(edges[axis] > 0.0 for axis in others):
            for corner in product((0, 1), (0, 1) if view.camera else (0,)):
                if view.camera and not any(corner):
                    continue  # behind all particles: the eye looks at the upper sides
                line = ends.copy()
                for axis, side in zip(others, corner, strict=True):
                    line[:, axis] = ends[side, axis]
                lines.append(line)
    return np.array(lines).reshape(-1, 2, 3)


def draw_outline(axes: Axes, view: View) -> None:
    """Draw it where there is one."""
    lines = [view.project(line)[:, :2] for line in outline(view)]
    if lines:
        axes.add_collection(
            LineCollection(lines, colors=COLOUR, linewidths=0.7, linestyles=[(0, (4, 3))]), autolim=False
        )
