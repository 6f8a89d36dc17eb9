"""``warpsph info``."""

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from rich.table import Table
from rich.text import Text

from warpsph.cli.consoles import output_console
from warpsph.cli.describe import show_value
from warpsph.errors import cut
from warpsph.files.results import ResultFile

MOST_EVENTS = 500
LONGEST_VALUE = 1000  # letters


def info(file: Path, /) -> None:
    """Tell what made a result file: parameters, versions, device and wall time, and what it holds.

    Parameters
    ----------
    file
        A VTKHDF file written by `warpsph run`.
    """
    result = ResultFile(file)
    last = {name: result.diagnostics[name][-1] for name in result.quantities if len(result.diagnostics[name])}
    events = [(f"{time:.4g} s", text) for time, text in result.events[:MOST_EVENTS]]
    if len(result.events) > MOST_EVENTS:
        events.append(("", f"and {len(result.events) - MOST_EVENTS} more events"))
    console = output_console()
    sections = {
        "Parameters": result.parameters.items(),
        "Provenance": result.provenance.items(),
        "Frames": _frames(result),
        "Diagnostics at the end": last.items(),
        "Events": events,
    }
    for title, rows in sections.items():
        if rows:
            console.print(_section(title, rows))


def _frames(result: ResultFile) -> list[tuple[str, object]]:
    if len(result.times) == 0:
        return [("frames", 0)]
    points, fields = result.frame(-1)
    span = f"{len(result.times)}, from {result.times[0]:.4g} to {result.times[-1]:.4g} s"
    return [("frames", span), ("particles in the last", len(points)), ("fields", ", ".join(fields))]


def _section(title: str, rows: Iterable[tuple[str, object]]) -> Table:
    table = Table(title=title, title_justify="left", show_header=False, box=None, padding=(0, 2))
    table.add_column(style="cyan", no_wrap=True)
    table.add_column()
    for name, value in rows:
        table.add_row(Text(name), Text(_show(value)))
    return table


def _show(value: object) -> str:
    if isinstance(value, np.ndarray) and value.size > 1:
        return f"{value.size} values from {value.min():.6g} to {value.max():.6g}"
    return cut(show_value(value), LONGEST_VALUE)
