"""Pictures of the cases that freeze, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from warpsph.core.labels import Phase
from warpsph.files.results import ResultFile
from warpsph.scenarios.freezing.point_sink import TABLE, PointSink
from warpsph.scenarios.freezing.stefan_slab import StefanSlab

DOTS_PER_INCH = 150
HOURS = 3600.0  # [s]
KINDS = {"published": "C1", "default": "C0"}


def draw_stefan(runs: dict[str, ResultFile], unequal: dict[str, ResultFile], picture: Path) -> None:
    """Figures 1 to 3 of the paper, with the default beside them, and the same with unequal phases."""
    drawing, axes = plt.subplots(1, 4, figsize=(14, 3.8), layout="constrained")
    for panel, results, title in ((axes[0], runs, "equal phases"), (axes[3], unequal, "unequal phases")):
        for kind, result in results.items():
            y, fields = _column(result)
            panel.plot(y, fields["temperature"], "o", ms=4, mfc="none", color=KINDS[kind], label=kind)
        case = _case(StefanSlab, results["published"])
        y = np.linspace(0.0, 1.0, 400)
        panel.plot(y, case.exact.temperature(y, results["published"].times[-1]), "k-", lw=0.8, label="exact")
        panel.set(xlabel="y [m]", ylabel="temperature [K]", title=title, xlim=(0.0, 0.8))
        panel.legend(frameon=False)
    for kind, result in runs.items():
        y, fields = _column(result)
        axes[1].plot(y, fields["solid_fraction"], "o", ms=4, mfc="none", color=KINDS[kind], label=kind)
    front = runs["published"].diagnostics["exact_front"][-1]
    axes[1].axvline(front, color="k", lw=0.8, label="exact front")
    axes[1].set(xlabel="y [m]", ylabel="heat lost at the melting point / latent heat", xlim=(0.0, 0.5))
    axes[1].legend(frameon=False)
    position, fields = runs["published"].frame(-1)
    _draw_phases(axes[2], position, fields["phase"], 4.0)
    axes[2].axhline(front, color="k", lw=0.8)
    axes[2].set(title="published", xlabel="x [m]", ylabel="y [m]")
    _save(drawing, picture)


def draw_sink(runs: list[tuple[str, ResultFile]], picture: Path) -> None:
    """Figures 4 to 7, 9 and 10 of the paper, a row for each run: particles, heat lost, temperature."""
    drawing, axes = plt.subplots(len(runs), 3, figsize=(12, 3.7 * len(runs)), layout="constrained")
    for (places, losses, warmth), (title, result) in zip(axes, runs, strict=True):
        case, (position, fields), time = _case(PointSink, result), result.frame(-1), result.times[-1]
        front, r = float(case.exact.front(time)), np.linalg.norm(position, axis=1)
        _draw_phases(places, position, fields["phase"], 2.5)
        places.add_patch(plt.Circle((0.0, 0.0), front, fill=False, color="k", lw=0.8))
        places.set(title=title, xlabel="x [m]", ylabel="y [m]", xlim=(-0.35, 0.35), ylim=(-0.35, 0.35))
        losses.plot(r, fields["solid_fraction"], "o", ms=3, mfc="none")
        losses.axvline(front, color="k", lw=0.8)
        losses.set(xlabel="r [m]", ylabel="heat lost / latent heat", xlim=(0.0, 0.4))
        warmth.plot(r, fields["temperature"] - 273.15, "o", ms=3, mfc="none", label="particles")
        grid = np.linspace(0.005, 0.4, 400)
        warmth.plot(grid, case.exact.temperature(grid, time) - 273.15, "k-", lw=0.8, label="exact")
        warmth.set(
            xlabel="r [m]", ylabel="temperature [°C]", xlim=(0.0, 0.4), ylim=(-40.0 * case.similarity / 0.15, 12.0)
        )
        warmth.legend(frameon=False, loc="lower right")
    _save(drawing, picture)


def draw_sink_radius(published: dict[int, ResultFile], default: dict[int, ResultFile], picture: Path) -> None:
    """Figure 8 of the paper: the radius over time; and the errors of its table 1 against the spacing."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    for k, n in enumerate((20, 30, 40)):
        series = published[n].diagnostics
        there = series["radius_of_ice"] > 0.0
        left.plot(
            series["time"][there] / HOURS,
            series["radius_of_ice"][there],
            ".",
            ms=4,
            color=f"C{k}",
            label=f"published, {n}",
        )
    series = default[40].diagnostics
    left.plot(series["time"] / HOURS, series["radius"], "-", color="C3", label="default, 40: by what has frozen")
    left.plot(series["time"] / HOURS, series["exact_radius"], "k--", lw=0.8, label="exact")
    left.set(xlabel="time [h]", ylabel="radius [m]")
    left.legend(frameon=False, loc="lower right")
    h = 1.0 / (np.array(list(TABLE)) - 1)
    table = np.array(list(TABLE.values()))
    for column, (name, label) in enumerate((("radius_of_ice", "farthest ice"), ("radius_of_loss", "farthest loss"))):
        found = [_case(PointSink, published[n]).radius_errors(published[n])[name] for n in TABLE]
        right.loglog(h, found, "os"[column] + "-", color="C1", mfc="none", label=f"published method: {label}")
        right.loglog(h, table[:, column], "os"[column], color="k", label=f"table 1: {label}")
    found = [_case(PointSink, default[n]).radius_errors(default[n])["radius"] for n in TABLE]
    right.loglog(h, found, "D-", color="C0", label="default: by what has frozen")
    right.set(
        xlabel="spacing [m]", ylabel="RMS error of the radius [m]", xticks=h, xticklabels=[f"1/{n - 1}" for n in TABLE]
    )
    right.minorticks_off()
    right.legend(frameon=False, fontsize="small")
    _save(drawing, picture)


