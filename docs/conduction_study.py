"""Measure what the integrators of conduction make of long steps and what they cost, and write the tables of the manual.

``make study`` runs everything anew; the tables, and the same numbers for plots, go to ``docs/tables``. The case is the
plate of Rook, Yildiz & Dost (2007), section 4.1; their figure 9 is about the cost. All on one thread of a CPU.
"""

import csv
import sys
from collections.abc import Iterator
from pathlib import Path
from time import process_time

import numpy as np

from warpsph.core.executor import Executor
from warpsph.scenarios import PlateFixed
from warpsph.scenarios.conduction.plate import DENSITY, rms
from warpsph.scenarios.conduction.time_stepping import Stepping

TABLES = Path(__file__).parent / "tables"
EXPLICIT = {"integrator": Stepping.EXPLICIT}
EULER, CRANK_NICOLSON = {"integrator": Stepping.BACKWARD_EULER}, {"integrator": Stepping.CRANK_NICOLSON}
PUBLISHED, STABLE = 0.15, 0.37  # explicit steps in rho c h^2 / k: equation (12), and what the lattice bears

IN_A_SECOND = {  # numbers of steps
    "explicit": (EXPLICIT, (104, 50, 41, 40)),
    "backward Euler": (EULER, (104, 50, 20, 10, 5, 4, 2, 1)),
    "Crank-Nicolson": (CRANK_NICOLSON, (104, 50, 20, 10, 5, 4, 2, 1)),
    "Crank-Nicolson, undamped": (CRANK_NICOLSON | {"damped_steps": 0}, (104, 50, 20, 10, 5, 4, 2, 1)),
}
REFERENCE = 16 * 104  # steps in a second, by Crank-Nicolson
TIMES = (1.0, 8.0)  # [s]
SOLVED = 1e-9  # tolerance with which the steps alone decide on the error

DURATION = 8.0  # [s], of the study of the cost
ENOUGH = 0.01  # RMS error at the end over RMS of T - T_edge
ACROSS = (20, 28, 40, 56, 80, 160, 400)
SHARES = (STABLE, 0.25, PUBLISHED)  # of explicit steps, the first that is exact enough counts
TRIED = [
    CRANK_NICOLSON | {"damped_steps": damped, "tolerance": tolerance, "steps": steps}
    for steps in (16, 10, 8, 6)
    for damped in (2, 1)
    for tolerance in (1e-3, 1e-2)
] + [EULER | {"damped_steps": 0, "tolerance": 1e-2, "steps": 160}]
WIDELY = (
    6_400  # particles up to which everything is tried, thrice, and the least time counts; then the best three, once
)
WHOLE = 30_000  # particles up to which explicit runs are measured from begin to end
SOME_STEPS = 300  # of those with more

Row = dict[str, str | float]


class Plate:
    """A plate led by its steps alone: a case would refuse explicit ones that are too long."""

    def __init__(self, executor: Executor, step: float, **changes):
        self.case = PlateFixed(step=step, **changes)
        self.executor, self.simulation = executor, self.case.build(executor)
        solver = self.simulation.solver
        solver.set_steps(step, step)
        solver.prepare()
        self._step = executor.record(solver.step_with_heat)

    def advance(self, count: int) -> float:
        """Go on by ``count`` steps; return the processor time that they took [s]."""
        begun = process_time()
        self.executor.replay([(self._step, count)])
        return process_time() - begun

    def precise(self) -> np.ndarray:
        """Temperature (n,) [K], but for a constant, with what single precision has lost."""
        state, case = self.simulation.state, self.case
        enthalpy = state.numpy("enthalpy").astype(float) - state.numpy("enthalpy_carry")
        return enthalpy * case.diffusivity * DENSITY / case.conductivity

    def errors(self, time: float) -> tuple[float, float]:
        """Root mean square error against the series [K], and that over the root mean square of T - T_edge."""
        now = self.simulation.snapshot()
        error = rms(self.case.errors(now["position"], now["temperature"].astype(float), time))
        return error, error / rms(self.case.exact.temperature(now["position"], time) - self.case.edge)


def study_steps(executor: Executor) -> Iterator[Row]:
    """Errors against the series, and of the steps alone, for each integrator and step."""

    def run(in_a_second: int, **changes) -> Iterator[tuple[float, float, np.ndarray]]:
        plate, done = Plate(executor, 1.0 / in_a_second, tolerance=SOLVED, **changes), 0
        for time in TIMES:
            plate.advance(round(time * in_a_second) - done)
            done = round(time * in_a_second)
            yield *plate.errors(time), plate.precise()

    exactly = [precise for _, _, precise in run(REFERENCE, **CRANK_NICOLSON)]
    for name, (changes, counts) in IN_A_SECOND.items():
        for count in counts:
            row: Row = {"integrator": name, "step": 1.0 / count}
            for time, steps_taken, found in zip(TIMES, exactly, run(count, **changes), strict=True):
                row[f"error {time:g}"], row[f"relative {time:g}"] = found[:2]
                row[f"step {time:g}"] = rms(found[2] - steps_taken)
            yield row


