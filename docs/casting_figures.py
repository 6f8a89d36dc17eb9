"""Pictures of the casting machine's experiments, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke

from warpsph.cases.case import preset_layer, resolve
from warpsph.files.results import ResultFile
from warpsph.scenarios.breakout.breakout import HOLE, OUTFLOW, THINS, Breakout
from warpsph.scenarios.casting.casting import Casting
from warpsph.scenarios.casting.experiments import INLETS, mean_shell, whole_cycles

DOTS_PER_INCH = 150
PHASES = 20  # of a cycle of the mould
EVENT_NAMES = {"sprays fail": "sprays fail", THINS: "shell thins", HOLE: "hole", OUTFLOW: "melt runs out"}


def draw_inlets(results: list[ResultFile], picture: Path) -> None:
    """The thickness of the shell against height for ports at three heights."""
    drawing, axes = plt.subplots(figsize=(6, 5.5), layout="constrained")
    for k, (preset, result) in enumerate(zip(INLETS, results, strict=True)):
        case = resolve(Casting, [preset_layer(Casting, preset)])
        heights = result.diagnostics["height"][0]
        label = f"{preset.split('_')[1]}, {case.nozzle_mouth:g} m"
        axes.plot(1e3 * mean_shell(result.diagnostics), heights, "o-", ms=4, color=f"C{k}", label=label)
        axes.axhline(case.nozzle_mouth, color=f"C{k}", ls=":", lw=1)
    axes.axhline(case.mould_bottom, color="0.7", lw=1)
    axes.annotate("mould ends", (0.98, case.mould_bottom), xycoords=("axes fraction", "data"), ha="right", va="bottom")
    axes.set(xlabel="shell thickness [mm]", ylabel="height [m]", ylim=(0.0, case.level), xlim=(-0.5, None))
    axes.legend(frameon=False, title="ports at", loc="lower left")
    _save(drawing, picture)


def draw_oscillation(result: ResultFile, picture: Path) -> None:
    """Velocities of mould and shell, and the level, over a cycle: the mean of all whole cycles after the start."""
    case = resolve(Casting, [preset_layer(Casting, "oscillation")])
    d = whole_cycles(result.diagnostics, case)
    phase = np.floor(PHASES * ((d["time"] * case.mould_frequency) % 1.0) + 1e-9).astype(int) % PHASES
    times = (np.arange(PHASES) + 0.5) / PHASES / case.mould_frequency

    def folded(values: np.ndarray) -> np.ndarray:
        trend = np.polyval(np.polyfit(d["time"], values, 1), d["time"]) - values.mean()
        return np.bincount(phase, values - trend, PHASES) / np.bincount(phase, minlength=PHASES)

    mould, shell = (1e3 * folded(d[name]) for name in ("mould_velocity", "shell_velocity"))
    drawing, (upper, lower) = plt.subplots(2, 1, figsize=(8, 5), sharex=True, layout="constrained")
    upper.plot(times, mould, label="mould")
    upper.plot(times, shell, label="skin of the shell")
    upper.fill_between(times, mould, shell, where=mould < shell, color="0.85", label="negative strip", interpolate=True)
    upper.axhline(-1e3 * case.casting_speed, color="0.7", lw=1, ls=":")
    upper.set(ylabel="velocity [mm/s]")
    upper.legend(frameon=False, ncols=3, loc="upper center")
    for name in ("level", "meniscus"):
        values = folded(d[name])
        lower.plot(times, 1e3 * (values - values.mean()), label=name)
    lower.set(xlabel="time since the mould passed its middle upwards [s]", ylabel="height less its mean [mm]")
    lower.legend(frameon=False, ncols=2)
    _save(drawing, picture)


def draw_breakout_shell(failed: ResultFile, control: ResultFile, case: Breakout, picture: Path) -> None:
    """Thickness of the shell over height and time, with the moments that the program noted, beside the control run."""
    drawing, axes = plt.subplots(1, 2, figsize=(10, 4.5), sharey=True, layout="constrained")
    for panel, result, title in zip(axes, (control, failed), ("all sprays on", "sprays failed"), strict=True):
        d = result.diagnostics
        image = panel.pcolormesh(
            d["time"], d["height"][0], 1e3 * d["shell_thickness"].T, cmap="viridis", vmin=0, vmax=24, shading="nearest"
        )
        panel.axhline(case.mould_bottom, color="w", lw=1)
        panel.set(title=title, xlabel="time [s]", xlim=(0, d["time"][-1]))
        _label_events(panel, result.events, case.level)
    axes[0].set(ylabel="height [m]")
    drawing.colorbar(image, label="shell thickness [mm]")
    _save(drawing, picture)


def _label_events(panel: Axes, events: list[tuple[float, str]], top: float) -> None:
    """Lines at the moments of a breakout, each name at a height of its own, so that none lies over another."""
    moments = [(time, name) for time, text in events for word, name in EVENT_NAMES.items() if word in text]
    for k, (time, name) in enumerate(moments):
        panel.axvline(time, color="w", lw=1, ls="--")
        side, name = ("left", f" {name}") if time < 0.3 * panel.get_xlim()[1] else ("right", f"{name} ")
        label = panel.text(time, (0.95 - 0.06 * k) * top, name, color="w", ha=side, va="center", fontsize=10)
        label.set_path_effects([withStroke(linewidth=2, foreground="#26292e")])  # it may stand on white


def event_times(result: ResultFile) -> list[float]:
    """Times [s] of thinning, hole and outflow."""
    return [next(time for time, text in result.events if word in text) for word in (THINS, HOLE, OUTFLOW)]


def _save(drawing, picture: Path) -> None:
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)
