"""How far and how fast a run is."""

import time as wall_clock

from warpsph.run.progress import Progress, Report
from warpsph.run.schedule import Schedule

SECONDS_BETWEEN_LOOKS = 0.25


class Meter:
    """Measures the speed of a run, reports progress, and sizes the batches between two looks.

    Args:
        schedule: of the run.
        report: called at every look, or None.
    """

    def __init__(self, schedule: Schedule, report: Report | None):
        self.schedule, self.report = schedule, report
        self.cycles_at_once = 1
        self._steps_before = schedule.steps_done
        self.started = self.last = wall_clock.perf_counter()

    def update(self, batch: int, note: str) -> None:
        """Take in that a batch of cycles is done."""
        now = wall_clock.perf_counter()
        per_cycle = max(now - self.last, 1e-6) / batch
        self.last = now
        self.cycles_at_once = max(1, min(int(SECONDS_BETWEEN_LOOKS / per_cycle), 4 * self.cycles_at_once))
        if self.report is None:
            return
        schedule = self.schedule
        speed = (schedule.steps_done - self._steps_before) / (now - self.started)
        left = max(schedule.end - schedule.time, 0.0) / schedule.dt / max(speed, 1e-9)
        self.report(Progress(schedule.time, schedule.end, schedule.steps_done, speed, left, note))
