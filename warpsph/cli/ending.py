"""How a signal ends the command while no run is going on: with one line, at once, and without a trace of Python's."""

import contextlib
import os
import signal
import sys
from types import FrameType

from warpsph.run.interrupt import SIGNALS

SHOW_CURSOR = b"\x1b[?25h"  # which a progress bar has hidden


def end_at_once_when_asked() -> None:
    """Handle the signals that are not ignored from now on; a run puts its own handling in the place of this one."""
    for number in SIGNALS:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _end)


def _end(number: int, frame: FrameType | None) -> None:
    beside = sys.modules.get("warpsph.files.beside")
    if beside is not None:
        beside.remove_hidden()
    with contextlib.suppress(OSError):
        os.write(2, (SHOW_CURSOR + b"\n" if os.isatty(2) else b"") + b"warpsph: interrupted\n")
    os._exit(128 + number)
