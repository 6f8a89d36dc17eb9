"""Pictures of flow without walls, for ``docs/figures.py``: vortices that decay, and a patch that stretches."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from warpsph.files.results import ResultFile
from warpsph.scenarios.flow.free_patch import FreePatch
from warpsph.scenarios.flow.taylor_green import TaylorGreen

DOTS_PER_INCH = 150
NAMES = {
    "corrected": "corrected",
    "delta": "classic delta-SPH",
    "summed": "published, summed density",
    "continuity": "published, continuity",
}


def draw_vortices(
    formulations: Mapping[str, ResultFile], refined: Mapping[str, Mapping[int, ResultFile]], picture: Path
) -> None:
    """The vortices at the end, the decay by each formulation, and the error of the rate over the rows."""
    case, result = TaylorGreen(), formulations["corrected"]
    drawing, (flow, decay, error) = plt.subplots(1, 3, figsize=(13, 4.2), layout="constrained")
    place, fields = result.frame(-1)
    speed = np.linalg.norm(fields["velocity"], axis=1)
    shown = flow.scatter(*place[:, :2].T, c=speed, s=16, lw=0, cmap="viridis")
    some = np.random.default_rng(0).permutation(len(place))[::6]
    flow.quiver(*place[some, :2].T, *fields["velocity"][some, :2].T, color="k", width=4e-3, scale=7.0)
    flow.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title=f"{result.times[-1]:g} s, {case.rows} rows")
    drawing.colorbar(shown, ax=flow, label="speed [m/s]", shrink=0.8)
    time = result.diagnostics["time"]
    decay.plot(time, result.diagnostics["exact_amplitude"], "k-", lw=1, label="exact")
    for name, run in formulations.items():
        decay.plot(run.diagnostics["time"], run.diagnostics["amplitude"], "o", ms=3.5, label=NAMES[name])
    decay.set(xlabel="time [s]", ylabel="amplitude of the vortices", ylim=(0.0, 1.05))
    decay.legend(frameon=False, loc="upper right")
    for label, runs in refined.items():
        error.plot(list(runs), [1e2 * _excess(run) for run in runs.values()], "o-", label=label)
    error.axhline(0.0, color="k", lw=0.8)
    rows = sorted({n for runs in refined.values() for n in runs})
    error.set(xscale="log", xlabel="rows", ylabel="error of the decay rate [%]", xticks=rows, xticklabels=rows)
    error.minorticks_off()
    error.legend(frameon=False)
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def draw_patch(formulations: Mapping[str, ResultFile], times: Sequence[float], picture: Path) -> None:
    """The patch at some times with its exact outline, its kinetic energy and its area by each formulation."""
    case, result = FreePatch(), formulations["corrected"]
    drawing, (patch, energy, area) = plt.subplots(1, 3, figsize=(13, 4.4), layout="constrained")
    angle = np.linspace(0.0, 2.0 * np.pi, 200)
    for k, (time, (a, b)) in enumerate(zip(times, case.exact.semi_axes(np.array(times)), strict=True)):
        place, fields = result.frame(result.nearest(time))
        down = -k * 2.1 * case.radius
        shown = patch.scatter(
            place[:, 0], place[:, 1] + down, c=fields["pressure"], s=3, lw=0, cmap="cividis", vmin=0.0, vmax=0.5
        )
        patch.plot(a * np.cos(angle), b * np.sin(angle) + down, "k-", lw=0.8)
        patch.annotate(f"{time:g} s", (-2.4, down + 0.7))
    patch.set(aspect="equal", xlim=(-2.5, 2.5), xlabel="x [m]", yticks=[])
    drawing.colorbar(shown, ax=patch, label="pressure [Pa]", shrink=0.7)
    for panel, quantity, title in ((energy, "kinetic_energy", "kinetic energy"), (area, "area", "area")):
        for name, run in formulations.items():
            values = run.diagnostics[quantity] / run.diagnostics[quantity][0]
            panel.plot(run.diagnostics["time"], 1e2 * (values - 1.0), label=NAMES[name])
        panel.axhline(0.0, color="k", lw=0.8)
        panel.set(xlabel="time [s]", ylabel=f"change of the {title} [%]", ylim=(-6.0, 6.0))
    energy.legend(frameon=False, loc="upper left")
    drawing.savefig(picture, dpi=DOTS_PER_INCH)
    plt.close(drawing)


def _excess(result: ResultFile) -> float:
    """Decay rate over the exact one, less 1."""
    series = result.diagnostics
    return float(np.log(series["amplitude"][-1]) / np.log(series["exact_amplitude"][-1])) - 1.0
