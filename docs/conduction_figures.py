"""Pictures of the study of long steps, from the numbers that ``docs/conduction_study.py`` leaves."""

import csv
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

TABLES = Path(__file__).parent / "tables"
DOTS_PER_INCH = 120
LOOKS = {
    "explicit": "C0o-",
    "backward Euler": "C1s-",
    "Crank-Nicolson": "C2^-",
    "Crank-Nicolson, undamped": "C3v--",
}
LIMITS = {9.86e-3: "equation (12)", 24.4e-3: "unstable from here on"}  # [s], of explicit steps
PUBLISHED = 0.15  # rho c h^2 / k, equation (12)


def numbers(name: str) -> list[dict]:
    """The rows of a study; what is a number is one."""
    with (TABLES / f"conduction-{name}.csv").open() as file:
        return [{key: _number(value) for key, value in row.items()} for row in csv.DictReader(file)]


def draw_steps(picture: Path) -> None:
    """Errors over the step: against the series above, of the steps alone below, after 1 and 8 s."""
    rows = numbers("steps")
    drawing, axes = plt.subplots(2, 2, figsize=(9.0, 7.0), layout="constrained", sharex=True, sharey="row")
    for column, time in zip(axes.T, ("1", "8"), strict=True):
        for panel, what in zip(column, ("error", "step"), strict=True):
            for name, look in LOOKS.items():
                mine = [row for row in rows if row["integrator"] == name]
                step, error = (np.array([row[key] for row in mine]) for key in ("step", f"{what} {time}"))
                panel.loglog(1e3 * step, error, look, ms=4, label=name)
            for limit in LIMITS:
                panel.axvline(1e3 * limit, color="0.6", lw=0.8, ls=":")
        column[0].set(title=f"after {time} s", ylim=(3e-3, 30.0))
        column[1].set(xlabel="step [ms]", ylim=(3e-6, 30.0))
    for limit, text in LIMITS.items():
        axes[0, 0].annotate(text, (1e3 * limit, 25.0), rotation=90, va="top", ha="right", fontsize=7, color="0.4")
    _draw_slopes(axes[1, 1])
    axes[0, 0].xaxis.set_major_formatter("{x:g}")
    axes[0, 1].xaxis.set_major_formatter("{x:g}")
    axes[0, 0].set(ylabel="RMS error against the series [K]")
    axes[1, 0].set(ylabel="RMS error of the steps alone [K]")
    drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4, frameon=False)
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def draw_cost(picture: Path) -> None:
    """Figure 9 of the source: processor time over the number of particles."""
    rows = numbers("cost")
    particles, explicit, implicit, share = (
        np.array([row[key] for row in rows]) for key in ("particles", "time", "implicit time", "share")
    )
    whole = np.array([row["done"] == row["steps"] for row in rows])
    drawing, axes = plt.subplots(figsize=(6.5, 4.6), layout="constrained")
    for times, look, label in (
        (explicit * share / PUBLISHED, "C0o--", "explicit, steps of (12)"),
        (explicit, "C0o-", "explicit, longest stable steps"),
        (implicit, "C2^-", "implicit"),
    ):
        (line,) = axes.loglog(particles, times, look, ms=5, label=label)
        if label.startswith("explicit"):
            axes.loglog(particles[~whole], times[~whole], "o", ms=5, mfc="w", mec=line.get_color())
    even = crossing(particles, explicit / implicit)
    axes.axvline(even, color="0.6", lw=0.8, ls=":")
    axes.annotate(
        f"about {round(even, -2):.0f}",
        (even, axes.get_ylim()[0]),
        xytext=(4, 6),
        textcoords="offset points",
        color="0.4",
    )
    axes.set(xlabel="particles", ylabel="processor time to 8 s, at most 1 % off [s]")
    axes.legend(frameon=False)
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def crossing(particles: np.ndarray, factor: np.ndarray) -> float:
    """The number of particles from which the ``factor`` stays above 1, interpolated."""
    above = int(np.flatnonzero(factor < 1.0)[-1]) + 1
    both = slice(above - 1, above + 1)
    return float(np.exp(np.interp(0.0, np.log(factor[both]), np.log(particles[both]))))


def _draw_slopes(panel: Axes) -> None:
    """Lines of first and second order."""
    step = np.array([15.0, 150.0])
    for order, level, text in ((1, 0.15, "first order"), (2, 5e-6, "second order")):
        panel.loglog(step, level * (step / step[0]) ** order, "k-", lw=0.8)
        panel.annotate(text, (step[1], level * 10.0**order), xytext=(3, -3), textcoords="offset points", fontsize=8)


def _number(value: str) -> str | float:
    try:
        return float(value)
    except ValueError:
        return value
