"""How far and how fast a run is."""

import time as wall_clock
from collections.abc import Callable
from dataclasses import dataclass

SECONDS_BETWEEN_LOOKS = 0.25


@dataclass
class Progress:
    """Where a run stands: physical time and its end [s], steps done, speed, wall time left [s], and a note."""

    time: float
    duration: float
    steps: int
    steps_per_second: float
    seconds_left: float
    note: str = ""


Report = Callable[[Progress], None]


class Meter:
    """Measures the speed of a run, reports progress, and sizes the batches between two looks.

    Args:
        begin, duration: physical time at the start and to go from there [s].
        dt: time step [s].
        steps_per_cycle: steps in what is replayed at once.
        report: called at every look, or None.
    """

    def __init__(self, begin: float, duration: float, dt: float, steps_per_cycle: int, report: Report | None):
        self.end, self.dt, self.steps_per_cycle, self.report = begin + duration, dt, steps_per_cycle, report
        self.cycles_at_once = 1
        self.started = self.last = wall_clock.perf_counter()

    def update(self, batch: int, cycles_done: int, time: float, note: str) -> None:
        """Take in that a batch of cycles is done, ``cycles_done`` in all, and that it is now ``time`` [s]."""
        now = wall_clock.perf_counter()
        per_cycle = max(now - self.last, 1e-6) / batch
        self.last = now
        self.cycles_at_once = max(1, min(int(SECONDS_BETWEEN_LOOKS / per_cycle), 4 * self.cycles_at_once))
        if self.report is None:
            return
        steps = cycles_done * self.steps_per_cycle
        speed = steps / (now - self.started)
        left = max(self.end - time, 0.0) / self.dt / max(speed, 1e-9)
        self.report(Progress(time, self.end, steps, speed, left, note))
