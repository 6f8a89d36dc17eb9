"""How far and how fast a run is."""

import time as wall_clock
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from warpsph.run.simulation import Simulation

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


class Meter:
    """Measures the speed of a run, reports progress, and sizes the batches between two looks."""

    def __init__(self, simulation: "Simulation", duration: float, report: Callable[[Progress], None] | None):
        self.simulation, self.duration, self.report = simulation, duration, report
        self.cycles_at_once = 1
        self.started = self.last = wall_clock.perf_counter()

    def update(self, batch: int, cycles_done: int, note: str) -> None:
        now = wall_clock.perf_counter()
        per_cycle = max(now - self.last, 1e-6) / batch
        self.last = now
        self.cycles_at_once = max(1, min(int(SECONDS_BETWEEN_LOOKS / per_cycle), 4 * self.cycles_at_once))
        if self.report is None:
            return
        time = self.simulation.time
        steps = cycles_done * self.simulation.heat_every
        speed = steps / (now - self.started)
        left = max(self.duration - time, 0.0) / self.simulation.solver.dt / max(speed, 1e-9)
        self.report(Progress(time, self.duration, steps, speed, left, note))
