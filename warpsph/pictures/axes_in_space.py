"""Axes of a picture in perspective: three edges of the box that holds the particles, with ticks."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from warpsph.pictures.view import View

INK, PALE_INK = "#26292e", "#8a8f98"
TEXT: dict[str, Any] = {"textcoords": "offset points", "color": INK, "annotation_clip": False}
TICK: dict[str, Any] = {"arrowstyle": "-", "color": PALE_INK, "linewidth": 0.6, "shrinkA": 0, "shrinkB": 0}


@dataclass(frozen=True)
class Edge:
    """An edge of the box, and where what is written beside it stands [points].

    Args:
        upper: which coordinates of the edge are at the upper end of the box.
        number, name: distances of numbers and name from the edge.
        sides: on which sides of these places they stand, horizontally and vertically.
        rotation: of the name [degrees].
    """

    upper: tuple[int, int, int]
    number: tuple[float, float]
    name: tuple[float, float]
    sides: tuple[str, str]
    rotation: float = 0.0


EDGES = (
    Edge((0, 0, 1), (-6, -5), (-16, -18), ("right", "top")),
    Edge((0, 0, 1), (-6, 0), (-34, 0), ("right", "center"), 90.0),
    Edge((1, 0, 0), (6, -5), (16, -18), ("left", "top")),
)


def draw_axes(axes: Axes, view: View) -> None:
    """Draw x along the lower edge in front, z along the one at the right, and y at the left."""
    if view.camera is None:
        return
    low, high = view.camera.low, view.camera.high
    for axis, edge in enumerate(EDGES):
        ticks = MaxNLocator(4, steps=[1, 2, 5, 10]).tick_values(low[axis], high[axis])
        ticks = ticks[(ticks > low[axis] - 1e-9) & (ticks < high[axis] + 1e-9)]
        along = np.array([low[axis], high[axis], 0.5 * (low[axis] + high[axis]), *ticks])
        places = np.tile(np.where(edge.upper, high, low), (len(along), 1))
        places[:, axis] = along
        start, end, middle, *marks = view.project(places)[:, :2].tolist()
        axes.plot(*zip(start, end, strict=True), color=PALE_INK, linewidth=0.7, clip_on=False, zorder=0.5)
        style = TEXT | {"ha": edge.sides[0], "va": edge.sides[1]}
        for tick, place in zip(ticks, marks, strict=True):
            axes.annotate(f"{tick:.12g}", place, edge.number, arrowprops=TICK, fontsize=8, **style)
        axes.annotate(f"{'xyz'[axis]} [m]", middle, edge.name, rotation=edge.rotation, fontsize=8.5, **style)
