"""Axes of a picture in perspective: three edges of the box that holds the particles, with ticks."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from warpsph.pictures.view import View

INK, PALE_INK = "#26292e", "#8a8f98"
# of each axis: which of the other two coordinates are at the upper end, and where its numbers and its name stand [pt]
EDGES = (
    ((0, 0, 1), (-6, -5), (-16, -18), {"ha": "right", "va": "top"}),
    ((0, 0, 1), (-6, 0), (-34, 0), {"ha": "right", "va": "center"}),
    ((1, 0, 0), (6, -5), (16, -18), {"ha": "left", "va": "top"}),
)


def draw_axes(axes: Axes, view: View) -> None:
    """Draw x along the lower edge in front, z along the one at the right, and y at the left."""
    if view.camera is None:
        return
    low, high = view.camera.low, view.camera.high
    for axis, (upper, beside, name_beside, style) in enumerate(EDGES):
        corner = np.where(upper, high, low)
        ends = np.tile(corner, (2, 1))
        ends[:, axis] = low[axis], high[axis]
        axes.plot(*view.project(ends)[:, :2].T, color=PALE_INK, linewidth=0.7, clip_on=False, zorder=0.5)
        ticks = MaxNLocator(4, steps=[1, 2, 5, 10]).tick_values(low[axis], high[axis])
        ticks = ticks[(ticks > low[axis] - 1e-9) & (ticks < high[axis] + 1e-9)]
        places = np.tile(corner, (len(ticks), 1))
        places[:, axis] = ticks
        for tick, place in zip(ticks, view.project(places)[:, :2], strict=True):
            axes.annotate(
                f"{tick:.12g}",
                place,
                beside,
                textcoords="offset points",
                fontsize=8,
                color=INK,
                arrowprops={"arrowstyle": "-", "color": PALE_INK, "linewidth": 0.6, "shrinkA": 0, "shrinkB": 0},
                annotation_clip=False,
                **style,
            )
        middle = view.project(ends.mean(axis=0, keepdims=True))[0, :2]
        name = {"textcoords": "offset points", "fontsize": 8.5, "color": INK, "annotation_clip": False}
        axes.annotate(f"{'xyz'[axis]} [m]", middle, name_beside, rotation=90 if axis == 1 else 0, **name, **style)
