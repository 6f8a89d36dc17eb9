"""What may be drawn over the particles in the plane: arrows of the velocity, streamlines, lines of equal values."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import Stroke, withStroke
from matplotlib.text import Text

from warpsph.errors import InputError, shown
from warpsph.pictures.gridded import gridded
from warpsph.pictures.parts import Fields
from warpsph.pictures.shown_field import values_of
from warpsph.pictures.view import View

INK = "#26292e"
RIM: Stroke = withStroke(linewidth=2.2, foreground="white")
THIN_RIM: Stroke = withStroke(linewidth=1.0, foreground="white")
ARROWS = 22  # along the longer side of the picture
SLOWEST = 0.03  # arrow that is drawn, over the fastest
DENSITY = 1.3  # of streamlines, as matplotlib counts them
FINE, BLUR = 0.5, 1.8  # cells in spacings, and over how many of them values are averaged


@dataclass(frozen=True)
class Lines:
    """What is drawn over the particles.

    Args:
        arrows: whether velocities are shown as arrows.
        streamlines: whether lines follow the velocity.
        levels: values at which lines of equal value are drawn.
        field: of which; None for the one that the colours show.
    """

    arrows: bool = False
    streamlines: bool = False
    levels: tuple[float, ...] = ()
    field: str | None = None

    def __post_init__(self) -> None:
        if not np.all(np.isfinite(self.levels)):
            raise InputError(f"levels = {shown(self.levels)}: must be finite numbers")

    def __bool__(self) -> bool:
        return bool(self.arrows or self.streamlines or self.levels)


NO_LINES = Lines()


def draw_lines(axes: Axes, points: np.ndarray, fields: Fields, view: View, lines: Lines, colours: str) -> list[Any]:
    """Draw the lines into axes; return what can be removed again.

    Args:
        axes: of the picture.
        points: places (n, 3) [m].
        fields: by name.
        view: of the picture.
        lines: what to draw.
        colours: name of the field that the colours show.
    """
    before = set(axes.get_children())
    if lines.levels:
        values = values_of(fields, lines.field or colours)
        _draw_levels(axes, *gridded(points, fields, values, view, FINE, BLUR), lines.levels)
    if lines.streamlines:
        _draw_streamlines(axes, points, fields, view)
    if lines.arrows:
        _draw_arrows(axes, points, fields, view)
    drawn = [child for child in axes.get_children() if child not in before]
    return [child for child in drawn if not isinstance(child, Text)]  # the labels of lines go with these


def _draw_levels(axes: Axes, x: np.ndarray, y: np.ndarray, values: np.ndarray, given: tuple[float, ...]) -> None:
    low, high = np.nanmin(values, initial=np.inf), np.nanmax(values, initial=-np.inf)
    levels = sorted({level for level in given if low < level < high})
    if levels:
        drawn = axes.contour(x, y, values, levels, colors=INK, linewidths=1.0, linestyles="-")
        drawn.set_path_effects([RIM])
        for label in axes.clabel(drawn, fmt="%g", fontsize=7, inline_spacing=3):
            label.set_path_effects([RIM])


def _draw_streamlines(axes: Axes, points: np.ndarray, fields: Fields, view: View) -> None:
    velocity = fields["velocity"]
    x, y, u = gridded(points, fields, velocity[:, 0], view, FINE, BLUR)
    _, _, v = gridded(points, fields, velocity[:, 1], view, FINE, BLUR)
    limits = axes.get_xlim(), axes.get_ylim()
    if np.any(np.hypot(u, v) > 0.0):  # false where both are not numbers
        x, y = np.linspace(x[0], x[-1], len(x)), np.linspace(y[0], y[-1], len(y))  # evenly, to the last bit
        axes.streamplot(x, y, u, v, density=DENSITY, color=INK, linewidth=0.8, arrowsize=0.8)
    axes.set(xlim=limits[0], ylim=limits[1])


def _draw_arrows(axes: Axes, points: np.ndarray, fields: Fields, view: View) -> None:
    """The longest arrows are as long as their distance; how fast they are stands above the picture."""
    cell = max(max(view.right - view.left, view.top - view.bottom) / ARROWS / view.spacing, 1.0)
    carried = (*points.T[:2], *fields["velocity"].T[:2])
    x, y, u, v = (gridded(points, fields, values, view, cell, 0.0)[2] for values in carried)
    speed = np.hypot(u, v)
    fastest = float(np.quantile(speed[np.isfinite(speed)], 0.98)) if np.any(speed > 0.0) else 0.0
    moving = speed > SLOWEST * fastest  # false where nothing is
    if not np.any(moving):
        return
    metres: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": fastest / (cell * view.spacing)}
    style: dict[str, Any] = {"color": INK, "units": "inches", "width": 0.022, "pivot": "middle", "minlength": 0.0}
    arrows = axes.quiver(x[moving], y[moving], u[moving], v[moving], **metres, **style)
    arrows.set_path_effects([THIN_RIM])
    label = f"{fastest:.2g} m/s"
    axes.quiverkey(arrows, 0.97, 1.02, fastest, label, labelpos="W", coordinates="axes", fontproperties={"size": 8})
