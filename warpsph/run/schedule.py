"""When a run makes its steps, its frames and its end."""

from dataclasses import dataclass

import numpy as np

from warpsph.errors import InputError
from warpsph.run.timestep import StepPlan, listed

ROUNDING = 1.0e-6  # of a cycle
MOST_STEPS = 1.0e15  # which double precision can count
SHORTEST_STEP = float(np.finfo(np.float32).tiny)  # [s], in single precision


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
        checkpoint_interval: time between two checkpoints [s], if there are any.
        done: whole cycles of this schedule that an earlier run has done.

    Raises:
        InputError: a step is too short to be one, or there are none or too many of them.
    """

    def __init__(
        self,
        plan: StepPlan,
        begin: float,
        duration: float,
        output_interval: float,
        checkpoint_interval: float | None = None,
        done: int = 0,
    ):
        self.begin, self.duration, self.output_interval = begin, duration, output_interval
        cycle = plan.longest * plan.heat_every
        _refuse_no_steps(plan, duration, output_interval)
        self._per_frame = max(int(np.ceil(output_interval / cycle - 1e-9)), 1)
        self._whole = CycleSteps(output_interval / self._per_frame / plan.heat_every, plan.heat_every)
        cycles = duration / self._whole.duration
        self._cycles = int(cycles + ROUNDING)
        rest = duration - self._cycles * self._whole.duration
        self._last = None
        if cycles - self._cycles > ROUNDING:
            steps = max(int(np.ceil(rest / self._whole.dt - ROUNDING)), 1)
            self._last = CycleSteps(rest / steps, steps)
        self._per_checkpoint = None
        if checkpoint_interval is not None:
            self._per_checkpoint = max(round(min(checkpoint_interval / self._whole.duration, MOST_STEPS)), 1)
        self._done = self._next = done  # whole cycles, and one more when the last one is done

    @property
    def end(self) -> float:
        """Time at the end of the run [s]."""
        return _without_rounding(self.begin + self.duration)

    @property
    def done(self) -> bool:
        """Whether the run is at its end."""
        return self._done == self._cycles + (self._last is not None)

    @property
    def whole_cycles(self) -> int:
        """Cycles of full length that are done."""
        return min(self._done, self._cycles)

    @property
    def cycle_steps(self) -> CycleSteps:
        """The steps of the cycles of the batch that has been asked for, at first of the first one."""
        return self._whole if self._next < self._cycles or self._last is None else self._last

    @property
    def steps_done(self) -> int:
        """Steps of the run so far."""
        whole = self.whole_cycles
        return whole * self._whole.count + (self._last.count if self._last and self._done > whole else 0)

    @property
    def steps(self) -> int:
        """Steps of the whole run."""
        return self._cycles * self._whole.count + (self._last.count if self._last else 0)

    @property
    def frames(self) -> int:
        """Frames of the whole run, the first and the last among them."""
        whole, beyond = divmod(self._cycles, self._per_frame)
        return 1 + whole + (beyond > 0 or self._last is not None)

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
        """Whether a frame is due now that a longer run has too."""
        return self._done % self._per_frame == 0 and self.on_whole_cycle

    @property
    def on_whole_cycle(self) -> bool:
        """Whether a longer run passes through this moment too: not at the end of a shorter last cycle."""
        return self._done <= self._cycles

    @property
    def at_checkpoint(self) -> bool:
        """Whether a checkpoint is due now; the last one stands where a longer run can go on."""
        if not self._per_checkpoint or not self.on_whole_cycle:
            return False
        return self._done % self._per_checkpoint == 0 or self._done == self._cycles

    def next_batch(self, most: int) -> int:
        """Go on by at most so many cycles, not beyond the next frame or checkpoint; return by how many."""
        self._next = self._done
        whole = [most, self._cycles - self._done]
        whole += [every - self._done % every for every in (self._per_frame, self._per_checkpoint) if every]
        batch = min(whole) if self._done < self._cycles else 1
        self._done += batch
        return batch


def _refuse_no_steps(plan: StepPlan, duration: float, output_interval: float) -> None:
    step = min(plan.longest, output_interval / plan.heat_every)
    why = f" ({listed(plan.limits)})" if plan.limits and plan.longest <= step else ""
    if not step >= SHORTEST_STEP:
        raise InputError(
            f"a time step of {step:.3g} s{why} is too short for single precision; output_interval (--every), the "
            "spacing and what limits the step make it longer"
        )
    if not duration > ROUNDING * step:
        raise InputError(
            f"duration = {duration:.3g} s (--until): is less than a millionth of a step of {step:.3g} s{why}; "
            "give a longer one"
        )
    if not duration / step < MOST_STEPS:
        raise InputError(
            f"duration = {duration:.3g} s (--until): would take {duration / step:.3g} steps of {step:.3g} s{why}; a "
            "shorter one, or longer steps"
        )


def _without_rounding(time: float) -> float:
    """A time [s] as people write it: 12.6 for 126 times 0.1, which is 12.600000000000001."""
    return float(f"{time:.12g}")
