"""Where the command line writes: results to standard output, progress and errors to standard error."""

import os
import sys

from rich.console import Console

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


def _console(stderr: bool) -> Console:
    stream = sys.stderr if stderr else sys.stdout
    width = None if stream.isatty() or "COLUMNS" in os.environ else PIPED_WIDTH
    return Console(stderr=stderr, width=width, highlight=False)
