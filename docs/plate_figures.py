"""Pictures of the plates that cool, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.contour import ContourSet
from matplotlib.lines import Line2D

from warpsph.files.results import ResultFile
from warpsph.scenarios.conduction.plate import CoolingPlate

DOTS_PER_INCH = 120
CELSIUS = 273.15
FINE = 201  # points of the series along an edge
LOOKS = {
    "cold edges": "C0o-",
    "cold edges, published": "C0o--",
    "films": "C1s-",
    "films, gradient on one side": "C1s:",
    "films, published": "C1s--",
}


def draw_isotherms(runs: dict[str, tuple[CoolingPlate, ResultFile]], times: list[float], levels, picture: Path) -> None:
    """Figures 4, 5 and 8 of the source, a row for each run: isotherms of the particles over those of the series."""
    drawing, axes = plt.subplots(
        len(runs), len(times), figsize=(3.2 * len(times), 3.3 * len(runs)), layout="constrained", squeeze=False
    )
    for row, (title, (case, result)) in zip(axes, runs.items(), strict=True):
        for panel, time in zip(row, times, strict=True):
            lines = _draw_panel(panel, case, result, result.nearest(time), levels)
            if panel is not row[0]:  # there they stand too close
                panel.clabel(lines, levels[::2], fontsize=7)
            panel.set_title(f"{title}, {time:g} s", fontsize=10)
        row[0].set_ylabel("y [cm]")
    for panel in axes[-1]:
        panel.set_xlabel("x [cm]")
    lines = [Line2D([], [], color="0.45", lw=2.5), Line2D([], [], color="C3", ls="--", lw=1.2)]
    drawing.legend(lines, ["exact series", "particles"], loc="outside lower center", ncols=2, frameon=False)
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def draw_errors(runs: dict[str, ResultFile], counts: list[int], orders: dict[str, list[float]], picture: Path) -> None:
    """Root mean square error over time, and against the ``counts`` of particles across."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    for label, result in runs.items():
        series = result.diagnostics
        left.semilogy(series["time"][1:], series["rms_error"][1:], LOOKS[label], ms=2, label=label)
    left.set(xlabel="time [s]", ylabel="RMS error [K]", ylim=(5e-4, 2.0))
    left.legend(frameon=False, fontsize=8, ncols=2, loc="lower center")
    for label, errors in orders.items():
        right.loglog(counts, errors, LOOKS[label], ms=4, label=label)
    finer = counts[0] / np.array(counts)
    right.loglog(counts, 0.6 * finer**2, "k--", lw=0.8, label="second order")
    right.loglog(counts, 1.8 * finer, "k:", lw=0.8, label="first order")
    right.set(xlabel="particles across", ylabel="RMS error at 1 s [K]", xticks=counts, xticklabels=map(str, counts))
    right.minorticks_off()
    right.legend(frameon=False, fontsize=8)
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def _draw_panel(panel: Axes, case: CoolingPlate, result: ResultFile, frame: int, levels) -> ContourSet:
    """Isotherms [°C] at ``levels``: those of the series, and over them those of the particles, which are returned."""
    x, y = np.linspace(0.0, case.length, FINE), np.linspace(0.0, case.height, FINE)
    grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    exact = case.exact.temperature(grid, result.times[frame]).reshape(FINE, FINE)
    panel.contour(1e2 * x, 1e2 * y, exact.T - CELSIUS, levels, colors="0.45", linewidths=2.5)
    position, fields = result.frame(frame)
    order = np.lexsort((position[:, 1], position[:, 0]))
    shape = (case.across, -1)
    column, row, temperature = (
        values[order].reshape(shape) for values in (position[:, 0], position[:, 1], fields["temperature"])
    )
    panel.set(aspect="equal", xlim=(0.0, 1e2 * case.length), ylim=(0.0, 1e2 * case.height))
    return panel.contour(
        1e2 * column, 1e2 * row, temperature - CELSIUS, levels, colors="C3", linewidths=1.2, linestyles="dashed"
    )
