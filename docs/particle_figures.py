"""Pictures of solids of particles, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from warpsph.core.labels import Phase
from warpsph.files.results import ResultFile
from warpsph.scenarios.bonded_solid.melting_block import MeltingBlock
from warpsph.scenarios.bonded_solid.particle_solid import FOOT

DOTS_PER_INCH = 150
VIEW = (-62.0, 38.0, -2.0, 24.0)  # of the block with its lamp [m]; what has flown farther is left out


def draw_ensemble(runs: list[ResultFile], picture: Path) -> None:
    """How many particles are fluid over time, and at the end, in runs that differ by next to nothing."""
    drawing, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
    for run in runs:
        left.plot(run.diagnostics["time"], run.diagnostics["fluid"], color="C0", lw=0.5, alpha=0.6)
    left.set(xlabel="time [s]", ylabel="particles that are fluid")
    final = [int(run.diagnostics["fluid"][-1]) for run in runs]
    right.hist(final, np.arange(29.5, 47.0), color="C0", rwidth=0.85)
    right.axvline(46, color="k", lw=1.0, ls="--", label="the paper: 46 of 46")
    right.set(xlabel="particles that are fluid at step 50 000", ylabel="starts", xticks=range(30, 47, 2))
    right.legend(frameon=False, loc="upper left")
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def draw_block(result: ResultFile, times: list[float], picture: Path) -> None:
    """Solid and fluid, and the mean kinetic energy since the start, with the lamp as a star."""
    case = MeltingBlock(**{name: v for name, v in result.parameters.items() if name in MeltingBlock.model_fields})
    drawing, axes = plt.subplots(len(times), 2, figsize=(13, 1.95 * len(times)), sharex=True, layout="constrained")
    for (phases, energies), time in zip(axes, times, strict=True):
        k = result.nearest(time)
        place, fields = result.frame(k)
        fluid = fields["phase"] == Phase.LIQUID
        phases.plot(*place[~fluid, :2].T, ".", ms=1.6, mew=0, color="#31527b", label="solid")
        phases.plot(*place[fluid, :2].T, ".", ms=3.0, mew=0, color="#e8730c", label="fluid")
        energy = np.maximum(fields["mean_energy"], 1e-3)
        shown = energies.scatter(*place[:, :2].T, s=1.6, lw=0, c=energy, cmap="inferno", norm=LogNorm(1e-3, 1e2))
        phases.set(ylabel="y [m]", title=f"{result.times[k]:.1f} s")
        for panel in (phases, energies):
            panel.plot(*(FOOT * np.array(case.lamp_place)), "*", ms=11, mfc="#f2c84b", mec="k", mew=0.6)
            panel.set(xlim=VIEW[:2], ylim=VIEW[2:], aspect="equal")
    axes[0, 0].legend(frameon=False, loc="upper right", markerscale=4, ncols=2)
    drawing.colorbar(shown, ax=axes[:, 1], label="mean kinetic energy since the start [J]", shrink=0.7)
    for panel in axes[-1]:
        panel.set_xlabel("x [m]")
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)
