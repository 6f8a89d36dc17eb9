"""The ``warpsph`` command as a whole: its subcommands, and what becomes of an error or a warning."""

import logging
import signal
import sys
import warnings
from collections.abc import Callable, Sequence
from importlib.metadata import version
from typing import Any

from cyclopts import App, CycloptsError, Parameter

from warpsph.cli.consoles import complain, explain
from warpsph.cli.describe import describe
from warpsph.cli.info import info
from warpsph.cli.list_scenarios import list_scenarios
from warpsph.cli.plot import plot
from warpsph.cli.render import render
from warpsph.cli.run import run
from warpsph.cli.verify import verify
from warpsph.errors import DivergenceError, InputError, WarpsphError
from warpsph.files.beside import DISK_TROUBLE

application = App(
    name="warpsph",
    help="""Simulate solidification and the continuous casting of steel with particles.

    Begin with `warpsph list`, look at a case with `warpsph describe NAME`, run it with `warpsph run NAME`.

    Exit codes: 0 done, 1 a check failed or a file could not be written, 2 the input is wrong, 3 the simulation
    diverged, 128 + the number of the signal (130 for Ctrl-C) interrupted.""",
    help_format="markdown",
    default_parameter=Parameter(negative="", show_default=False),
    suppress_keyboard_interrupt=False,
    version=lambda: f"warpsph {version('warpsph')}",
)
application.command(list_scenarios, name="list", sort_key=0)
COMMANDS: tuple[Callable[..., Any], ...] = (describe, run, render, plot, verify, info)
for position, command in enumerate(COMMANDS, start=1):
    application.command(command, sort_key=position)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code.

    Args:
        arguments: the words after ``warpsph``; those of this process by default.
    """
    tokens = list(sys.argv[1:] if arguments is None else arguments)
    logging.getLogger("matplotlib").setLevel(logging.ERROR)  # it tells in two lines that it has no folder for its fonts
    with warnings.catch_warnings():
        warnings.showwarning = lambda message, *_, **__: complain(str(message))
        return _exit_code(tokens)


def _exit_code(tokens: list[str]) -> int:
    try:
        return application(tokens, exit_on_error=False, print_error=False, result_action="return_value") or 0
    except CycloptsError as error:
        complain(f"{error} (see {_help_command(tokens)})")
        return InputError.exit_code
    except WarpsphError as error:
        complain(str(error))
        if isinstance(error, DivergenceError):
            explain(error.facts)
        return error.exit_code
    except BrokenPipeError:
        return 1
    except OSError as error:
        where = f"{error.filename}" if error.filename else "a file or standard output"
        complain(f"{where}: cannot be read or written: {error.strerror or error}")
        return (WarpsphError if error.errno in DISK_TROUBLE else InputError).exit_code
    except KeyboardInterrupt as interruption:
        complain("interrupted")
        return 128 + getattr(interruption, "number", signal.SIGINT)


def _help_command(tokens: Sequence[str]) -> str:
    command = tokens[0] if tokens and tokens[0] in application else ""
    return f"warpsph {command} --help".replace("  ", " ")
