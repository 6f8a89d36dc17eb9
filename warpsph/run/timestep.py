"""The time step: the shortest of the limits of all terms."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.labels import Role
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.term import Term
from warpsph.errors import InputError, number
from warpsph.kernels.basics.roles import FLUID_ROLES

Limits = dict[str, float]

MOST_SMALL_STEPS = 4  # on either half of the way, beyond which small steps take longer than what they save
ROUNDING = 1.0e-9  # relative; what a number of steps times their length may differ from the length of them all


@dataclass(frozen=True)
class StepPlan:
    """How long steps are at most.

    Attributes:
        longest: time step [s].
        heat_every: steps between two steps with heat.
        limits: of the flow and of solids [s], by reason.
        with_heat: whether heat is conducted at all.
        small_steps: in how many small ones fast forces act on either half of the way.
        step_factor: what the limits were multiplied by.
    """

    longest: float
    heat_every: int
    limits: Limits
    with_heat: bool
    small_steps: int = 1
    step_factor: float = 1.0

    @property
    def stable(self) -> Limits:
        """The limits [s] as they are where nobody stretches them."""
        return {reason: limit / self.step_factor for reason, limit in self.limits.items()}


def plan_steps(model: Model, moving: tuple[int, ...], dt: float | None, step_factor: float) -> StepPlan:
    """The longest steps that all terms allow, or those asked for.

    Args:
        model: composed.
        moving: indices of the materials that move.
        dt: time step asked for [s]; one that is too long is refused.
        step_factor: what the limits of flow and solids are multiplied by.

    Raises:
        InputError: ``dt`` is too long, or nothing limits the step and none was given.
    """
    terms: list[Term] = list(model.terms)
    steps: Limits = {}
    small: Limits = {}
    intervals: Limits = {}
    for term in terms:
        _add(steps, term.longest_steps(model, moving), term)
        _add(small, term.longest_small_steps(model, moving), term)
        _add(intervals, term.longest_intervals(model), term)
    if not 0.0 < number(step_factor) < np.inf:
        raise InputError(f"step_factor = {step_factor!r}: must be positive")
    small_steps = _small_steps(steps, small)
    steps |= {reason: 2 * small_steps * limit for reason, limit in small.items()}
    steps = {reason: step_factor * limit for reason, limit in steps.items()}
    heat_every = 1
    if intervals and not steps:
        steps, step_factor = intervals, 1.0
        longest = _choose(dt, steps)
    else:
        longest = _choose(dt, steps)
        if intervals:
            shortest = min(intervals.values())
            heat_every = max(int(shortest / longest * (1.0 + ROUNDING)), 1)
            longest = min(longest, shortest)
    if not np.isfinite(longest):
        raise InputError("dt: nothing limits the time step of this case; give one")
    return StepPlan(longest, heat_every, steps, bool(intervals), small_steps, float(step_factor))


def _small_steps(steps: Limits, small: Limits) -> int:
    """How many small steps either half of the way needs for the step to be as long as all else allows."""
    if not small or not steps:
        return 1
    wanted = min(steps.values()) / (2.0 * min(small.values()))
    return min(max(int(np.ceil(wanted - ROUNDING)), 1), MOST_SMALL_STEPS)


def listed(limits: Limits) -> str:
    """The limits in one line."""
    return ", ".join(f"{reason} {limit:.3g} s" for reason, limit in limits.items())


def _add(limits: Limits, further: Limits, term: Term) -> None:
    """Add the limits of a term; of two with the same reason the shorter one holds."""
    for reason, limit in further.items():
        if not limit > 0.0:
            raise InputError(f"{type(term).__name__}: its longest step by '{reason}' is {limit} s; it must be positive")
        limits[reason] = min(limit, limits.get(reason, limit))


def _choose(dt: float | None, limits: Limits) -> float:
    longest = min(limits.values(), default=np.inf)
    if dt is None:
        return longest
    if not 0.0 < number(dt) < np.inf:
        raise InputError(f"dt = {dt!r}: must be positive [s]")
    if dt > longest * (1.0 + ROUNDING):
        raise InputError(f"time step {dt:.3g} s is too long; limits: {listed(limits)}")
    return dt


def moving_materials(model: Model, particles: Particles) -> tuple[int, ...]:
    """Indices of the materials of what the forces move, or will once it has come in."""
    comes_in = np.isin(particles.role, (*FLUID_ROLES, Role.RESERVOIR)) & particles.flows
    names = set(particles.material[comes_in | (particles.role == Role.FREE)])
    return tuple(sorted(model.index_of(name) for name in names))
