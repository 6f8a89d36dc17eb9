"""Pictures of flows between walls that slide or rest, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from warpsph.cli.catalogue import find_scenario
from warpsph.files.results import ResultFile
from warpsph.scenarios.flow.cavity_flow import published_profile
from warpsph.scenarios.flow.channel import FOURIERS

DOTS_PER_INCH = 150


def draw_channels(results: dict[str, ResultFile], picture: Path) -> None:
    """Velocity between two plates at five times, a panel a run: particles over the series."""
    drawing, axes = plt.subplots(1, len(results), figsize=(3.2 * len(results) + 1.0, 3.8), layout="constrained")
    for panel, (title, result) in zip(axes, results.items(), strict=True):
        case = _case(result)
        series, y = result.diagnostics, np.linspace(0.0, 1.0, 201)
        for colour, fourier in enumerate(FOURIERS):
            time = fourier * case.height**2 / case.kinematic_viscosity
            frame = int(np.argmin(np.abs(series["time"] - time)))
            panel.plot(case.exact.velocity(y * case.height, time) / case.speed, y, "k-", lw=0.7)
            label = f"{fourier:g}"
            panel.plot(series["velocity"][frame], series["place"][frame], "o", ms=4, color=f"C{colour}", label=label)
        panel.set(xlabel="u / U", ylabel="y / H", ylim=(0.0, 1.0), title=title)
    axes[-1].legend(title=r"$\nu t/H^2$", frameon=False, loc="center left", bbox_to_anchor=(1.0, 0.5))
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def draw_cavity_flow(results: dict[int, ResultFile], picture: Path) -> None:
    """Velocity on the vertical and on the horizontal centre line, by Reynolds number: lines over published points."""
    drawing, axes = plt.subplots(1, 2, figsize=(9.0, 4.0), layout="constrained")
    for panel, name, title in zip(axes, "uv", ("vertical centre line", "horizontal centre line"), strict=True):
        for colour, (reynolds, result) in enumerate(results.items()):
            series, (place, published) = result.diagnostics, published_profile(name, reynolds)
            panel.plot(series["place"][-1], series[name][-1], "-", color=f"C{colour}", label=f"Re {reynolds}, warpsph")
            label = f"Re {reynolds}, Ghia, Ghia & Shin (1982)"
            panel.plot(place, published, "o", ms=4, mfc="none", color=f"C{colour}", label=label)
        panel.set(xlabel="y / L" if name == "u" else "x / L", ylabel=f"{name} / U", title=title, xlim=(0.0, 1.0))
    axes[0].legend(frameon=False, fontsize=8)
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def _case(result: ResultFile):
    """The scenario that made a result."""
    kind = find_scenario(result.parameters["scenario"])
    return kind(**{name: value for name, value in result.parameters.items() if name in kind.model_fields})
