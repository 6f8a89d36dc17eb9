"""Whether single precision and the periodic box suit the places that particles are given at the start."""

import numpy as np
from scipy.spatial import cKDTree

from warpsph.core.labels import Role
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError

COARSEST = (
    0.01  # of a spacing, between two numbers of single precision: the error of a tank at rest grows from there on
)
APART = 0.4  # spacings by which two rows differ at least
WELL_FITTED = 0.02  # of the distance of two rows, by which the one across the border may differ
EVEN = 0.1  # of the distance of two rows, by which it may spread where there are rows at all
OPEN = 1.9  # rows, from which on the border is no matter of one row more or less
LYING_ON_EACH_OTHER = 0.4  # spacings


def refuse_misplaced(model: Model, particles: Particles) -> None:
    """Refuse places at which the particles would not be what they were meant to be; those in a reservoir are nowhere.

    Raises:
        InputError: single precision is too coarse there, or particles do not fit into the periodic box.
    """
    there = particles.role != Role.RESERVOIR
    places, box = particles.position[there], model.periodic
    if len(places) == 0:
        return
    _refuse_coarse(model.spacing, places if box is None else box.wrapped(places))
    if box is not None:
        for axis in box.axes:
            _refuse_misfit(box, axis, places[:, axis], model.spacing)
        _refuse_overlap(box, places, particles.material[there], model.spacing)


def _refuse_coarse(spacing: float, places: np.ndarray) -> None:
    farthest = float(np.max(np.abs(places)))
    grid = float(np.spacing(np.float32(farthest)))
    if not grid <= COARSEST * spacing:
        raise InputError(
            f"particles: {farthest:.3g} m from the origin single precision knows places {grid:.2g} m apart, and the "
            f"spacing is {spacing:.3g} m: at most {COARSEST:.0%} of it are allowed; move the case nearer to the origin"
        )


def _refuse_misfit(box: PeriodicBox, axis: int, places: np.ndarray, spacing: float) -> None:
    """Rows at ``places`` (n,) [m] along a periodic axis must be as far from each other across the border as inside."""
    rows = _rows(places, APART * spacing)
    if len(rows) < 4:
        return
    between = np.diff(rows)
    pitch, spread = float(np.median(between)), float(np.std(between))
    across = float(box.edges[axis] - (rows[-1] - rows[0]))
    misfit = across - pitch
    if spread < EVEN * pitch and 0.0 < across < OPEN * pitch and abs(misfit) > WELL_FITTED * pitch + 4.0 * spread:
        name = "xyz"[axis]
        what = "a gap" if misfit > 0.0 else "an overlap"
        raise InputError(
            f"PeriodicBox: a length of {box.edges[axis]:.6g} m along {name} leaves {what} of {abs(misfit):.3g} m at "
            f"its border: {len(rows)} rows {pitch:.6g} m apart fill {box.edges[axis] - misfit:.6g} m; give that length"
        )


def _rows(places: np.ndarray, apart: float) -> np.ndarray:
    """Mean places (rows,) [m] of particles whose ``places`` (n,) [m] come in groups that are ``apart``."""
    places = np.sort(places)
    groups = np.split(places, np.flatnonzero(np.diff(places) > apart) + 1)
    return np.array([group.mean() for group in groups])


def _refuse_overlap(box: PeriodicBox, places: np.ndarray, materials: np.ndarray, spacing: float) -> None:
    """What was apart as it was given must not come to lie on each other in the box; other cases mean to be so."""
    edges, lower = box.edges, np.asarray(box.lower)
    in_box = np.where(edges > 0.0, np.mod(places - lower, np.where(edges > 0.0, edges, np.inf)), places)
    in_box = np.where(in_box >= np.where(edges > 0.0, edges, np.inf), 0.0, in_box)
    beyond = (edges > 0.0) & ((places < lower) | (places > lower + edges))
    outside = np.flatnonzero(np.any(beyond, axis=1))
    if len(outside) == 0:
        return
    distances, nearest = cKDTree(in_box, boxsize=edges).query(
        in_box[outside], k=2, distance_upper_bound=LYING_ON_EACH_OTHER * spacing
    )
    for near, other in zip(distances.T, nearest.T, strict=True):
        found = np.isfinite(near) & (other != outside)
        apart = np.linalg.norm(places[outside[found]] - places[other[found]], axis=1) > LYING_ON_EACH_OTHER * spacing
        if np.any(apart) and _least_distance(places) > LYING_ON_EACH_OTHER * spacing:
            i, j = int(outside[found][apart][0]), int(other[found][apart][0])
            axis = int(np.flatnonzero(beyond[i])[0])
            names = " and ".join(f"{_name(materials[k])} at {_place(places[k])}" for k in (i, j))
            raise InputError(
                f"PeriodicBox: its length of {edges[axis]:.6g} m along {'xyz'[axis]} brings {names} onto each other; "
                f"leave out what stands beyond the box there, such as walls, or give a length that holds all"
            )


def _least_distance(places: np.ndarray) -> float:
    """Of two particles [m], as they were given."""
    return float(cKDTree(places).query(places, k=2)[0][:, 1].min())


def _name(material: str | None) -> str:
    return "particles" if material is None else f"'{material}'"


def _place(place: np.ndarray) -> str:
    return f"({', '.join(f'{x:.4g}' for x in place)}) m"
