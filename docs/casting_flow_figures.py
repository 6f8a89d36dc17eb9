"""The casting machine on two formulations of the flow, side by side, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from warpsph.core.labels import Phase, Role
from warpsph.files.results import ResultFile
from warpsph.scenarios.casting.casting import Casting

PARTS = {"pressure": ("viridis", 1e-3, "pressure [kPa]", 10.0), "speed": ("magma", 1e3, "speed [mm/s]", 100.0)}


def draw_formulations(case: Casting, results: dict[str, ResultFile], picture: Path) -> None:
    """Pressure and speed of the steel in the last frame, pressure of each particle of melt over its height, and shell.

    Args:
        case: one of the runs.
        results: by the name of the formulation.
        picture: the file.
    """
    drawing, axes = plt.subplots(1, 2 * len(results) + 2, figsize=(12, 5.5), layout="constrained", sharey=True)
    for k, part in enumerate(PARTS):
        panels = axes[k * len(results) : (k + 1) * len(results)]
        _particles(drawing, panels, case, results, part)
    pressures, shells = axes[-2:]
    for name, result in results.items():
        position, pressure, _ = _steel(result, melt_only=True)
        pressures.plot(1e-3 * pressure, position[:, 1], ".", ms=1.5, label=name)
        series = result.diagnostics
        late = series["time"] > 2.0 / 3.0 * series["time"][-1]
        shells.plot(
            1e3 * np.nanmean(series["shell_thickness"][late], axis=0), series["height"][0], "o-", ms=3, label=name
        )
    pressures.set(xlabel="pressure of the melt [kPa]")
    shells.set(xlabel="shell, last third [mm]", xlim=(0.0, None))
    shells.axhline(case.mould_bottom, color="0.7", lw=1)
    shells.legend(frameon=False, loc="lower left")
    axes[0].set(ylabel="height [m]", ylim=(0.0, 1.05 * case.level))
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


def _particles(drawing: Figure, panels: np.ndarray, case: Casting, results: dict[str, ResultFile], part: str) -> None:
    """The steel of each result in a panel of its own, coloured by a part of :data:`PARTS`."""
    colours, scale, label, most = PARTS[part]
    shown = None
    for panel, (name, result) in zip(panels, results.items(), strict=True):
        position, pressure, speed = _steel(result)
        values = scale * (pressure if part == "pressure" else speed)
        size = (_points_of(drawing, case) * case.spacing) ** 2
        shown = panel.scatter(position[:, 0], position[:, 1], c=values, s=size, cmap=colours, vmin=0.0, vmax=most, lw=0)
        panel.set(
            title=name, aspect="equal", xlim=(0.0, case.half_width), xticks=[0.0, case.half_width], xlabel="x [m]"
        )
    drawing.colorbar(shown, ax=list(panels), label=label, location="bottom", shrink=0.8)


def _points_of(drawing: Figure, case: Casting) -> float:
    """Points of the page for a metre of the strand, about."""
    return 72.0 * 0.75 * float(drawing.get_size_inches()[1]) / case.level


def _steel(result: ResultFile, melt_only: bool = False) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Places (n, 3) [m], pressure [Pa] and speed [m/s] of the free steel in the last frame."""
    position, fields = result.frame(-1)
    steel = (fields["role"] == Role.FREE) & (fields["material"] == list(result.provenance["materials"]).index("steel"))
    if melt_only:
        steel &= fields["phase"] == Phase.LIQUID
    return position[steel], fields["pressure"][steel], np.linalg.norm(fields["velocity"][steel], axis=1)
