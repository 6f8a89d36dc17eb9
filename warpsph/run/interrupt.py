"""Ctrl-C during a run: asked once, the run ends in good order; asked twice, it ends at once."""

import signal
import threading
from types import FrameType


class InterruptRequest:
    """Context in which Ctrl-C only sets ``asked``; a second Ctrl-C raises KeyboardInterrupt."""

    def __init__(self) -> None:
        self.asked = False

    def __enter__(self) -> "InterruptRequest":
        self._in_main = threading.current_thread() is threading.main_thread()
        if self._in_main:
            self._before = signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, *_: object) -> None:
        if self._in_main:
            signal.signal(signal.SIGINT, self._before)

    def _note(self, number: int, frame: FrameType | None) -> None:
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True
