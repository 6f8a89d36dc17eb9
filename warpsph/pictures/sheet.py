"""The sheet around the particles: axes, time stamps, colour bar and key, the same for every painter."""

from collections.abc import Callable
from pathlib import Path
from textwrap import wrap
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from warpsph.errors import cut
from warpsph.files.beside import hidden_until_whole
from warpsph.pictures.axes_in_space import INK, PALE_INK, draw_axes
from warpsph.pictures.layout import arrange
from warpsph.pictures.looks import Look
from warpsph.pictures.periodic_outline import draw_outline
from warpsph.pictures.shell_edge import NAME, RIM
from warpsph.pictures.units import plain
from warpsph.pictures.view import View

STILL_SUFFIXES = (".png", ".pdf", ".svg", ".jpg")
# inches
BAR_WIDTH, BAR_HEIGHT, LINE = 0.17, 3.0, 0.23
POWER = 0.62  # from the left of the bar to its power of ten, beside the tick labels
KEY_LETTERS = 17  # in a line of the key's title
LONGEST_NAME = 40  # letters, in the key


class Sheet:
    """One or more panels with the same view and look, and one key for all.

    Args:
        view: what each panel shows.
        look: what the colours mean.
        panels: number of panels.
        long_side: of one panel [inch].
        dots_per_inch: resolution of the sheet.
        last_time: of the run [s]; decides on the digits of the time stamps.
    """

    def __init__(
        self, view: View, look: Look, panels: int, long_side: float, dots_per_inch: int, last_time: float
    ) -> None:
        title = wrap(look.title, KEY_LETTERS)
        heading = 0.6 * LINE * (len(title) + 1)
        signs = len(look.patches()) + look.edge
        key = heading + LINE * (signs + 0.3) + (1.2 if look.bar else 0.0)
        layout = arrange(view.aspect, panels, long_side, key)
        total, (_, _, width, height) = layout.total, layout.panels[0]

        # whole and even numbers of pixels, which movies need
        pixels = [2 * round(dots_per_inch * length / 2) for length in total]
        self.figure = Figure(
            figsize=(pixels[0] / dots_per_inch, pixels[1] / dots_per_inch), dpi=dots_per_inch, facecolor="white"
        )
        self.canvas = FigureCanvasAgg(self.figure)
        self.size = (max(2, round(dots_per_inch * width)), max(2, round(dots_per_inch * height)))
        self._total, self._view, self._last_time = total, view, last_time
        self._panels = []
        for panel, place in enumerate(layout.panels):
            axes = self._axes(*place)
            self._dress(axes, first=panel % layout.columns == 0)
            self._panels.append(
                (axes, self._blank(axes), axes.set_title("", loc="left", fontsize=10, color=INK, pad=5))
            )
        self._overlays: dict[int, list[Any]] = {}
        key_left, key_top = layout.key
        self._text(key_left, key_top, "\n".join(title), weight="bold")
        self._draw_key(look, key_left, key_top - heading, max(layout.room, key - LINE) - heading)

    @property
    def scale(self) -> float:
        """Points (1/72 inch) for a unit of the view [1/m]."""
        return 72.0 * self.size[0] / self.figure.dpi / (self._view.right - self._view.left)

    def show(self, panel: int, image: np.ndarray, time: float) -> None:
        """Put the painted particles (height, width, 3) uint8 of ``time`` [s] into a panel."""
        _, picture, title = self._panels[panel]
        picture.set_data(image)
        title.set_text(f"t = {time_text(time, self._last_time)}")

    def overlay(self, panel: int, draw: Callable[[Axes], list[Any]]) -> None:
        """Draw lines over a panel, in the place of those before; ``draw`` returns what can be removed again."""
        for drawn in self._overlays.get(panel, []):
            drawn.remove()
        self._overlays[panel] = draw(self._panels[panel][0])

    def save(self, output: Path) -> None:
        """Write the sheet to a file."""
        save(self.figure, output)

    def pixels(self) -> np.ndarray:
        """The sheet as an image (height, width, 3) uint8."""
        self.canvas.draw()
        return np.asarray(self.canvas.buffer_rgba())[:, :, :3]

    def _axes(self, left: float, bottom: float, width: float, height: float):
        """Axes at a place in inches."""
        across, up = self._total
        return self.figure.add_axes((left / across, bottom / up, width / across, height / up))

    def _blank(self, axes):
        view = self._view
        white = np.full((1, 1, 3), 255, "u1")
        extent = (view.left, view.right, view.bottom, view.top)
        return axes.imshow(white, extent=extent, aspect="auto", interpolation="antialiased")

    def _dress(self, axes, first: bool) -> None:
        axes.set_frame_on(False)
        draw_outline(axes, self._view)
        if self._view.camera:
            axes.set(xticks=[], yticks=[])
            draw_axes(axes, self._view)
            axes.set(xlim=(self._view.left, self._view.right), ylim=(self._view.bottom, self._view.top))
            return
        axes.tick_params(colors=PALE_INK, labelcolor=INK, labelsize=8, length=3, width=0.6, left=first, labelleft=first)
        axes.locator_params(axis="x", nbins=max(2, round(self.size[0] / self.figure.dpi * 2.2)))
        axes.set_xlabel("x [m]", fontsize=8.5, color=INK, labelpad=2)
        if first:
            axes.set_ylabel("y [m]", fontsize=8.5, color=INK, labelpad=2)

    def _draw_key(self, look: Look, left: float, top: float, height: float) -> None:
        patches = look.patches()
        if look.bar:
            bar_height = min(BAR_HEIGHT, height - (len(patches) + look.edge + 1) * LINE)
            indent = 0.17 if look.bar.halves else 0.0
            axes = self._axes(left + indent, top - bar_height, BAR_WIDTH, bar_height)
            bar = self.figure.colorbar(look.bar.mappable, cax=axes, extend=look.bar.extend, ticks=look.bar.ticks)
            bar.outline.set_visible(False)
            bar.ax.tick_params(colors=PALE_INK, labelcolor=INK, labelsize=8, length=3, width=0.6)
            if look.bar.ticks:
                bar.ax.yaxis.set_major_formatter("{x:g}")
            else:
                bar.ax.ticklabel_format(axis="y", scilimits=(-3, 5), useMathText=True)
                bar.ax.yaxis.get_offset_text().set(fontsize=8, color=INK, ha="left", x=POWER / BAR_WIDTH)
            for place, text in zip((0.25, 0.75), look.bar.halves, strict=False):
                at = top - bar_height + place * bar_height
                self._text(left + 0.06, at, text, rotation=90, va="center", ha="center")
            top -= bar_height + 0.9 * LINE
        for name, colour in patches:
            self.figure.text(
                (left + 0.07) / self._total[0],
                top / self._total[1],
                "●",
                color=colour,
                fontsize=11,
                va="center",
                ha="center",
            )
            self._text(left + 0.22, top, plain(cut(name, LONGEST_NAME)), va="center")
            top -= LINE
        if look.edge:
            across, up = self._total
            ends = [(left + end) / across for end in (0.0, 0.15)]
            self.figure.add_artist(Line2D(ends, [top / up] * 2, color="white", linewidth=1.1, path_effects=[RIM]))
            self._text(left + 0.22, top, NAME, va="center")

    def _text(self, left: float, bottom: float, text: str, **style: Any) -> None:
        self.figure.text(
            left / self._total[0],
            bottom / self._total[1],
            text,
            **{"fontsize": 8.5, "color": INK, "va": "top", **style},
        )


def save(figure: Figure, output: Path) -> None:
    """Write a figure to a file, which appears when it is whole.

    Raises:
        InputError: the file may not be written.
        WarpsphError: the disk is full or broken.
    """
    with hidden_until_whole(output) as hidden:
        figure.savefig(hidden)


def time_text(time: float, last: float) -> str:
    """A time [s], with the unit and the digits that suit a run until ``last``."""
    unit, factor = next(
        ((unit, factor) for unit, factor in (("s", 1.0), ("ms", 1e3)) if factor * last >= 0.5), ("µs", 1e6)
    )
    decimals = 0 if factor * last >= 1000 else 1 if factor * last >= 10 else 2
    return f"{factor * time:.{decimals}f} {unit}"