def draw_cavity(result: ResultFile, times: list[float], shares: dict[str, ResultFile], picture: Path) -> None:
    """Figure 11 of the paper at three times, and the share that has frozen with two spacings and two methods."""
    drawing, axes = plt.subplots(1, len(times) + 1, figsize=(14, 3.4), layout="constrained")
    case = result.parameters
    for panel, time in zip(axes, times, strict=False):
        k = result.nearest(time)
        position, fields = result.frame(k)
        _draw_phases(panel, position, fields["phase"], 3.0)
        panel.plot([-case["sink_x"], case["sink_x"]], [case["sink_y"]] * 2, "k+", ms=9, mew=2)
        panel.set(title=f"{result.times[k] / HOURS:.0f} h", xlabel="x [m]", ylabel="y [m]")
    for style, (label, run) in zip(("-", "--", ":"), shares.items(), strict=False):
        axes[-1].plot(run.diagnostics["time"] / HOURS, run.diagnostics["frozen"], style, label=label)
    axes[-1].set(xlabel="time [h]", ylabel="share that has frozen", ylim=(0.0, 1.0))
    axes[-1].legend(frameon=False, loc="lower right")
    _save(drawing, picture)


def _case(kind, result: ResultFile):
    """The scenario that made a result."""
    return kind(**{name: value for name, value in result.parameters.items() if name in kind.model_fields})


def _column(result: ResultFile) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Heights and fields of one column of particles at the end."""
    position, fields = result.frame(-1)
    one = position[:, 0] < position[:, 0].min() + 1e-6
    return position[one, 1], {name: values[one] for name, values in fields.items()}


def _draw_phases(panel: Axes, position: np.ndarray, phase: np.ndarray, size: float) -> None:
    """Ice as open circles, the rest as filled squares."""
    ice = phase == Phase.SOLID
    panel.plot(*position[~ice, :2].T, "s", ms=0.7 * size, color="C0")
    panel.plot(*position[ice, :2].T, "o", ms=size, mfc="none", mec="C3", mew=0.6)
    panel.set_aspect("equal")


def _save(drawing: Figure, picture: Path) -> None:
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)
