"""The checks of a casting run."""

import numpy as np

from warpsph.cases.check import Check
from warpsph.core.materials import WATER
from warpsph.run.result import Result
from warpsph.scenarios.casting.alarms import SETTLED
from warpsph.scenarios.casting.parameters import CastingParameters
from warpsph.scenarios.casting.travelling_slice import shell_thickness

ENOUGH_READINGS = 50  # of which 95 of 100 say something


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
        *_water_checks(case, result),
        *_speed_checks(case, result),
        *_shell_checks(case, result),
    ]  # fmt: skip


def _water_checks(case: CastingParameters, result: Result) -> list[Check]:
    d = result.diagnostics
    return [
        Check(
            case.name, "water inside the steel, in any frame", "particles", float(np.max(d["water_inside"])), None, 0.0,
            "water runs off", reason="it stands on the outermost particle",
        ),
        Check(
            case.name, "water that the strand has closed over, of all that was sprayed", "",
            float(d["water_caught"][-1] / max(result.fields["entries"][result.made_of(WATER.name)].sum(), 1)), None,
            0.001, "water runs off", reason="a bulge may overtake a drop",
        ),
    ]  # fmt: skip


def _speed_checks(case: CastingParameters, result: Result) -> list[Check]:
    d = result.diagnostics
    fast = d["shell_speed"][d["time"] > SETTLED]
    if len(fast) == 0:
        return []
    highest = Check(
        case.name, f"highest speed of the shell after {SETTLED:g} s", "m/s", float(np.max(fast)),
        None, case.fastest_shell, "the mould's at most, and g h / c_s",
        reason="a particle that melts may be rid of the melt's pressure at once",
    )  # fmt: skip
    usual = Check(
        case.name, f"speed of the shell that 95 of 100 readings after {SETTLED:g} s do not exceed", "m/s",
        float(np.percentile(fast, 95)), None, case.fastest_mould + 5.0 * case.casting_speed,
        "the mould's at most, and five casting speeds", reason="a skin one particle thick is jerked now and then",
    )  # fmt: skip
    return [highest, usual] if len(fast) >= ENOUGH_READINGS else [highest]


def _shell_checks(case: CastingParameters, result: Result) -> list[Check]:
    """Mean over the last third of a run of the shell that the run has made, where there should be two layers of it."""
    d = result.diagnostics
    heights, last_third = d["height"][0], d["time"] >= 2.0 / 3.0 * d["time"][-1]
    made = heights > case.level - case.casting_speed * d["time"][last_third][0]
    profiles = case.slices(heights)
    exact = np.array([shell_thickness(profile, case.steel, case.half_width, 0.5) for profile in profiles])
    thick = made & (exact > 2.0 * case.spacing)
    below, half_way = heights < case.mould_bottom, 0.5 * (case.mould_bottom + case.level)
    places = {"in the lower mould": (~below & (heights < half_way), 0.15), "below the mould": (below, 0.25)}
    return [
        Check(
            case.name, f"shell {place} that the run has made, {heights[here][0]:.2f} to {heights[here][-1]:.2f} m", "m",
            float(np.mean(d["shell_thickness"][last_third][:, here])), float(np.mean(exact[here])), tolerance,
            "one-dimensional enthalpy conduction of a stagnant slice with the same wall",
            reason="the melt moves: the jet brings down the superheat that the slice keeps at the top",
        )
        for place, (there, tolerance) in places.items()
        if np.any(here := thick & there)
    ]  # fmt: skip
