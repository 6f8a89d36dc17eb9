"""Draw the pictures of the manual anew: all of them, or those named on the command line (``make figures``).

A figure is a function here: its name with hyphens is the name of the picture under ``docs/figures``.
"""

import sys
from collections.abc import Callable
from pathlib import Path

from warpsph.case import preset_layer, resolve, settings_layer
from warpsph.cli.catalogue import find_scenario
from warpsph.cli.consoles import error_console
from warpsph.cli.progress import shown_progress
from warpsph.nearest import did_you_mean
from warpsph.pictures import render_still
from warpsph.results import ResultFile

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