def study_cost(executor: Executor) -> Iterator[Row]:
    """Processor time to be exact enough, by explicit steps and the best implicit way, with more and more particles."""
    ways = TRIED
    for across in ACROSS:
        explicit = next(
            row for share in SHARES if not (row := explicit_cost(executor, across, share))["error"] > ENOUGH
        )
        found = [(way | measured(executor, across, way["steps"], way), way) for way in ways]
        good = sorted((pair for pair in found if pair[0]["error"] <= ENOUGH), key=lambda pair: pair[0]["time"])
        if across**2 >= WIDELY:
            ways = [way for _, way in good[:3]]
        best = good[0][0]
        yield explicit | {f"implicit {name}": value for name, value in best.items()}


def explicit_cost(executor: Executor, across: int, share: float) -> Row:
    """Explicit steps of ``share`` rho c h^2 / k; where only some are done their error is not known."""
    case = PlateFixed(across=across)
    steps = int(np.ceil(DURATION * case.diffusivity / (share * case.spacing**2)))
    row = {"particles": across**2, "share": share, "steps": steps, "done": steps if across**2 <= WHOLE else SOME_STEPS}
    return row | measured(executor, across, steps, EXPLICIT, row["done"])


def measured(executor: Executor, across: int, steps: int, way: Row, done: int | None = None) -> Row:
    """Processor time [s] of all ``steps``, from that of those ``done``, and the error over T - T_edge."""
    changes = {name: value for name, value in way.items() if name != "steps"}
    times = []
    for _ in range(3 if across**2 <= WIDELY else 1):
        plate = Plate(executor, DURATION / steps, across=across, **changes)
        times.append(plate.advance(done or steps) * steps / (done or steps))
    error = plate.errors(DURATION)[1] if done in (None, steps) else np.nan
    print(f"{across**2} particles, {steps} steps, {changes}: {min(times):.3g} s, {error:.2%}", file=sys.stderr)
    return {"time": min(times), "error": error}


def table_of_steps(rows: list[dict]) -> list[list[str]]:
    """What stands in the manual about the steps, the heads first."""
    times = [f"{time:g}" for time in TIMES]
    lines = [["integrator", "step", "over (12)"]]
    lines[0] += [f"error, {time} s" for time in times] + [f"over $T - T_e$, {time} s" for time in times]
    lines[0] += [f"of the steps alone, {time} s" for time in times]
    longest = PUBLISHED * PlateFixed().spacing ** 2 / PlateFixed().diffusivity
    for row in rows:
        line = [row["integrator"], f"{short(1e3 * row['step'], 3)} ms", short(row["step"] / longest)]
        line += [f"{short(row[f'error {time}'])} K" for time in times]
        line += [f"{short(100.0 * row[f'relative {time}'])} %" for time in times]
        lines.append([*line, *(f"{short(row[f'step {time}'])} K" for time in times)])
    return lines


def table_of_cost(rows: list[dict]) -> list[list[str]]:
    """What stands in the manual about the cost, the heads first."""
    lines = [["particles", "explicit steps", "their time", "their error", "time by (12)", "implicit way", "steps"]]
    lines[0] += ["damped", "tolerance", "time", "error", "explicit over implicit", "(12) over implicit"]
    for row in rows:
        published = row["time"] * row["share"] / PUBLISHED
        error = f"{short(100.0 * row['error'])} %" if row["done"] == row["steps"] else "not found"
        line = [f"{row['particles']:.0f}", f"{row['steps']:.0f}", f"{short(row['time'])} s", error]
        line += [f"{short(published)} s", f"`{row['implicit integrator']}`"]
        line += [f"{row[f'implicit {name}']:g}" for name in ("steps", "damped_steps", "tolerance")]
        line += [f"{short(row['implicit time'])} s", f"{short(100.0 * row['implicit error'])} %"]
        lines.append([*line, *(short(time / row["implicit time"]) for time in (row["time"], published))])
    return lines


def short(number: float, digits: int = 2) -> str:
    """A number with so many digits that count."""
    return np.format_float_positional(number, precision=digits, fractional=False, trim="-")


STUDIES = {"steps": (study_steps, table_of_steps), "cost": (study_cost, table_of_cost)}


def main(names: list[str]) -> None:
    """Write the tables named, or both, and their numbers."""
    TABLES.mkdir(exist_ok=True)
    for name in names or STUDIES:
        study, table = STUDIES[name]
        rows = []
        for row in study(Executor("cpu", 1)):
            print(", ".join(f"{key} {value}" for key, value in row.items()), file=sys.stderr)
            rows.append(row)
        path = TABLES / f"conduction-{name}"
        with path.with_suffix(".csv").open("w", newline="") as file:
            writer = csv.DictWriter(file, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
        heads, *lines = (f"| {' | '.join(line)} |" for line in table(rows))
        path.with_suffix(".md").write_text("\n".join([heads, "|---" * heads.count(" | ") + "|---|", *lines, ""]))
        print(f"written: docs/tables/{path.name}.md")


if __name__ == "__main__":
    main(sys.argv[1:])
