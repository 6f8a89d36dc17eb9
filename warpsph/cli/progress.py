"""The progress of a run on standard error: a bar on a terminal, a plain line every few seconds elsewhere."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import timedelta

from rich.console import Console
from rich.progress import BarColumn, SpinnerColumn, TaskProgressColumn, TextColumn
from rich.progress import Progress as Bars

from warpsph.run.progress import Progress, Report

PLAIN_INTERVAL = 5.0  # s between two lines


@contextmanager
def shown_progress(title: str, console: Console) -> Iterator[Report]:
    """Yield a function that shows a :class:`warpsph.run.progress.Progress`."""
    if console.is_terminal:
        with _bars(console) as bars:
            task = bars.add_task(title, total=None, status="preparing; the first run compiles its kernels")
            yield lambda progress: bars.update(
                task, total=progress.duration, completed=progress.time, status=_status(progress)
            )
    else:
        yield _plain_lines(title, console)


def _bars(console: Console) -> Bars:
    columns = [TextColumn("{task.description}"), BarColumn(bar_width=24), TaskProgressColumn()]
    return Bars(SpinnerColumn(), *columns, TextColumn("{task.fields[status]}"), console=console)


def _plain_lines(title: str, console: Console) -> Report:
    next_line = time.monotonic()

    def report(progress: Progress) -> None:
        nonlocal next_line
        if time.monotonic() < next_line and progress.time < progress.duration:
            return
        next_line = time.monotonic() + PLAIN_INTERVAL
        share = progress.time / progress.duration
        console.print(f"{title} {share:4.0%}  {_status(progress)}", markup=False, soft_wrap=True)

    return report


def _status(progress: Progress) -> str:
    left = timedelta(seconds=round(progress.seconds_left)) if progress.seconds_left < 1e8 else "?"
    parts = [
        f"{progress.time:.3f}/{progress.duration:g} s",
        f"{progress.steps_per_second:.0f} steps/s",
        f"{left} left",
        progress.note,
    ]
    return "  ".join(part for part in parts if part)
