"""The checks of a casting run."""

import numpy as np

from warpsph.cases.check import Check
from warpsph.run.result import Result
from warpsph.scenarios.casting.parameters import CastingParameters
from warpsph.scenarios.casting.travelling_slice import shell_thickness


def ledger_checks(case: CastingParameters, result: Result) -> list[Check]:
    """Nothing is lost and nothing comes from nowhere."""
    d = result.diagnostics
    mass_error = d["particles_inside"] - d["particles_inside"][0] - d["particles_in"] + d["particles_out"]
    ids = np.sort(result.fields["id"])
    return [
        Check(
            case.name, "particles lost (inside - start - in + out)", "", float(np.max(np.abs(mass_error))), None, 0.0,
            "conservation of mass", reason="every particle is counted",
        ),
        Check(
            case.name, "ids that are missing or doubled", "", float(np.sum(ids != np.arange(len(ids)))), None, 0.0,
            "conservation of mass", reason="every id stands for one particle for the whole run",
        ),
        Check(
            case.name, "enthalpy ledger", "", float(np.max(np.abs(d["ledger_error"]))), None, 1e-3,
            "conservation of energy", reason="single precision, pairwise antisymmetric conduction",
        ),
    ]  # fmt: skip


def casting_checks(case: CastingParameters, result: Result) -> list[Check]:
    """Ledgers, steadiness, and the growth of the shell in the mould against one-dimensional conduction."""
    d = result.diagnostics
    last_third = d["time"] >= 2.0 / 3.0 * d["time"][-1]
    level, meniscus = d["level"][last_third], d["meniscus"][last_third]
    return [
        *ledger_checks(case, result),
        Check(
            case.name, "melt outside the strand", "particles", float(np.max(d["escaped_melt"])), None, 0.0,
            "all sprays on: no hole", reason="the shell holds",
        ),
        Check(
            case.name, "level by weight, farthest from the level asked for, last third", "m",
            float(level[np.argmax(np.abs(level - case.level))]), case.level, 0.03,
            "Vijaykumar (2012), section 6.3: the level remains constant", reason="the gauge answers within 0.1 s",
        ),
        Check(
            case.name, "meniscus, farthest from its mean, last third", "m",
            float(meniscus[np.argmax(np.abs(meniscus - meniscus.mean()))]), float(meniscus.mean()), 0.03,
            "Vijaykumar (2012), section 6.3: the level remains constant", reason="waves of one spacing or two",
        ),
        Check(
            case.name, "particles that the reservoirs could not give", "",
            float(d["missing_melt"][-1] + d["missing_water"][-1]), None, 0.0,
            "the machine runs on what has left it", reason="every particle is counted",
        ),
        _shell_check(case, result),
    ]  # fmt: skip


def _shell_check(case: CastingParameters, result: Result) -> Check:
    """Mean thickness over the lower half of the mould, averaged over the last third of the run."""
    d = result.diagnostics
    heights = d["height"][0]
    last_third = d["time"] >= 2.0 / 3.0 * d["time"][-1]
    lower_mould = (heights > case.mould_bottom) & (heights < 0.5 * (case.mould_bottom + case.level))
    measured = np.mean(d["shell_thickness"][last_third][:, lower_mould])
    profiles = case.slices(heights[lower_mould])
    exact = np.mean([shell_thickness(profile, case.steel, case.half_width, 0.5) for profile in profiles])
    return Check(
        case.name, "shell thickness, lower half of the mould", "m", float(measured), float(exact), 0.15,
        "one-dimensional enthalpy conduction of a stagnant slice with the same wall",
        reason="half a spacing of the interface's place, and the melt that moves",
    )  # fmt: skip
