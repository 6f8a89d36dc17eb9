"""What a run will take, reckoned before it begins."""

import os
import shutil
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsph.core.capacity import in_bytes
from warpsph.core.labels import Role
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.run.schedule import Schedule
from warpsph.run.timestep import StepPlan, listed

DAY = 86400.0  # [s]
LONGEST_RUN = 30 * DAY  # [s]
MOST_STEPS = 2**31 - 1  # which a counter of 32 bits can count
VERTEX = 16  # bytes of a particle in a frame, beside its fields: its cell, and where that begins
FRAME = 2000  # bytes of a frame beside its particles

# More than any machine does, so that no run is refused that would have ended in time.
MOST_PARTICLE_STEPS = {"cpu": 5.0e6, "cuda": 3.0e9}  # a second; on a CPU by each thread
SHORTEST_STEP = 1.0e-5  # [s] of wall time
SHORTEST_FRAME = 1.0e-3  # [s] of wall time


@dataclass(frozen=True)
class Estimate:
    """What a run will take.

    Attributes:
        particles: how many of each role, by its name.
        memory: of all arrays on the device [bytes].
        dt: time step [s].
        steps, frames: how many.
        disk: of the result file [bytes].
        wall_time: at the very least [s].
    """

    particles: dict[str, int]
    memory: float
    dt: float
    steps: int
    frames: int
    disk: float
    wall_time: float


def estimate_run(state: State, schedule: Schedule, threads: int) -> Estimate:
    """What a schedule will take for particles that have been placed."""
    roles = Counter(state.numpy("role").tolist())
    device = "cuda" if state.device.is_cuda else "cpu"
    fastest = MOST_PARTICLE_STEPS[device] * threads
    written = 12 + VERTEX + sum(4 * max(int(np.prod(f.shape)), 1) for f in state.fields.values() if f.written)
    present = state.count - roles[Role.RESERVOIR]
    held = (array for group in (state.arrays, state.values, state.scratch) for array in group.values())
    arrays = {array.ptr: array.capacity for array in held}
    per_step = max(state.count / fastest, SHORTEST_STEP)
    return Estimate(
        particles={Role(role).name.lower(): roles[role] for role in sorted(roles)},
        memory=float(sum(arrays.values())),
        dt=schedule.dt,
        steps=schedule.steps,
        frames=schedule.frames,
        disk=float(schedule.frames * (present * written + FRAME)),
        wall_time=schedule.steps * per_step + schedule.frames * SHORTEST_FRAME,
    )


def refuse_endless(estimate: Estimate, plan: StepPlan, output_interval: float, steps_before: int = 0) -> None:
    """Refuse a run that would take longer than ``LONGEST_RUN`` even on the fastest machine.

    Raises:
        InputError: how long it would take, and what makes it shorter.
    """
    too_many = steps_before + estimate.steps > MOST_STEPS
    if not too_many and estimate.wall_time <= LONGEST_RUN:
        return
    frames_count = estimate.frames * SHORTEST_FRAME > 0.5 * estimate.wall_time or output_interval < plan.longest
    remedy = "a longer output_interval (--every)" if frames_count else f"longer steps (limits: {listed(plan.limits)})"
    raise InputError(
        f"this run would take {in_time(estimate.wall_time)} or more, with {estimate.steps:.3g} steps of "
        f"{estimate.dt:.3g} s and {estimate.frames:.3g} frames; {in_time(LONGEST_RUN)} and {MOST_STEPS:.2g} steps are "
        f"the most: {remedy} or a shorter duration (--until)"
    )


def refuse_full_disk(estimate: Estimate, output: Path) -> None:
    """Refuse a result file for which there is no room where it would be, which a symbolic link may name.

    Raises:
        InputError: how much it needs, and how much there is.
    """
    try:
        free = shutil.disk_usage(os.path.dirname(os.path.realpath(output))).free
    except OSError:
        return  # what is wrong with the folder is said when the file is made
    if estimate.disk > free:
        raise InputError(
            f"{output}: {estimate.frames:.3g} frames need {in_bytes(estimate.disk)} of disk and {in_bytes(free)} are "
            "free; a longer output_interval (--every), a shorter duration (--until) or another --output would do"
        )


def in_time(seconds: float) -> str:
    """A wall time [s] as people say it."""
    for unit, size in (("years", 365.25 * DAY), ("days", DAY), ("hours", 3600.0), ("minutes", 60.0)):
        if seconds >= 2.0 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.2g} s"
