"""Draw the pictures of the manual anew: all of them, or those named on the command line (``make figures``).

A figure is a function here: its name with hyphens is the name of the picture under ``docs/figures``.
"""

import sys
from collections.abc import Callable
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np

from warpsph.case import preset_layer, resolve, settings_layer
from warpsph.cli.catalogue import find_scenario
from warpsph.cli.consoles import error_console
from warpsph.cli.progress import shown_progress
from warpsph.nearest import did_you_mean
from warpsph.pictures import plot_diagnostics, render_series, render_still
from warpsph.results import ResultFile
from warpsph.scenarios.travelling_slice import shell_thickness

matplotlib.use("Agg")

ROOT = Path(__file__).parents[1]
PICTURES = ROOT / "docs" / "figures"
RUNS = ROOT / "build" / "figures"

Figure = Callable[[Path], None]
figures: dict[str, Figure] = {}


def figure(draw: Figure) -> Figure:
    """Register a function that draws one picture to the path it is given."""
    figures[draw.__name__.replace("_", "-")] = draw
    return draw


def simulated(name: str, preset: str, *settings: str) -> ResultFile:
    """The result of a preset with ``KEY=VALUE`` settings; figures that ask for the same one share the run."""
    path = RUNS / f"{'-'.join([name, preset, *settings])}.vtkhdf"
    if path not in _finished:
        scenario = find_scenario(name)
        scenario = resolve(scenario, [preset_layer(scenario, preset), settings_layer(settings)])
        with shown_progress(path.stem, error_console()) as progress:
            scenario.run(output=path, overwrite=True, progress=progress, parameters=scenario.as_dict())
        _finished.add(path)
    return ResultFile(path)


_finished: set[Path] = set()


@figure
def casting_demo(picture: Path) -> None:
    """The strand of the demo at its end: the first picture of the README."""
    render_still(simulated("casting", "demo"), picture)


@figure
def casting_thesis(picture: Path) -> None:
    """The strand at four times, at the resolution of the thesis."""
    render_series(simulated("casting", "thesis"), picture, [0.0, 6.0, 12.0, 18.0])


@figure
def casting_diagnostics(picture: Path) -> None:
    """All diagnostics of the same run."""
    plot_diagnostics(simulated("casting", "thesis"), picture)


@figure
def casting_shell(picture: Path) -> None:
    """Thickness and surface temperature of the shell along the height, beside one-dimensional conduction."""
    result = simulated("casting", "thesis")
    case = resolve(find_scenario("casting"), [preset_layer(find_scenario("casting"), "thesis")])
    series = result.diagnostics
    heights, last_third = series["height"][0], series["time"] > 2.0 / 3.0 * series["time"][-1]
    profiles = case.slices(heights)
    exact = [shell_thickness(profile, case.steel, case.half_width, 0.5) for profile in profiles]
    drawing, (left, right) = plt.subplots(1, 2, figsize=(8, 5), sharey=True, layout="constrained")
    left.plot(1e3 * series["shell_thickness"][last_third].mean(axis=0), heights, "o-", label="warpsph")
    left.plot(1e3 * np.array(exact), heights, "k--", label="1-D, stagnant melt")
    left.set(xlabel="shell thickness [mm]", ylabel="height [m]")
    right.plot(np.nanmean(series["shell_surface_temperature"][last_third], axis=0), heights, "o-")
    right.plot(profiles[:, -1], heights, "k--")
    right.set(xlabel="surface temperature [K]")
    for axes in (left, right):
        axes.axhline(case.mould_bottom, color="0.7", lw=1)
        axes.axhline(case.nozzle_mouth, color="0.7", lw=1, ls=":")
    left.annotate("mould ends", (0.98, case.mould_bottom), xycoords=("axes fraction", "data"), ha="right", va="bottom")
    left.annotate("nozzle", (0.98, case.nozzle_mouth), xycoords=("axes fraction", "data"), ha="right", va="bottom")
    left.legend(frameon=False, loc="lower left")
    drawing.savefig(picture, dpi=150)
    plt.close(drawing)


def main(names: list[str]) -> str | None:
    """Draw the named figures, all of them if none is named; return what is wrong with the names."""
    for name in names:
        if name not in figures:
            return f"unknown figure '{name}'{did_you_mean(name, figures)}"
    for folder in (PICTURES, RUNS):
        folder.mkdir(parents=True, exist_ok=True)
    for name in names or figures:
        picture = PICTURES / f"{name}.png"
        figures[name](picture)
        print(f"drawn: {picture.relative_to(ROOT)}")
    return None


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
