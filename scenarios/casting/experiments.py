"""Experiments of Vijaykumar (2012), sections 7.2 and 7.3: the inlet at three heights, and the oscillating mould."""

from collections.abc import Callable, Iterable

import numpy as np

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.run.result import Result
from warpsph.scenarios.casting.mould_oscillation import negative_strip_time, overtaking_time, response
from warpsph.scenarios.casting.parameters import CastingParameters

NUMERICS = ({"support_ratio": 3.0}, {"sound_speed": 7.0}, {"viscosity": 30.0}, {"step_factor": 2.0})
INLETS = ("inlet_high", "inlet_middle", "inlet_low")
Diagnostics = dict[str, np.ndarray]


def inlet_checks(kind: type[CastingParameters], simulate: Callable[[CastingParameters], Result]) -> Iterable[Check]:
    """At the height of each jet the shell is thinner than it is there with the jet elsewhere."""
    cases = [resolve(kind, [preset_layer(kind, preset)]) for preset in INLETS]
    runs = [simulate(case).diagnostics for case in cases]
    heights = runs[0]["height"][0]
    shells = [mean_shell(run) for run in runs]
    for case, run, shell in zip(cases, runs, shells, strict=True):
        jet = case.nozzle_mouth
        farthest = int(np.argmax([abs(other.nozzle_mouth - jet) for other in reversed(cases)]))
        elsewhere, away = shells[::-1][farthest], cases[::-1][farthest].nozzle_mouth
        share = float(np.interp(jet, heights, shell) / np.interp(jet, heights, elsewhere))
        yield Check(
            kind.name, f"shell at {jet:g} m, the jet there, over the shell with the jet at {away:g} m", "", share, 0.0,
            0.9, "Vijaykumar (2012), figure 7.1: at least a tenth thinner", relative=False,
            reason="the jet brings its superheat there",
        )  # fmt: skip
        loss = np.diff(shell)  # from each height to the one below, where the shell is a little older
        fastest = int(np.argmax(loss))
        yield Check(
            kind.name, f"jet at {jet:g} m: height at which the shell melts back fastest", "m",
            float(0.5 * (heights[fastest] + heights[fastest + 1])), jet, 0.04, "Vijaykumar (2012), section 7.2",
            relative=False, reason="heights of the profile are 2 cm apart, and the melt sinks on its way to the shell",
        )  # fmt: skip
        yield Check(
            kind.name, f"enthalpy ledger, jet at {jet:g} m", "", float(np.max(np.abs(run["ledger_error"]))), None, 1e-3,
            "conservation of energy", reason="single precision, pairwise antisymmetric conduction",
        )  # fmt: skip


def mean_shell(run: Diagnostics) -> np.ndarray:
    """Thickness of the shell [m] along the height, averaged over the last third of a run."""
    return np.mean(run["shell_thickness"][run["time"] >= 2.0 / 3.0 * run["time"][-1]], axis=0)


def oscillation_checks(
    kind: type[CastingParameters], simulate: Callable[[CastingParameters], Result]
) -> Iterable[Check]:
    """Negative strip as computed; meniscus and shell answer at the mould's frequency, and only while it moves."""
    case = resolve(kind, [preset_layer(kind, "oscillation")])
    at_rest = case.model_copy(update={"mould_stroke": 0.0})
    moving, still = (whole_cycles(simulate(c).diagnostics, case) for c in (case, at_rest))
    f, time = case.mould_frequency, moving["time"]
    yield Check(
        kind.name, "negative-strip time: the mould overtakes the shell", "s",
        overtaking_time(time, moving["mould_velocity"], moving["shell_velocity"], f),
        negative_strip_time(case.mould_stroke, f, case.casting_speed), 0.05,
        "60/(pi f) arccos(1000 v/(pi f s)), usual in casting", reason="the shell follows the mould a little",
    )  # fmt: skip
    for name, text in (
        ("shell_velocity", "velocity of the shell's skin"),
        ("meniscus", "meniscus"),
    ):
        answer, background = (response(run["time"], run[name], f)[0] for run in (moving, still))
        yield Check(
            kind.name, f"{text}: part at the mould's frequency, mould at rest over mould moving", "",
            background / answer, None, 0.5, "Vijaykumar (2012), section 7.3",
            reason="waves that the jet makes are the background",
        )  # fmt: skip
    yield Check(
        kind.name, "enthalpy ledger, oscillating mould that drags", "", float(np.max(np.abs(moving["ledger_error"]))),
        None, 1e-3, "conservation of energy", reason="single precision, pairwise antisymmetric conduction",
    )  # fmt: skip


def parameter_checks(kind: type[CastingParameters], simulate: Callable[[CastingParameters], Result]) -> Iterable[Check]:
    """The shell does not depend on numerical parameters, as long as they are stable."""
    base = kind(duration=3.0, output_interval=0.25)
    usual = lower_mould_shell(base, simulate(base).diagnostics)
    for change in NUMERICS:
        case = base.model_copy(update=change)
        name, value = next(iter(change.items()))
        yield Check(
            kind.name, f"shell, lower half of the mould, {name} {value:g}", "m",
            lower_mould_shell(case, simulate(case).diagnostics), usual, 0.05,
            "the same with the defaults; parameters of Vijaykumar (2012), section 7.5",
            reason="a few particles that freeze sooner or later, in a shell of three layers",
        )  # fmt: skip


def lower_mould_shell(case: CastingParameters, run: Diagnostics) -> float:
    """Mean thickness of the shell [m] in the lower half of the mould over the second half of a run."""
    heights, late = run["height"][0], run["time"] > 0.5 * run["time"][-1]
    lower_mould = (heights > case.mould_bottom) & (heights < 0.5 * (case.mould_bottom + case.level))
    return float(np.mean(run["shell_thickness"][late][:, lower_mould]))


def whole_cycles(run: Diagnostics, case: CastingParameters, settled: float = 2.0) -> Diagnostics:
    """The rows of a run from ``settled`` [s] on that make whole cycles of the mould."""
    time = run["time"]
    cycles = int((time[-1] - settled) * case.mould_frequency + 1e-9)
    rows = time >= time[-1] - cycles / case.mould_frequency - 1e-6
    return {name: values[rows] for name, values in run.items()}
