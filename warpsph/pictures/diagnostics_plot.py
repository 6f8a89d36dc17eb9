"""All diagnostics of a run over time, as small multiples."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.pictures.drawing import check_output
from warpsph.pictures.quantities import DIAGNOSTICS, Quantity, quantity
from warpsph.pictures.sheet import INK, PALE_INK, STILL_SUFFIXES, save

# what is compared in one panel
TOGETHER = {
    "mass": ("mass_inside", "mass_in", "mass_out"),
    "enthalpy": ("enthalpy_inside", "enthalpy_in", "enthalpy_out"),
    "heat taken away": ("heat_mould", "heat_spray"),
    "heat": ("heat_fluid", "heat_wall"),
    "density": ("density_min", "density_max"),
    "particles": ("particles_inside", "particles_in", "particles_out"),
}
PER_METRE_OF_DEPTH = {"kg/m": "kg", "J/m": "J"}
COORDINATES = ("time", "height")
LINES = ("#c93a0a", "#2c5f8f", "#35b8a9", "#8a5a9e")
PANEL_WIDTH, PANEL_HEIGHT = 3.5, 1.9  # inches
DOTS_PER_INCH = 160


def plot_diagnostics(result: ResultFile, output: Path) -> None:
    """Draw each number as a curve, each array as a map over time and height, with units and a shared time axis.

    Args:
        result: the run.
        output: the picture; its suffix is one of ``STILL_SUFFIXES``.

    Raises:
        InputError: unknown format or folder, or a file without diagnostics.
    """
    output = Path(output)
    check_output(output, STILL_SUFFIXES)
    panels = _panels(result.diagnostics, result.provenance.get("dimension", 2))
    if not panels or len(result.diagnostics["time"]) == 0:
        raise InputError(f"{result.path}: holds no diagnostics to plot")
    columns = min(len(panels), 2 if len(panels) <= 6 else 3)
    rows = -(-len(panels) // columns)
    figure = Figure(figsize=(PANEL_WIDTH * columns, PANEL_HEIGHT * rows + 0.4), dpi=DOTS_PER_INCH, layout="constrained")
    grid = figure.subplots(rows, columns, sharex=True, squeeze=False)
    for place, axes in enumerate(grid.ravel()):
        if place >= len(panels):
            axes.remove()
            continue
        title, names = panels[place]
        _dress(axes, title)
        if result.diagnostics[names[0]].ndim == 1:
            _draw_curves(axes, result.diagnostics, names)
        else:
            _draw_map(axes, result.diagnostics, names[0])
        for time, _ in result.events:
            axes.axvline(time, color=PALE_INK, linewidth=0.8, linestyle=":")
        if place + columns >= len(panels):
            axes.set_xlabel("time [s]", fontsize=8, color=INK)
            axes.tick_params(labelbottom=True)
    if result.events:
        notes = "   ".join(f"{time:.3g} s: {text}" for time, text in result.events[:4])
        more = len(result.events) - 4
        figure.supxlabel(notes + (f"   and {more} more events" if more > 0 else ""), fontsize=7.5, color=PALE_INK)
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        # the power of ten beside the title, where it does not push the title up
        axes.set_title(axes.yaxis.get_major_formatter().get_offset(), loc="right", fontsize=8, color=INK)
    save(figure, output)


def _panels(diagnostics: dict[str, np.ndarray], dimension: int) -> list[tuple[str, list[str]]]:
    """Title and names of each panel: first the curves, then the maps."""
    group_of = {name: title for title, names in TOGETHER.items() for name in names}
    panels: dict[str, list[str]] = {}
    for name, series in sorted(diagnostics.items(), key=lambda item: (item[1].ndim, _rank(item[0]))):
        if name not in COORDINATES and series.ndim <= 2 and series.size:
            described = quantity(name, DIAGNOSTICS)
            unit = PER_METRE_OF_DEPTH.get(described.unit, described.unit) if dimension == 3 else described.unit
            panel = Quantity(group_of.get(name, described.label), unit)
            panels.setdefault(panel.title, []).append(name)
    return list(panels.items())


def _rank(name: str) -> tuple[int, str]:
    """Known names in the order of their table, then the others by name."""
    known = list(DIAGNOSTICS)
    return (known.index(name) if name in DIAGNOSTICS else len(known), name)


def _dress(axes: Axes, title: str) -> None:
    axes.set_title(title, loc="left", fontsize=9, color=INK)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color(PALE_INK)
    axes.tick_params(colors=PALE_INK, labelcolor=INK, labelsize=7.5, length=3, width=0.6)


def _draw_curves(axes: Axes, diagnostics: dict[str, np.ndarray], names: list[str]) -> None:
    marker = "o" if len(diagnostics["time"]) < 3 else ""
    for name, colour in zip(names, LINES, strict=False):
        label = quantity(name, DIAGNOSTICS).label
        axes.plot(diagnostics["time"], diagnostics[name], color=colour, linewidth=1.3, marker=marker, label=label)
    axes.grid(color="#e8eaed", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.ticklabel_format(axis="y", scilimits=(-3, 4), useMathText=True)
    axes.yaxis.get_offset_text().set_visible(False)
    if len(names) > 1:
        axes.legend(fontsize=7, frameon=False, labelcolor=INK, handlelength=1.2, loc="best")


def _draw_map(axes: Axes, diagnostics: dict[str, np.ndarray], name: str) -> None:
    time, values, height = diagnostics["time"], diagnostics[name], diagnostics.get("height")
    described = quantity(name, DIAGNOSTICS)
    has_height = height is not None and height.ndim == 2 and height.shape[1] == values.shape[1]
    up = height[-1] if has_height else np.arange(values.shape[1])
    if np.any(np.diff(time) <= 0) or np.any(np.diff(up) <= 0) or len(time) < 2 or len(up) < 2:
        axes.imshow(values.T, aspect="auto", origin="lower", extent=(time[0], time[-1] or 1.0, 0, values.shape[1]))
        return
    drawn = axes.pcolormesh(time, up, values.T, cmap=described.colours, shading="nearest", rasterized=True)
    axes.set_ylabel("height [m]" if has_height else "index", fontsize=8, color=INK)
    bar = axes.figure.colorbar(drawn, ax=axes, pad=0.02, fraction=0.06)
    bar.outline.set_visible(False)
    bar.ax.tick_params(colors=PALE_INK, labelcolor=INK, labelsize=7.5, length=2, width=0.6)
