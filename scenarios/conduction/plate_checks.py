"""What the plates that cool are compared with: their exact series, their ledger of heat, their order of convergence."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario
from warpsph.core.lattice import Lattice
from warpsph.run.result import Result
from warpsph.scenarios.conduction.plate import SMOOTHING_KERNEL, SOURCE, CoolingPlate, rms
from warpsph.scenarios.conduction.time_stepping import Stepping


def carried(case: CoolingPlate) -> float:
    """What the sum over the lattice conducts over what it should."""
    cells = case.share / case.spacing**2 if case.equal_shares else 1.0
    factor = Lattice(2, case.spacing, 2.0 * case.smoothing_length).slope(SMOOTHING_KERNEL)
    return cells * (1.0 if case.exact_on_lattice else factor)


def bias(case: CoolingPlate, time: float) -> float:
    """Root mean square error [K] that follows from what is ``carried`` too much or too little, by the series."""
    points = case.points
    other = replace(case.exact, diffusivity=carried(case) * case.diffusivity)
    return rms(other.temperature(points, time) - case.exact.temperature(points, time))


def scale(case: CoolingPlate) -> float:
    """The difference of temperature over that of the source, 100 K."""
    return abs(case.start - case.exact.outside) / 100.0


def coarseness(case: CoolingPlate) -> float:
    """The spacing over what it is with forty particles along the shorter edge."""
    return (40 - case.row_on_walls) * case.spacing / min(case.length, case.height)


def stepped(case: CoolingPlate) -> str:
    """How time goes on, for the names of checks."""
    return case.integrator.value + ("" if case.integrator is Stepping.EXPLICIT else f", {case.step:g} s")


def allowed(case: CoolingPlate, spacing: float, first: float, second: float) -> float:
    """Root mean square error [K] that is allowed: what the ``spacing`` leaves, and what the steps do.

    ``first`` times the step over the square of the length over the diffusivity for backward Euler, ``second`` times
    the square of that for Crank-Nicolson. Explicit steps are so short that they count with the spacing.
    """
    step = case.step * case.diffusivity / case.length**2
    if case.integrator is Stepping.BACKWARD_EULER:
        return spacing + first * step
    return max(spacing, second * step**2) if case.integrator is Stepping.CRANK_NICOLSON else spacing


def figure_times(case: CoolingPlate, result: Result) -> list[float]:
    """Those times of the figures, over the square of the length and the diffusivity, at which there is a frame."""
    unit, frames = case.length**2 / case.diffusivity, result.diagnostics["time"]
    published = [fourier * unit for fourier in case.fouriers]
    return [time for time in published if np.abs(frames - time).min() < 1e-3 * time]


def error_check(
    case: CoolingPlate, result: Result, time: float, method: str, tolerance: float, source: str, reason: str
) -> Check:
    """Root mean square error at ``time`` [s], beside the bias of a sum that is not exact on the lattice.

    Beside zero where the ``method`` at the edges is said, which then has errors of its own.
    """
    series = result.diagnostics
    exact, own = abs(carried(case) - 1.0) < 1e-6, bool(method)
    what = f"{method}, " if own else ""
    what += "" if exact else f"the sum conducts {carried(case):.4f} of what it should, "
    return Check(
        case.name,
        f"RMS temperature error at {time:g} s ({what}{stepped(case)})",
        "K",
        float(series["rms_error"][np.argmin(np.abs(series["time"] - time))]),
        None if exact or own else bias(case, time),
        tolerance * scale(case),
        f"{SOURCE}, equation {source}" + ("" if exact or own else ", for both conductivities"),
        relative=False,
        reason=reason,
    )


def ledger_check(case: CoolingPlate, result: Result) -> Check:
    """No heat is lost."""
    series = result.diagnostics
    lost = series["heat"][0] - series["heat"][-1] - series["heat_taken"][-1]
    return Check(
        case.name,
        f"heat that is in no ledger, over the heat of the plate ({stepped(case)})",
        "",
        float(lost / series["heat"][0]),
        None,
        1e-6,
        "what the edges take, the plate loses",
        reason="pairs exchange heat exactly; rounding of the enthalpies remains",
    )


def order_check(
    case: CoolingPlate, simulate: Callable[[Scenario], Result], label: str, order: float, reason: str
) -> Check:
    """Order of convergence of the root mean square error from 20 to 160 across, with the longest stable steps.

    After a hundredth of the square of the length over the diffusivity.
    """
    time, counts, errors = 0.01 * case.length**2 / case.diffusivity, np.array([20, 40, 80, 160]), []
    for n in counts:
        changes = {"across": int(n), "duration": time, "output_interval": time, "step": time}
        finer = type(case)(**case.model_dump() | changes)
        errors.append(float(simulate(finer).diagnostics["rms_error"][-1]))
    return Check(
        case.name,
        f"order of convergence{label}, " + ", ".join(f"{error:.2g} K" for error in errors) + " with 20 to 160",
        "",
        float(-np.polyfit(np.log(counts - case.row_on_walls), np.log(errors), 1)[0]),
        order,
        0.2,
        f"{SOURCE}, exact solution",
        relative=False,
        reason=reason,
    )
