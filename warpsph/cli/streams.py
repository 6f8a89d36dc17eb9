"""Standard streams that are closed, full or gone: nothing is lost for their sake, and nothing goes wrong in silence."""

import contextlib
import os
import sys
from typing import Any


class Unfailing:
    """A text stream that drops what cannot be written: a run does not end because its terminal has gone.

    Args:
        stream: where to write.
    """

    def __init__(self, stream: Any) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        with contextlib.suppress(OSError):
            self._stream.write(text)
        return len(text)

    def flush(self) -> None:
        with contextlib.suppress(OSError):
            self._stream.flush()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def mend_streams() -> None:
    """Give the streams that are closed (``2>&-``) a place that swallows everything.

    Otherwise the next file that is opened, perhaps a result, would get their number, and what libraries print.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest number that is free
    if sys.stdout is None:
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
    sys.stderr = Unfailing(sys.stderr or open(os.devnull, "w"))  # noqa: SIM115


def written_out(code: int) -> int:
    """Exit code of a command that has ended with ``code``, once its output is out."""
    try:
        sys.stdout.flush()
    except OSError as error:
        # else the interpreter tries again at its end, and tells of it in its own words
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        if not isinstance(error, BrokenPipeError):
            print(f"warpsph: standard output cannot be written: {error.strerror}", file=sys.stderr)
        return code or 1
    return code
