"""Calibrate the breakout, first the mould and then the failure: ``python -m warpsph.scenarios.breakout.calibration``.

The mould's conductance is the smallest that by one-dimensional conduction leaves a shell of enough layers, and with
which the control run, all sprays on, keeps its shell for the whole time. Then the sprays fail early once, which
measures how long the shell lasts without them; the failure is set so that the hole comes at the published time.
"""

import sys
from pathlib import Path

import numpy as np

from warpsph.cases.case import preset_layer, resolve
from warpsph.cli.consoles import error_console
from warpsph.cli.progress import shown_progress
from warpsph.files.beside import hidden_until_whole
from warpsph.run.result import Result
from warpsph.scenarios.breakout.breakout import PUBLISHED_HOLE, Breakout, openings
from warpsph.scenarios.breakout.reckoning import LAYERS, remelting_delay, thinnest_shell

CONDUCTANCES = np.arange(1300.0, 2001.0, 100.0)  # the usual range of moulds [W/(m^2 K)]
TRIAL_FAILURE = 2.0  # [s]
RESULTS = Path("results")


def run(case: Breakout, title: str) -> Result:
    """Simulate with a progress bar, keep the result file, and print what happened."""
    RESULTS.mkdir(exist_ok=True)
    output = RESULTS / f"breakout-{1e3 * case.spacing:.3g}mm-{title.replace(' ', '-')}.vtkhdf"
    with shown_progress(title, error_console()) as progress:
        result = case.run(progress=progress, output=output, overwrite=True, parameters=case.as_dict())
    events = "; ".join(f"{time:.2f} s {text}" for time, text in result.events) or "nothing happened"
    print(f"{title}: {events} ({output})", flush=True)
    return result


def choose_conductance(case: Breakout) -> Breakout:
    """The case with the smallest conductance that holds the strand."""
    for conductance in CONDUCTANCES:
        held = case.model_copy(update={"mould_conductance": float(conductance), "spray_failing": ()})
        thinnest = thinnest_shell(held)
        print(f"{conductance:.0f} W/(m^2 K): thinnest shell {1e3 * thinnest:.1f} mm by 1-D conduction", flush=True)
        if thinnest < LAYERS * case.spacing:
            continue
        if not openings(run(held, f"control {conductance:.0f}")):
            return case.model_copy(update={"mould_conductance": float(conductance)})
    sys.exit("no conductance of the usual range holds the strand: pour less hot, or give more water")


def choose_failure(case: Breakout) -> Breakout:
    """The case with the time of failure that makes the hole come at the published time."""
    print(f"remelting without water, by 1-D conduction: {remelting_delay(case):.1f} s", flush=True)
    opened = openings(run(case.model_copy(update={"spray_failure": TRIAL_FAILURE}), "failure early"))
    hole = next((time for time, _ in opened), None)
    if hole is None:
        sys.exit("the shell bears the failure: pour hotter")
    failure = round(PUBLISHED_HOLE - (hole - TRIAL_FAILURE), 1)
    print(f"the shell lasts {hole - TRIAL_FAILURE:.2f} s without water: sprays fail at {failure} s")
    return case.model_copy(update={"spray_failure": failure})


def main(presets: list[str]) -> None:
    """Calibrate the presets named, or all, and write what was found into their files."""
    for preset in presets or Breakout.presets:
        case = choose_failure(choose_conductance(resolve(Breakout, [preset_layer(Breakout, preset)])))
        run(case, "failure set")
        path = Path(__file__).parent / "presets" / "breakout" / f"{preset}.toml"
        with hidden_until_whole(path) as hidden:
            hidden.write_text(
                f"# {1e3 * case.spacing:g} mm spacing; the last two lines are what the calibration found.\n"
                f"spacing = {case.spacing:g}\n"
                f"mould_conductance = {case.mould_conductance:.1f}\n"
                f"spray_failure = {case.spray_failure}\n"
            )
        print(f"written: {path.name}")


if __name__ == "__main__":
    main(sys.argv[1:])
