"""Pictures of the crucible in which a crystal grows, for ``docs/figures.py``."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from warpsph.files.results import ResultFile
from warpsph.scenarios.crystal.crystal_growth import CrystalGrowth

COLOURS = {"quartz": "#c9d3dc", "germanium": "#5b7f9e", "solution": "#e8b04b", "silicon": "#7a6a8a"}
LABELS = {"germanium": "Ge substrate", "solution": "SiGe solution", "silicon": "Si source", "quartz": "quartz"}
MM = 1e3


def draw_crystal_growth(result: ResultFile, picture: Path) -> None:
    """Figures 10 to 12 of the paper: what stands where, and the isotherms of particles and of finite volumes."""
    values = {name: value for name, value in result.parameters.items() if name in CrystalGrowth.model_fields}
    case = CrystalGrowth(**values)
    position, fields = result.frame(-1)
    field = _on_lattice(case, position, fields["temperature"])
    reference = case.finite_volumes(float(result.times[-1]))
    drawing, (left, furnace, *axes) = plt.subplots(
        1, 5, figsize=(11.5, 6.8), sharey=True, layout="constrained", width_ratios=(1.0, 0.9, 1.0, 1.25, 1.25)
    )
    _draw_particles(left, case)
    _draw_furnace(furnace, case)
    x, y = (MM * case.spacing * (np.arange(n) + 0.5) for n in case.shape)
    levels = np.arange(1140.0, 1265.0, 5.0)
    for panel, shown, title in ((axes[0], field, "particles"), (axes[1], reference, "finite volumes")):
        colours = panel.pcolormesh(x, y, shown.T, cmap="inferno", vmin=1140.0, vmax=1260.0, shading="nearest")
        lines = panel.contour(x, y, shown.T, levels, colors="w", linewidths=0.7)
        panel.clabel(lines, levels[::4], fontsize=7, fmt="%.0f")
        panel.plot(
            x[: case.charge_columns], MM * case.interface(shown), color="c", lw=2.2, label=f"{case.melting_point:g} K"
        )
        panel.set(title=title)
    axes[0].legend(loc="upper center", bbox_to_anchor=(0.5, -0.09), fontsize=8, frameon=False)
    drawing.colorbar(colours, ax=axes[1], label="temperature [K]", shrink=0.6)
    difference = field - reference
    bound = float(np.abs(difference).max())
    colours = axes[2].pcolormesh(x, y, difference.T, cmap="RdBu_r", vmin=-bound, vmax=bound, shading="nearest")
    drawing.colorbar(colours, ax=axes[2], label="difference [K]", shrink=0.6)
    axes[2].set(title="difference")
    for panel in axes:
        _draw_edges(panel, case)
    for panel in (left, *axes):
        panel.set(xlabel="x [mm]", xlim=(0.0, MM * case.half_width), ylim=(0.0, MM * case.height), aspect="equal")
    left.set(ylabel="height [mm]")
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


def _on_lattice(case: CrystalGrowth, position: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Values of particles in any order, as (columns, rows)."""
    column, row = (position[:, :2] / case.spacing).astype(int).T
    field = np.empty(case.shape)
    field[column, row] = values
    return field


def _draw_particles(panel: Axes, case: CrystalGrowth) -> None:
    """The particles, in the colours of their materials."""
    points, names = case.points, case.material_at(case.points)
    for name, colour in COLOURS.items():
        panel.plot(*(MM * points[names == name, :2].T), "o", ms=2.2, mec="none", color=colour, label=LABELS[name])
    panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.09), fontsize=8, frameon=False, markerscale=2.5)
    panel.set(title=f"{len(points)} particles")


def _draw_furnace(panel: Axes, case: CrystalGrowth) -> None:
    """Temperature and conductance of the furnace beside the crucible, along the height."""
    height = np.linspace(0.0, case.height, 500)
    points = np.stack([0.0 * height, height, 0.0 * height], axis=1)
    panel.plot(case.furnace.at(points, 0.0), MM * height, color="C3")
    panel.set_xlabel("furnace [K]", color="C3")
    panel.tick_params(axis="x", colors="C3")
    conductance = panel.twiny()
    conductance.plot(case.film.at(points, 0.0), MM * height, color="C0", ls="--")
    conductance.set_xlim(0.0, 1.2 * max(case.side_conductance, case.insulated_conductance))
    conductance.set_xlabel("conductance [W/(m² K)]", color="C0")
    conductance.tick_params(axis="x", colors="C0")


def _draw_edges(panel: Axes, case: CrystalGrowth) -> None:
    """Lines between the materials."""
    inside = MM * case.charge_half_width
    bottom, top = MM * case.crucible_base, MM * case.height
    panel.plot([0.0, inside, inside], [bottom, bottom, top], color="k", lw=0.8)
    for height in (case.substrate_top, case.source_bottom):
        panel.plot([0.0, inside], [MM * height] * 2, color="k", lw=0.8)
