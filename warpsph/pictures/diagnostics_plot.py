"""All diagnostics of a run over time, as small multiples."""

from itertools import cycle, product
from pathlib import Path
from textwrap import fill, wrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure

from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.pictures.drawing import check_output
from warpsph.pictures.palette import colour_map
from warpsph.pictures.panels import panels_of
from warpsph.pictures.scales import LARGEST
from warpsph.pictures.sheet import INK, PALE_INK, STILL_SUFFIXES, save
from warpsph.pictures.units import plain, title_of

COLOURS = ("#c93a0a", "#2c5f8f", "#35b8a9", "#8a5a9e")
STYLES = ("-", "--", ":", "-.")  # for every further round of the colours
PANEL_WIDTH, PANEL_HEIGHT = 3.5, 1.9  # inches
DOTS_PER_INCH = 160
TITLE_LETTERS = 46  # in a line
NOTES = 8  # events that are told below the panels
MOST_PANELS, MOST_CURVES, MOST_MARKS = 30, 16, 200  # panels; curves in one of them; lines for events
MOST_COLUMNS, MOST_ROWS = 2000, 1000  # of a map, more than there are pixels
NOTE_SIZE, NOTE_LINE = 8, 0.16  # points; inches
NOTE_LETTERS = 52  # in a line, for each column of panels


