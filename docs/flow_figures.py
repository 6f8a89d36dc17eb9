"""What the figures of the calm flow draw."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from warpsph.core.labels import Role
from warpsph.core.model import GRAVITY
from warpsph.files.results import ResultFile
from warpsph.scenarios.flow.lobovsky import GAUGES, SENSORS, published_level, published_pressure
from warpsph.scenarios.flow.still_tank import StillTank


def draw_impact(result: ResultFile, moment: float, picture: Path) -> None:
    """Pressures at four heights of the end wall, and levels at four places, over time in units of ``moment`` [s]."""
    series = result.diagnostics
    time = series["time"] / moment
    drawing, axes = plt.subplots(2, 4, figsize=(13, 5.5), layout="constrained", sharey="row", sharex="row")
    for panel, (name, height) in zip(axes[0], SENSORS.items(), strict=True):
        panel.plot(time, series[name], lw=0.8)
        panel.plot(*published_pressure(name), "k", lw=1.0)
        panel.set(title=f"{1e3 * height:g} mm up the wall", xlim=(2.0, 7.1), ylim=(-0.2, 3.5))
    for panel, (name, place) in zip(axes[1], GAUGES.items(), strict=True):
        panel.plot(time, series[name], lw=0.8, label="warpsph")
        panel.plot(*published_level(name), "k", lw=1.0, label="experiment")
        panel.set(title=f"x = {place:g} m", xlim=(0.0, 7.1), ylim=(0.0, 1.1), xlabel=r"$t\sqrt{g/H}$")
    axes[0, 0].set(ylabel=r"$p/\rho g H$")
    axes[1, 0].set(ylabel="level / H")
    axes[1, 0].legend(frameon=False)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


def draw_scatter(case: StillTank, results: dict[str, ResultFile], picture: Path) -> None:
    """Pressure of each particle at the end over its height, for each formulation, and the exact line."""
    drawing, axes = plt.subplots(1, len(results), figsize=(8, 4.5), layout="constrained", sharey=True)
    load = case.density * GRAVITY * case.height
    for panel, (name, result) in zip(axes, results.items(), strict=True):
        position, fields = result.frame(-1)
        liquid = fields["role"] == Role.FREE
        panel.plot(fields["pressure"][liquid] / load, position[liquid, 1] / case.height, ".", ms=3)
        panel.plot([1.0, 0.0], [0.0, 1.0], "k", lw=0.8)
        panel.set(title=name, xlabel=r"$p/\rho g h$")
    axes[0].set(ylabel="y / h")
    axes[0].set_ylim(0.0, np.ceil(10.0 * axes[0].get_ylim()[1]) / 10.0)
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)
