"""What lies beyond the model of an alloy: refused at the start, reported during a run."""

from collections.abc import Sequence

import numpy as np

from warpsph.core.state import State
from warpsph.errors import DivergenceError, InputError
from warpsph.terms.heat_wall import HeatWall
from warpsph.terms.liquidus import Liquidus

BEYOND = 1.0e-3  # share by which a concentration may pass the end of the liquidus: rounding, on a wall that is as cold


def refuse_start(
    liquidus: Liquidus, density_ice: float, points: np.ndarray, volume: np.ndarray, fields: dict[str, np.ndarray]
) -> None:
    """Refuse particles at ``points`` (n, 3) [m], of ``volume`` (n,) [m^3, or m^2 in 2D], that the model has no way for.

    Raises:
        InputError: one is of pure solvent, beyond the end of the liquidus, or more ice than there is room for.
    """
    end = liquidus.concentrations[-1]
    filled = fields["ice_mass"] / (density_ice * volume)
    for name, beyond, why in (
        (
            "solute",
            fields["solute_mass"] <= 0.0,
            "there is none: all of a pure solvent would freeze at once, which the model leaves out; give it some, or "
            "take Conduction with PhaseChange or WholePhases for a pure substance",
        ),
        ("liquid_mass", fields["liquid_mass"] <= 0.0, "must be positive: ice beside no liquid is left out"),
        (
            "solute",
            fields["solute_mass"] > end * fields["liquid_mass"],
            f"beyond the end of the liquidus, {end:g}: the solid that forms at the eutectic is left out",
        ),
        (
            "temperature",
            fields["temperature"] < liquidus.lowest,
            f"below the end of the liquidus, {liquidus.lowest:g} K: the solid that forms at the eutectic is left out",
        ),
        ("ice_mass", filled >= 1.0, "more than there is room for; the model leaves out that ice pushes liquid away"),
    ):
        if len(found := np.flatnonzero(beyond)):
            value, place = fields[name][found[0]], _shown(points[found[0]])
            raise InputError(f"Alloy: '{name}' = {value:g} at ({place}) m, of {len(found)} particles: {why}")


def refuse_full_walls(
    walls: Sequence[HeatWall],
    liquidus: Liquidus,
    ratio: float,
    support: float,
    points: np.ndarray,
    fields: dict[str, np.ndarray],
) -> None:
    """Refuse walls at which ice in equilibrium would fill all the room; ``ratio`` is liquid's density over ice's.

    Raises:
        InputError: one is so cold that the ice of the particles within the ``support`` [m] has no room there.
    """
    bulk = fields["solute_mass"] / (fields["liquid_mass"] + fields["ice_mass"])
    for wall in walls:
        near = wall.height(points) < support
        if wall.conductance < np.inf or not np.any(near):
            continue
        brine = float(liquidus.concentration(wall.outside))
        room = ratio * (1.0 - float(np.min(bulk[near])) / brine) if brine > 0.0 else 0.0
        if room >= 1.0:
            raise InputError(
                f"Alloy: ice would fill {room:.2f} of the room at the wall of {wall.outside:g} K: the model leaves out "
                "that ice pushes liquid away; give a warmer wall, or more solute"
            )


def report_beyond(state: State, liquidus: Liquidus) -> None:
    """Stop a run that has come to where the model ends, or to numbers that are none.

    Raises:
        DivergenceError: where, what, and what the model leaves out.
    """
    ice, end = state.numpy("solid_fraction"), liquidus.concentrations[-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        concentration = state.numpy("solute_mass") / state.numpy("liquid_mass")
    heat = state.numpy("liquid_heat") + state.numpy("ice_heat")
    for bad, say in (
        (
            ice >= 1.0,
            lambda i: (
                f"no liquid is left: ice would fill {ice[i]:.3f} of the room; the model leaves out that ice pushes "
                "liquid away, so cool it less or give it more solute"
            ),
        ),
        (
            concentration > end * (1.0 + BEYOND),
            lambda i: (
                f"the liquid holds {concentration[i]:.4g} of solute, beyond the end of the liquidus, {end:.4g}; the "
                "model leaves out the solid that forms at the eutectic, so cool it less"
            ),
        ),
        (~np.isfinite(heat), lambda i: "the heat is not a number"),
    ):
        if len(found := np.flatnonzero(bad)):
            i = found[0]
            raise DivergenceError(
                f"particle {state.numpy('id')[i]} at ({_shown(state.numpy('position')[i])}) m, before "
                f"t = {float(state.time.numpy()[0]):.6g} s: {say(i)}"
            )


def _shown(point: np.ndarray) -> str:
    return ", ".join(f"{x:.4g}" for x in point)
