"""Bonds between particles as lines, and arrows on those that fly off, in the plane."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from scipy.spatial import cKDTree

from warpsph.core.labels import Phase
from warpsph.errors import number
from warpsph.files.results import ResultFile
from warpsph.pictures.parts import Fields

MOST = 2000  # particles, above which single bonds could not be told apart
SHORTEST = 15.0  # bond that is drawn [points]; lines of shorter ones would cover the particles
MOST_PARTNERS = 40  # of a particle on average; more are no bonds
INK = "#26292e"
SHRUNK = 0.3  # diameter of a particle over the one without bonds
ARROW = 0.9  # length over that of a bond
SHAFT = 0.04  # its width over the length of a bond


@dataclass(frozen=True)
class Bonds:
    """What the file says of bonds.

    Attributes:
        length: longest distance of two solid particles that are bonded [m].
        fast: mean speed above which a fluid particle has an arrow [m/s]; None for no arrows.
    """

    length: float
    fast: float | None


def bonds_of(result: ResultFile, particles: int, scale: float) -> Bonds | None:
    """The bonds of a run in the plane that has some, where a picture of ``scale`` [points/m] has room for them."""
    known = result.provenance
    if "bond" not in known or known.get("dimension") != 2 or particles > MOST:
        return None
    length, fast = number(known["bond"]), number(known.get("fast"))
    drawn = scale * length >= SHORTEST and np.isfinite(length)
    return Bonds(length, fast if np.isfinite(fast) else None) if drawn else None


def bonded_pairs(points: np.ndarray, fields: Fields, bonds: Bonds) -> np.ndarray:
    """Pairs (m, 2) of indices of solid particles closer than a bond."""
    solid = np.flatnonzero(fields["phase"] == Phase.SOLID) if "phase" in fields else np.zeros(0, int)
    tree = cKDTree(points[solid]) if len(solid) > 1 else None
    if tree is None or tree.count_neighbors(tree, bonds.length) > MOST_PARTNERS * len(solid):
        return np.zeros((0, 2), int)
    return solid[tree.query_pairs(bonds.length, output_type="ndarray")]


def draw_bonds(axes: Axes, points: np.ndarray, fields: Fields, bonds: Bonds) -> list[Any]:
    """Draw lines and arrows; return what can be removed again."""
    pairs = bonded_pairs(points, fields, bonds)
    drawn: list[Any] = [
        axes.add_collection(LineCollection(list(points[pairs][:, :, :2]), colors=INK, linewidths=0.7), autolim=False)
    ]
    if bonds.fast is not None and {"phase", "mean_velocity"} <= set(fields):
        velocity = fields["mean_velocity"][:, :2]
        speed = np.linalg.norm(velocity, axis=1)
        fast = (fields["phase"] != Phase.SOLID) & (speed > bonds.fast)
        if np.any(fast):
            tips = ARROW * bonds.length * velocity[fast] / speed[fast, None]
            metres: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1.0, "units": "xy"}
            arrows = axes.quiver(*points[fast, :2].T, *tips.T, color=INK, width=SHAFT * bonds.length, **metres)
            drawn.append(arrows)
    return drawn
