"""Measure what the numerical parameters do to the column at rest and to the shell, and write the tables of the manual.

``make study`` runs everything anew; the tables go to ``docs/tables``. Source: Vijaykumar (2012), section 7.5.
"""

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from warpsph.cases.scenario import Scenario
from warpsph.cli.consoles import error_console
from warpsph.cli.progress import shown_progress
from warpsph.core.model import GRAVITY
from warpsph.errors import DivergenceError
from warpsph.run.result import Result
from warpsph.scenarios import Casting, Hydrostatic
from warpsph.scenarios.casting.experiments import lower_mould_shell

TABLES = Path(__file__).parent / "tables"
COLUMN = {"rows": 80, "columns": 40}
STRAND = {"duration": 3.0, "output_interval": 0.25}

COLUMN_STUDY = {
    "number of particles (rows)": [{"rows": rows, "columns": rows // 2} for rows in (40, 80, 160)],
    "support radius, H/dx": [{"support_ratio": ratio} for ratio in (2.0, 2.6, 3.0, 3.5, 4.0)],
    "speed of sound [m/s]": [{"sound_speed": speed} for speed in (10.0, 22.4, 45.0)],
    "viscosity [Pa s]": [{"viscosity": viscosity} for viscosity in (6.0, 60.0, 200.0, 600.0, 1800.0)],
    "time step over (7.6)": [{"step_factor": factor} for factor in (0.5, 1.0, 2.0, 4.0, 6.0, 8.0)],
}
STRAND_STUDY = {
    "spacing [m] (number of particles)": [{"spacing": spacing} for spacing in (0.004, 0.003)],
    "support radius, H/dx": [{"support_ratio": ratio} for ratio in (2.2, 2.6, 3.0, 3.5)],
    "speed of sound [m/s]": [{"sound_speed": speed} for speed in (7.0, 10.0, 14.0)],
    "viscosity [Pa s]": [{"viscosity": viscosity} for viscosity in (4.0, 6.0, 12.0, 30.0)],
    "time step over (7.6)": [{"step_factor": factor} for factor in (0.5, 1.0, 1.5, 2.0)],
}

Row = dict[str, str]


def column_row(case: Hydrostatic, result: Result) -> Row:
    """What the study asks of the column at rest."""
    d, exact = result.diagnostics, float(case.exact_pressure(0.0))
    return {
        "bottom pressure": f"{d['bottom_pressure'][-1] / exact - 1.0:+.2%}",
        "worst slice": f"{d['profile_error'][-1]:.2%}",
        "scatter": f"{d['pressure_scatter'][-1]:.2%}",
        "mean speed over √(gH₀)": f"{d['mean_speed'][-1] / np.sqrt(GRAVITY * case.height):.1e}",
    }


def strand_row(case: Casting, result: Result) -> Row:
    """What the study asks of the casting machine, over the second half of the run."""
    d = result.diagnostics
    late = d["time"] > 0.5 * d["time"][-1]
    return {
        "shell, lower half of the mould": f"{1e3 * lower_mould_shell(case, d):.2f} mm",
        "level": f"{np.mean(d['level'][late]):.4f} m",
        "highest density": f"{np.max(d['density_max'][late]) / case.density - 1.0:+.1%}",
        "highest speed": f"{np.max(d['highest_speed'][late]):.2f} m/s",
        "height without shell": f"{1e3 * np.max(d['hole_height']):.0f} mm",
    }


def study(
    kind: type[Scenario], base: dict, variations: dict[str, list[dict]], measure: Callable[[Scenario, Result], Row]
) -> str:
    """A Markdown table: each variation of each parameter, all others as in ``base``."""
    lines: list[str] = []
    measured: dict[str, Row] = {}
    for parameter, changes in variations.items():
        for change in changes:
            case = kind(**base | change)
            key = case.model_dump_json()
            if key not in measured:
                measured[key] = _measured(case, str(change), measure)
            row = measured[key]
            if not lines and len(row) > 1:
                lines += ["| parameter | value | " + " | ".join(row) + " |", "|---" * (len(row) + 2) + "|"]
            value = next(iter(change.values()))
            lines.append(f"| {parameter} | {value:g} | " + " | ".join(row.values()) + " |")
    return "\n".join(lines) + "\n"


def _measured(case: Scenario, title: str, measure: Callable[[Scenario, Result], Row]) -> Row:
    with shown_progress(f"{case.name} {title}", error_console()) as progress:
        try:
            result = case.run(progress=progress)
        except DivergenceError as error:
            return {"outcome": str(error).split(":")[0]}
    return measure(case, result) | {"steps": str(result.steps)}


def main(names: list[str]) -> None:
    """Write the tables named, or both."""
    TABLES.mkdir(exist_ok=True)
    for name in names or ("column", "strand"):
        if name == "column":
            table = study(Hydrostatic, COLUMN, COLUMN_STUDY, column_row)
        else:
            table = study(Casting, STRAND, STRAND_STUDY, strand_row)
        path = TABLES / f"parameter-study-{name}.md"
        path.write_text(table)
        print(f"written: docs/tables/{path.name}")


if __name__ == "__main__":
    main(sys.argv[1:])
