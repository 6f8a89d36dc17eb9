"""The mass of each particle and the momentum of all, for ledgers."""

import numpy as np

from warpsph.core.content import Content
from warpsph.core.labels import Role
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import acts_at

FORCES = ("sum_forces", "add_forces", "sum_fast_forces", "add_fast_forces")
MOTION = ("prescribe", "kick_little", "kick", "move")  # where walls, friction and sources set velocities
ROUNDING = 1.0e-5  # relative: each step rounds the velocities of single precision, at random


def mass_by_id(state: State) -> Content:
    """Mass of each particle (n,) [kg] in the order of the ids; nothing in the reservoir."""
    mass = np.where(state.numpy("role") == Role.RESERVOIR, 0.0, state.numpy("mass").astype(float))
    return Content(mass[np.argsort(state.numpy("id"))], float(np.sum(mass)), "kg", 1e-12)


def momentum(model: Model, state: State, velocity: np.ndarray) -> dict[str, Content]:
    """Momentum along each axis [kg m/s], where every term that sets velocities says that it is kept; else nothing.

    Args:
        model, state: the case and its particles.
        velocity: of each of them (n, 3) [m/s].
    """
    acting = [term for term in model.terms if any(acts_at(term, moment) for moment in FORCES + MOTION)]
    free = np.all(state.numpy("role") == Role.FREE) and not np.any(model.gravity)
    if not (acting and free and all(term.keeps_momentum for term in acting)):
        return {}
    parts = state.numpy("mass").astype(float)[:, None] * velocity.astype(float)
    gross = float(np.sum(np.linalg.norm(parts, axis=1)))
    along = zip("xyz"[: model.dimension], parts.T, strict=False)
    return {f"momentum along {axis}": Content(float(np.sum(part)), gross, "kg m/s", ROUNDING) for axis, part in along}
