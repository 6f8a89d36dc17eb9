"""Signals that end a run: asked once, it ends in good order; asked twice, at once."""

import signal
import threading
from types import FrameType
from typing import Any

# Ctrl-C; what a batch system sends before it kills; what is left when a connection is lost
SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))


class Interrupted(KeyboardInterrupt):
    """A signal has ended the work; ``number`` is that of the signal."""

    def __init__(self, number: int = signal.SIGINT) -> None:
        super().__init__(f"interrupted by {signal.Signals(number).name}")
        self.number = number


class InterruptRequest:
    """Context in which the first signal only sets ``number``; a second one does what it did before.

    A signal that is ignored, as SIGHUP under ``nohup``, stays ignored. One that would have ended the process is sent
    anew at the end, so that a script does not go on with its next run; Ctrl-C leaves that to the script.

    Attributes:
        number: that of the signal, or 0.
    """

    def __init__(self) -> None:
        self.number = 0
        self._before: dict[int, Any] = {}

    @property
    def asked(self) -> bool:
        return self.number != 0

    def __enter__(self) -> "InterruptRequest":
        if threading.current_thread() is threading.main_thread():
            for number in SIGNALS:
                if signal.getsignal(number) not in (signal.SIG_IGN, None):
                    self._before[number] = signal.signal(number, self._note)
        return self

    def __exit__(self, *_: object) -> None:
        for number, before in self._before.items():
            signal.signal(number, before)

    def send_on(self) -> None:
        """Let a signal that would have ended the process end it now that all is kept, or a run around this one."""
        before = self._before.get(self.number)
        if before is signal.SIG_DFL:
            signal.raise_signal(self.number)
        around = getattr(before, "__self__", None)
        if isinstance(around, InterruptRequest):
            around.number = around.number or self.number

    def _note(self, number: int, frame: FrameType | None) -> None:
        if not self.asked:
            self.number = number
            return
        before = self._before[number]
        if callable(before):
            before(number, frame)
        raise Interrupted(number)
