"""Where the command line writes: results to standard output, progress and errors to standard error."""

import os
import sys
from collections.abc import Mapping

from rich.console import Console
from rich.table import Table
from rich.text import Text

from warpsph.errors import LONGEST_MESSAGE, middle_cut, printable

PIPED_WIDTH = 160


def output_console() -> Console:
    """Standard output; wide where it is not a terminal, so that tables keep their rows on one line."""
    return _console(stderr=False)


def error_console() -> Console:
    """Standard error."""
    return _console(stderr=True)


def complain(message: str) -> None:
    """Write an error or a warning as one line."""
    line = middle_cut(printable(" ".join(message.split())), LONGEST_MESSAGE)
    style = "bold red" if error_console().is_terminal else None
    error_console().print("warpsph:", line, style=style, markup=False, highlight=False, emoji=False, soft_wrap=True)


def explain(facts: Mapping[str, str]) -> None:
    """Write what else is known of an error, a line each; on a terminal long ones are broken beside their names."""
    console, table = error_console(), Table.grid(padding=(0, 2))
    width = max((len(name) for name in facts), default=0)
    for name, text in facts.items():
        line = " ".join(text.split())
        table.add_row(Text(f"  {name}", style="bold"), Text(line))
        if not console.is_terminal:
            console.print(Text(f"  {name:{width}}  {line}"), soft_wrap=True)
    if facts and console.is_terminal:
        console.print(table)


def _console(stderr: bool) -> Console:
    stream = sys.stderr if stderr else sys.stdout
    width = None if stream.isatty() or "COLUMNS" in os.environ else PIPED_WIDTH
    return Console(stderr=stderr, width=width, highlight=False)
