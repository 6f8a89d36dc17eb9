"""Pictures of natural convection, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from warpsph.core.labels import Role
from warpsph.files.results import ResultFile
from warpsph.scenarios.flow.natural_convection import DE_VAHL_DAVIS, NaturalConvection, fitted

POINTS, ARROWS = 81, 14  # along an edge, for isotherms and for arrows
ISOTHERMS = np.linspace(-0.5, 0.5, 11)


def draw_convection(runs: dict[NaturalConvection, ResultFile], picture: Path) -> None:
    """Isotherms and arrows at the end of each run, and below them the Nusselt number against time."""
    drawing = plt.figure(figsize=(10, 6.6), layout="constrained")
    grid = drawing.add_gridspec(2, len(runs), height_ratios=(1.0, 0.75))
    below = drawing.add_subplot(grid[1, :])
    for number, (case, result) in enumerate(runs.items()):
        _draw_box(drawing.add_subplot(grid[0, number]), case, result)
        time = result.diagnostics["time"] * case.diffusivity / case.length**2
        below.plot(time, result.diagnostics["nusselt"], f"C{number}", label=f"Ra = {case.rayleigh:g}")
        below.axhline(DE_VAHL_DAVIS[case.rayleigh][0], color=f"C{number}", ls="--", lw=0.8)
    below.set(xlabel="time over $L^2/\\kappa$", ylabel="Nusselt number", xlim=(0.0, 0.3), ylim=(0.0, 12.0))
    below.legend(frameon=False, ncols=len(runs))
    drawing.savefig(picture, dpi=120)
    plt.close(drawing)


def _draw_box(panel: Axes, case: NaturalConvection, result: ResultFile) -> None:
    x, fields = result.frame(-1)
    air = fields["role"] == Role.FREE
    x, L = x[air, :2].astype(float), case.length
    warmer = (fields["temperature"][air].astype(float) - case.mean) / case.difference
    velocity = fields["velocity"][air].astype(float)
    panel.scatter(*(x.T / L), c=warmer, cmap="inferno", s=1.5e4 / len(x), marker="s", linewidths=0, alpha=0.6)
    line = np.linspace(0.0, L, POINTS)
    places = np.stack(np.meshgrid(line, line), axis=-1)
    smooth = fitted(x, warmer, places.reshape(-1, 2), case.spacing).reshape(POINTS, POINTS)
    panel.contour(line / L, line / L, smooth, ISOTHERMS, colors="k", linewidths=0.8, linestyles="-")
    between = (np.arange(ARROWS) + 0.5) / ARROWS * L
    places = np.stack(np.meshgrid(between, between), axis=-1).reshape(-1, 2)
    u, v = (fitted(x, velocity[:, axis], places, case.spacing) for axis in (0, 1))
    panel.quiver(*(places.T / L), u, v, color="C0", pivot="mid", width=0.006)
    panel.set(
        xlim=(0.0, 1.0),
        ylim=(0.0, 1.0),
        aspect="equal",
        xticks=(),
        yticks=(),
        title=f"Ra = {case.rayleigh:g}, {100.0 * L:.1f} cm",
    )
