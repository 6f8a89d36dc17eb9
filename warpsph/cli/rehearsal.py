"""``warpsph run --dry-run``: what a run would take, and a picture of its start."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from rich.table import Table
from rich.text import Text

from warpsph.cases.scenario import Scenario
from warpsph.cli.consoles import error_console, output_console
from warpsph.cli.target import check_free

if TYPE_CHECKING:  # not at run time: Warp takes long to import, and help must appear at once
    from warpsph.run.estimate import Estimate
    from warpsph.run.schedule import Schedule
    from warpsph.run.simulation import Simulation


def rehearse(scenario: Scenario, device: str, threads: int | None, path: Path, overwrite: bool) -> None:
    """Build a case, say what its run would take, and draw its start; no result is written.

    Args:
        scenario: the case.
        device, threads: where it would run.
        path: the result file of the run; the picture stands beside it.
        overwrite: whether the picture may be replaced.

    Raises:
        InputError: the case cannot be run, or would take too long; the picture exists or cannot be drawn.
    """
    from warpsph.core.executor import Executor

    picture = path.with_name(f"{path.stem}-start.png")
    check_free(picture, overwrite)
    executor = Executor(device, threads)
    with error_console().status("building the case; the first time compiles its kernels"):
        simulation = scenario.build(executor)
        schedule = simulation.schedule(scenario.duration, scenario.output_interval)
        simulation.refuse_too_long(schedule, path)
        estimate = simulation.estimate(schedule)
        with TemporaryDirectory() as folder:
            start = Path(folder) / path.name
            simulation.write_start(schedule, start, scenario.as_dict())
            _draw(start, picture)
        table = _table(_rows(simulation, schedule, estimate, simulation.measure(schedule)))
    console = output_console()
    console.print(table)
    console.print(Text(f"written: {picture}"), soft_wrap=True)


def _draw(start: Path, picture: Path) -> None:
    from warpsph.files.results import ResultFile
    from warpsph.pictures import render_still

    picture.parent.mkdir(exist_ok=True)
    render_still(ResultFile(start), picture)


def _table(rows: Iterable[tuple[str, str]]) -> Table:
    table = Table.grid(padding=(0, 2))
    for quantity, value in rows:
        table.add_row(Text(quantity, style="bold"), Text(value))
    return table


def _rows(
    simulation: "Simulation", schedule: "Schedule", estimate: "Estimate", seconds: float
) -> Iterator[tuple[str, str]]:
    from warpsph.core.capacity import in_bytes
    from warpsph.run.estimate import in_time
    from warpsph.run.timestep import listed

    roles = ", ".join(f"{count} {role}" for role, count in estimate.particles.items())
    yield "particles", f"{sum(estimate.particles.values())}: {roles}"
    yield "memory", in_bytes(estimate.memory)
    limits = listed(simulation.plan.limits)
    yield "time step", f"{estimate.dt:.3g} s" + (f"; limits: {limits}" if limits else "")
    yield "steps", f"{estimate.steps} for {schedule.duration:g} s"
    yield "wall time", f"about {in_time(seconds)} on {simulation.executor.description}, by a few steps measured now"
    yield "disk", f"{in_bytes(estimate.disk)} in {estimate.frames} frames"
