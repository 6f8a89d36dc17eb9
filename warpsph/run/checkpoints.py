"""The checkpoints of a run: what is written to them, and what must be true to go on from one."""

from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from warpsph.core.registry import Registry
from warpsph.errors import InputError, WarpsphError
from warpsph.files.checkpoint import SUFFIX, Checkpoint, as_path, beside, previous
from warpsph.files.output import ResultWriter
from warpsph.run.schedule import Schedule
from warpsph.run.timestep import StepPlan


class Checkpoints:
    """Writes the checkpoints of one run.

    Args:
        path: where the newest one goes.
        registry: all that changes in the run.
        facts: what stays the same: of :func:`identity`, the parameters of the case, and when the run began.
        writer: the result file, or None.
    """

    def __init__(self, path: Path, registry: Registry, facts: dict[str, Any], writer: ResultWriter | None):
        self.path, self.registry, self.facts, self.writer = path, registry, facts, writer
        self._newest: float | None = None

    def write(self, schedule: Schedule, wall_time: float) -> None:
        """Write what is true now; ``wall_time`` is the run's so far [s].

        Raises:
            WarpsphError: it cannot be written; the checkpoint before stays.
        """
        try:
            self._write(schedule, wall_time)
        except InputError as error:  # a folder that has gone or been closed since the start is no wrong input
            raise WarpsphError(str(error)) from None

    def _write(self, schedule: Schedule, wall_time: float) -> None:
        facts = self.facts | {
            "written": datetime.now(UTC).isoformat(timespec="seconds"),
            "wall_time": wall_time,
            "time": float(schedule.time),
            "begin": float(schedule.begin),
            "output_interval": float(schedule.output_interval),
            "cycles": schedule.whole_cycles,
            "result": self.writer.counts() if self.writer else {},
        }
        Checkpoint(facts, self.registry.save()).write(self.path)
        self._newest = schedule.time

    def newest(self) -> dict[str, str]:
        """Where the newest checkpoint of this run is, for people; nothing where there is none."""
        return {} if self._newest is None else {"last checkpoint": f"{self.path}, at {self._newest:.6g} s"}


def place_of_checkpoints(given: str | Path | None, every: float | None, output: str | Path | None) -> Path | None:
    """Where the checkpoints of a run go: to the file ``given``, else beside its ``output``; None without both.

    Raises:
        InputError: none could be written there, which must not come to light at the end only.
    """
    if given is None:
        if output is None and every is not None:
            raise InputError("checkpoint_every: say where checkpoints go: give checkpoint, or output")
        if not isinstance(output, str | Path) or not Path(output).name:
            return None
        path = beside(Path(output))
    else:
        path = as_path("checkpoint", given)
        if path.suffix != SUFFIX:  # a result, say, which the next checkpoints would replace
            raise InputError(f"checkpoint = {path}: give a name that ends in {SUFFIX}")
        if not path.parent.is_dir():
            raise InputError(f"{path}: there is no folder {path.parent}; make it first")
    _refuse_no_file(path)
    _refuse_no_file(previous(path))
    return path


def _refuse_no_file(place: Path) -> None:
    if place.exists() and not place.is_file():
        raise InputError(f"{place}: is no ordinary file, and checkpoints go there; move it, or choose another name")


def identity(on_cuda: bool) -> dict[str, Any]:
    """What must be the same for a run to go on with the same bits: versions, and the kind of device."""
    return {
        "warpsph": version("warpsph"),
        "warp": version("warp-lang"),
        "kind of device": "cuda" if on_cuda else "cpu",
    }


def refuse_foreign(checkpoint: Checkpoint, on_cuda: bool) -> None:
    """Refuse a checkpoint of another version or of another kind of device.

    Raises:
        InputError: it says which.
    """
    for name, here in identity(on_cuda).items():
        there = checkpoint.facts[name]
        if there != here:
            remedy = (
                f"give --device {there}" if name == "kind of device" else f"install {name} {there} to go on with it"
            )
            raise InputError(f"the checkpoint is of {name} {there}, this is {here}; {remedy}")


def continued_schedule(
    checkpoint: Checkpoint, plan: StepPlan, duration: float, output_interval: float, every: float | None
) -> Schedule:
    """The schedule of the run that was checkpointed, at its place in it; one that begins there for another interval.

    A run that was killed between its last checkpoint and its end has no step left.

    Raises:
        InputError: the checkpoint is beyond the end of the run.
    """
    facts = checkpoint.facts
    run_begin, time = facts["run_begin"], facts["time"]
    end = run_begin + duration
    anew = output_interval != facts["output_interval"]
    too_short = InputError(
        f"duration = {duration:g}: the checkpoint is at {time:g} s already; give a longer one (--until)"
    )
    if not run_begin <= time <= end or (anew and time == end):
        raise too_short
    begin, cycles = (time, 0) if anew else (facts["begin"], facts["cycles"])
    schedule = Schedule(plan, begin, duration + (run_begin - begin), output_interval, every, done=cycles)
    if schedule.done and time < end:
        raise too_short
    if not abs(schedule.time - time) <= 1e-9 * max(abs(begin), abs(schedule.end)):
        raise InputError(
            f"the checkpoint is at {time:g} s after {cycles} cycles, where this run is at {schedule.time:g} s: it is "
            "of something else"
        )
    return schedule
