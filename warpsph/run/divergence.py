"""The watch over divergence: what is said of the particle that was the first beyond a bound."""

import numpy as np

from warpsph.core.guard import Offender, Reading
from warpsph.core.solver import Solver
from warpsph.errors import DivergenceError
from warpsph.run.timestep import StepPlan

TOO_MANY = {
    "neighbours": "particles have collapsed onto each other, or were put there too close; take a smaller time step or "
    "a higher sound speed, at the start other places",
    "bonds": "what has frozen is packed too closely to be bonded; take a smaller time step or a higher sound speed of "
    "the melt, at the start other places",
}


def refuse_divergence(solver: Solver, plan: StepPlan) -> None:
    """Stop a run that has diverged or whose lists were too short.

    Raises:
        DivergenceError: which particle, where, which quantity and what it may be; and among its facts when, how long
            steps are against their limits, and what usually causes it.
    """
    if (offender := solver.find_offender()) is not None:
        raise _error(offender, solver, plan)
    solver.check()


def _error(offender: Offender, solver: Solver, plan: StepPlan) -> DivergenceError:
    place = ", ".join(f"{x:.4g}" for x in offender.position)
    who = f"particle {offender.id} ({offender.role.name.lower()}, {offender.material}) at ({place}) m"
    reading = offender.reading
    if reading is None:
        what = f"has {offender.length} {offender.what}, {offender.room} at most"
        cause = TOO_MANY[offender.what]
    else:
        what, cause = f"has {reading}, {_limit(reading)}", reading.bound.cause
    facts = {
        "when": f"at the end of step {offender.steps}, t = {offender.time:.6g} s",
        "particle": f"{offender.phase.name.lower()}; {', '.join(str(each) for each in offender.readings)}",
        "time step": _steps(solver.dt, plan),
        "usual cause": cause,
    }
    return DivergenceError(
        f"diverged at t = {offender.time:.6g} s: {who} {what}", {name: text for name, text in facts.items() if text}
    )


def _limit(reading: Reading) -> str:
    lower, upper, unit = reading.bound.lower, reading.bound.upper, reading.unit
    limits = [f"above {lower:.4g}"] if np.isfinite(lower) else []
    limits += [f"below {upper:.4g}"] if np.isfinite(upper) else []
    return f"must be {' and '.join(limits)} {unit}".rstrip() if limits else "must be a number"


def _steps(dt: float, plan: StepPlan) -> str:
    limits = [f"{reason}: {dt / limit:.3g} of {limit:.3g} s" for reason, limit in plan.stable.items()]
    every = f"; heat every {plan.heat_every} steps" if plan.with_heat else ""
    return f"{dt:.4g} s; by its limits, {', '.join(limits)}{every}" if limits else f"{dt:.4g} s{every}"