def plot_diagnostics(result: ResultFile, output: Path) -> None:
    """Draw each number as a curve and each array as a map, with units and a shared time axis.

    What belongs together, and over what an array is given, is read from the file.

    Args:
        result: the run.
        output: the picture; its suffix is one of ``STILL_SUFFIXES``.

    Raises:
        InputError: unknown format or folder, or a file without diagnostics.
    """
    output = Path(output)
    check_output(output, STILL_SUFFIXES)
    all_panels = panels_of(result)
    if not all_panels or not np.any(np.isfinite(result.diagnostics["time"])):
        raise InputError(f"{result.path}: holds no diagnostics to plot")
    panels = all_panels[:MOST_PANELS]
    columns = min(len(panels), 2 if len(panels) <= 6 else 3)
    rows = -(-len(panels) // columns)
    notes = _notes(result.events, columns)
    if len(all_panels) > MOST_PANELS:
        notes.append(f"and {len(all_panels) - MOST_PANELS} more diagnostics; `to_pandas` gives them all")
    height = PANEL_HEIGHT * rows + 0.4 + NOTE_LINE * len(notes)
    figure = Figure(figsize=(PANEL_WIDTH * columns, height), dpi=DOTS_PER_INCH, layout="constrained")
    grid = figure.subplots(rows, columns, sharex=True, squeeze=False)
    for place, axes in enumerate(grid.ravel()):
        if place >= len(panels):
            axes.remove()
            continue
        panel = panels[place]
        _dress(axes, panel.title)
        if result.diagnostics[panel.names[0]].ndim == 1:
            _draw_curves(axes, result, panel.names[:MOST_CURVES])
        else:
            _draw_map(axes, result, panel.names[0])
        for time, _ in result.events[:MOST_MARKS]:
            axes.axvline(time, color=PALE_INK, linewidth=0.8, linestyle=":")
        if place + columns >= len(panels):
            axes.set_xlabel("time [s]", fontsize=8, color=INK)
            axes.tick_params(labelbottom=True)
    if notes:
        figure.supxlabel("\n".join(notes), x=0.01, ha="left", fontsize=NOTE_SIZE, color=INK, linespacing=1.3)
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        # the power of ten beside the title, where it does not push the title up
        axes.set_title(axes.yaxis.get_major_formatter().get_offset(), loc="right", fontsize=8, color=INK)
    save(figure, output)


def _notes(events: list[tuple[float, str]], columns: int) -> list[str]:
    """Lines that tell the events, none wider than the panels."""
    told = [f"{time:.3g} s: {plain(text)}" for time, text in events[:NOTES]]
    if len(events) > NOTES:
        told.append(f"and {len(events) - NOTES} more events")
    return [line for text in told for line in wrap(text, NOTE_LETTERS * columns, subsequent_indent="    ")]


def _dress(axes: Axes, title: str) -> None:
    axes.set_title(fill(title, TITLE_LETTERS), loc="left", fontsize=9, color=INK)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color(PALE_INK)
    axes.tick_params(colors=PALE_INK, labelcolor=INK, labelsize=7.5, length=3, width=0.6)
    axes.locator_params(axis="x", nbins=6)


def _draw_curves(axes: Axes, result: ResultFile, names: list[str]) -> None:
    time = _drawable(result.diagnostics["time"])
    marker = "o" if len(time) < 3 else ""
    for (style, colour), name in zip(cycle(product(STYLES, COLOURS)), names, strict=False):
        label, values = plain(result.quantities[name].label), _drawable(result.diagnostics[name])
        axes.plot(time, values, label=label, color=colour, linestyle=style, linewidth=1.3, marker=marker)
    axes.grid(color="#e8eaed", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.ticklabel_format(axis="y", scilimits=(-3, 4), useMathText=True)
    axes.yaxis.get_offset_text().set_visible(False)
    if result.quantities[names[0]].panel:
        axes.legend(fontsize=7, frameon=False, labelcolor=INK, handlelength=1.2, loc="best")


def _draw_map(axes: Axes, result: ResultFile, name: str) -> None:
    label, up = _height_of(result, name)
    known = np.flatnonzero(np.isfinite(_drawable(result.diagnostics["time"])))
    some, part = _thinned(known, MOST_COLUMNS), _thinned(np.arange(len(up)), MOST_ROWS)
    time, up = result.diagnostics["time"][some], up[part]
    values = _drawable(result.diagnostics[name][some][:, part])
    colours = colour_map(result.quantities[name].colours)
    axes.set_ylabel(label, fontsize=8, color=INK)
    drawn: ScalarMappable
    if len(time) > 1 and len(up) > 1 and np.all(np.diff(time) > 0):
        drawn = axes.pcolormesh(time, up, values.T, cmap=colours, shading="nearest", rasterized=True)
    else:
        drawn = axes.imshow(values.T, aspect="auto", origin="lower", extent=(*_ends(time), *_ends(up)), cmap=colours)
    bar = axes.figure.colorbar(drawn, ax=axes, pad=0.02, fraction=0.06)
    bar.outline.set_visible(False)
    bar.ax.ticklabel_format(axis="y", scilimits=(-3, 4), useMathText=True)
    bar.ax.yaxis.get_offset_text().set_visible(False)
    bar.ax.tick_params(colors=PALE_INK, labelcolor=INK, labelsize=7.5, length=2, width=0.6)


def _drawable(values: np.ndarray) -> np.ndarray:
    """Values without those that are too large for an axis."""
    return np.where(np.abs(values) <= LARGEST, values, np.nan)


def _thinned(places: np.ndarray, most: int) -> np.ndarray:
    """Every so many of some places (n,), so that few more than ``most`` are left."""
    return places[:: max(len(places) // most, 1)]


def _height_of(result: ResultFile, name: str) -> tuple[str, np.ndarray]:
    """Label and values (m,) of the axis over which an array (T, m) is given: those of another one, or its index."""
    over, count = result.quantities[name].over, result.diagnostics[name].shape[1]
    places = result.diagnostics.get(over, np.empty(0))
    if places.ndim == 2 and places.shape[1] == count and _rises(places[-1]):
        return title_of(result.quantities[over]), places[-1]
    return "index", np.arange(count)


def _rises(places: np.ndarray) -> bool:
    return bool(np.all(np.isfinite(_drawable(places))) and np.all(np.diff(places) > 0))


def _ends(places: np.ndarray) -> tuple[float, float]:
    """Ends of an axis whose cells stand around ``places``."""
    half = 0.5 * (places[-1] - places[0]) / max(len(places) - 1, 1) or 0.5
    return places[0] - half, places[-1] + half
