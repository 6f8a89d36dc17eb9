"""When a run makes its steps, its frames and its end."""

from dataclasses import dataclass

import numpy as np

from warpsph.run.timestep import StepPlan

ROUNDING = 1.0e-6  # of a cycle


@dataclass(frozen=True)
class CycleSteps:
    """The steps of a cycle, of which the last one conducts heat for all of them.

    Attributes:
        dt: time step [s].
        count: number of steps.
    """

    dt: float
    count: int

    @property
    def duration(self) -> float:
        """Length of the cycle [s]."""
        return self.dt * self.count


class Schedule:
    """Cycles that fill output intervals, and a shorter one at the end where the duration asks for it.

    Args:
        plan: how long steps are at most, and how many make a cycle.
        begin, duration: time at the start of the run and to go from there [s].
        output_interval: time between two frames [s].
    """

    def __init__(self, plan: StepPlan, begin: float, duration: float, output_interval: float):
        self.begin, self.duration, self.output_interval = begin, duration, output_interval
        cycle = plan.longest * plan.heat_every
        self._per_frame = max(int(np.ceil(output_interval / cycle - 1e-9)), 1)
        self._whole = CycleSteps(output_interval / self._per_frame / plan.heat_every, plan.heat_every)
        cycles = duration / self._whole.duration
        self._cycles = int(cycles + ROUNDING)
        rest = duration - self._cycles * self._whole.duration
        self._last = None
        if cycles - self._cycles > ROUNDING:
            steps = int(np.ceil(rest / self._whole.dt - ROUNDING))
            self._last = CycleSteps(rest / steps, steps)
        self._done = 0  # whole cycles, and one more when the last one is done
        self._next = 0

    @property
    def end(self) -> float:
        """Time at the end of the run [s]."""
        return _without_rounding(self.begin + self.duration)

    @property
    def done(self) -> bool:
        """Whether the run is at its end."""
        return self._done == self._cycles + (self._last is not None)

    @property
    def cycle_steps(self) -> CycleSteps:
        """The steps of the cycles of the batch that has been asked for, at first of the first one."""
        return self._whole if self._next < self._cycles or self._last is None else self._last

    @property
    def steps_done(self) -> int:
        """Steps of the run so far."""
        whole = min(self._done, self._cycles)
        return whole * self._whole.count + (self._last.count if self._last and self._done > whole else 0)

    @property
    def dt(self) -> float:
        """Usual time step [s]."""
        return self._whole.dt

    @property
    def time(self) -> float:
        """Time reached [s]; at frames and at the end, of the schedule and free of rounding."""
        if self.done:
            return self.end
        if self._done % self._per_frame == 0:
            return _without_rounding(self.begin + self._done // self._per_frame * self.output_interval)
        return self.begin + self._done * self._whole.duration

    @property
    def at_frame(self) -> bool:
        """Whether a frame is due now."""
        return self.done or self._done % self._per_frame == 0

    def next_batch(self, most: int) -> int:
        """Go on by at most so many cycles, not beyond the next frame; return by how many."""
        self._next = self._done
        until_frame = self._per_frame - self._done % self._per_frame
        batch = min(most, until_frame, self._cycles - self._done) if self._done < self._cycles else 1
        self._done += batch
        return batch


def _without_rounding(time: float) -> float:
    """A time [s] as people write it: 12.6 for 126 times 0.1, which is 12.600000000000001."""
    return float(f"{time:.12g}")
