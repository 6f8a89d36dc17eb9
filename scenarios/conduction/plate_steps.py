"""What long steps make of a plate: the orders of the integrators, and errors of steps far beyond the explicit one."""

from collections.abc import Callable, Iterable

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario
from warpsph.run.result import Result
from warpsph.scenarios.conduction.plate import SOURCE, CoolingPlate, rms
from warpsph.scenarios.conduction.time_stepping import Stepping

ORDERS = {Stepping.BACKWARD_EULER: 1.0, Stepping.CRANK_NICOLSON: 2.0}
STEPS = (0.2, 0.1, 0.05)  # [s]
FINE, FINEST = 0.005, 0.0006  # [s], of Crank-Nicolson, in the place of no step; the second where it may be slow
SOLVED = 1e-8  # tolerance with which the steps alone decide on the error
LONG, LONGEST = 0.2, 0.25  # [s], 20 and 25 times the explicit step
LARGEST = {1.0: 0.5, 8.0: 0.05}  # error [K] with the longest step, by time [s]


def step_checks(kind: type[CoolingPlate], simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
    """Orders in the step, and two long steps of Crank-Nicolson, of the plate of the source."""
    yield from _orders(kind, simulate, FINEST if slow else FINE)
    long = kind(integrator=Stepping.CRANK_NICOLSON, step=LONGEST)
    errors = _errors(simulate(long), tuple(LARGEST))
    for (time, largest), error in zip(LARGEST.items(), errors, strict=True):
        yield Check(
            kind.name,
            f"RMS temperature error at {time:g} s, crank_nicolson with steps of {LONGEST:g} s",
            "K",
            error,
            None,
            largest,
            f"{SOURCE}, exact solution",
            reason="second order in the step, after a jump of 100 K at the edges",
        )
    long, times = kind(integrator=Stepping.CRANK_NICOLSON, step=LONG, output_interval=1.0), (1.0, 4.0, 8.0)
    exact = [rms(long.exact.temperature(long.points, time) - long.exact.outside) for time in times]
    yield Check(
        kind.name,
        f"largest RMS error from 1 s on over that of T - T_edge, crank_nicolson with steps of {LONG:g} s",
        "",
        max(error / size for error, size in zip(_errors(simulate(long), times), exact, strict=True)),
        None,
        0.01,
        f"{SOURCE}, exact solution",
        reason="20 times the step of (12), after the start-up",
    )


def _orders(kind: type[CoolingPlate], simulate: Callable[[Scenario], Result], fine: float) -> Iterable[Check]:
    """Order of the error that the steps alone make after 1 s."""

    def end(integrator: Stepping, step: float) -> np.ndarray:
        case = kind(integrator=integrator, step=step, duration=1.0, output_interval=1.0, tolerance=SOLVED)
        return simulate(case).fields["temperature"].astype(float)

    exactly = end(Stepping.CRANK_NICOLSON, fine)
    for integrator, order in ORDERS.items():
        errors = [rms(end(integrator, step) - exactly) for step in STEPS]
        listed = ", ".join(f"{error:.2g} K with {step:g} s" for error, step in zip(errors, STEPS, strict=True))
        yield Check(
            kind.name,
            f"order in the step, {integrator.value} ({listed})",
            "",
            float(np.polyfit(np.log(STEPS), np.log(errors), 1)[0]),
            order,
            0.1,
            f"theory of the integrator; against crank_nicolson on the same lattice with steps of {1e3 * fine:g} ms",
            relative=False,
            reason="the first steps after the jump are still seen",
        )


def _errors(result: Result, times: tuple[float, ...]) -> list[float]:
    """Root mean square errors [K] at the frames nearest to ``times`` [s]."""
    series = result.diagnostics
    return [float(series["rms_error"][np.argmin(np.abs(series["time"] - time))]) for time in times]
