"""Where the face of a wall is, seen from the particles behind it."""

from collections.abc import Mapping, Sequence

import numpy as np

from warpsph.core.labels import Role
from warpsph.errors import InputError, numbers, shown

# by the side of the box on which they are: the axis and the direction outwards
FACES: Mapping[str, tuple[int, int]] = {
    f"{sign}{name}": (axis, int(f"{sign}1")) for axis, name in enumerate("xyz") for sign in "-+"
}

BEYOND = 1.0e-6  # of an edge, by which a place is outside a box


def way_to_box(points: np.ndarray, lower: Sequence[float], upper: Sequence[float]) -> np.ndarray:
    """The shortest ways (n, 3) [m] from points (n, 3) [m] to a box of fluid: from walls around it to their faces.

    Args:
        points: of the walls.
        lower, upper: corners (3,) of the box [m]; infinite along axes along which it has no end.

    Raises:
        InputError: the corners are not three numbers each, the lower one first.
    """
    low, high = np.array(numbers(lower, 3)), np.array(numbers(upper, 3))
    if not np.all(low <= high):
        raise InputError(f"way_to_box: lower, upper = {lower}, {upper}: must be two corners [m], the lower one first")
    return np.clip(points, low, high) - points


def velocity_of_faces(way: np.ndarray, velocities: Mapping[str, Sequence[float]]) -> np.ndarray:
    """Velocities (n, 3) [m/s] of walls around a box whose faces move along themselves, each on its own.

    What stands behind an edge or a corner belongs to several faces and has their mean velocity. With that of one of
    them alone the fluid is driven into the corner and leaks out of it.

    Args:
        way: from the walls to their faces (n, 3) [m], as :func:`way_to_box` gives it.
        velocities: (3,) [m/s] of the faces "-x", "+x", "-y", ..., by the side of the box on which they are; the others
            rest.

    Raises:
        InputError: there is no such face, or a velocity is not three finite numbers.
    """
    behind = np.stack([way[:, axis] * side < 0.0 for axis, side in FACES.values()], axis=1)
    moving = np.zeros((len(FACES), 3))
    for face, velocity in velocities.items():
        if face not in FACES:
            raise InputError(f"velocity_of_faces: there is no face {shown(face)}; give {', '.join(FACES)}")
        if not np.all(np.isfinite(numbers(velocity, 3))):
            raise InputError(f"velocity_of_faces: {face} = {shown(velocity)}: must be three finite numbers [m/s]")
        moving[list(FACES).index(face)] = numbers(velocity, 3)
    return behind @ moving / np.maximum(behind.sum(axis=1, keepdims=True), 1)


def way_out_of_boxes(points: np.ndarray, boxes: Sequence[tuple[Sequence[float], Sequence[float]]]) -> np.ndarray:
    """The shortest straight ways (n, 3) [m], along an axis, from points (n, 3) [m] out of all of some boxes.

    Args:
        points: of walls that fluid flows around.
        boxes: corners (3,) of each [m], the lower one first; those of a wall and of what it encloses.
    """
    points = np.asarray(points, float)
    ways, lengths = np.zeros_like(points), np.full(len(points), np.inf)
    for face in range(2 * 3):
        axis, upper = divmod(face, 2)
        for box in boxes:
            ends = points.copy()
            ends[:, axis] = box[upper][axis]
            beyond = ends.copy()
            beyond[:, axis] += (2 * upper - 1) * BEYOND * abs(box[1][axis] - box[0][axis])
            length = np.abs(ends[:, axis] - points[:, axis])
            shorter = ~_inside(beyond, boxes) & (length < lengths)
            ways[shorter], lengths[shorter] = (ends - points)[shorter], length[shorter]
    return ways


def _inside(points: np.ndarray, boxes: Sequence[tuple[Sequence[float], Sequence[float]]]) -> np.ndarray:
    """Which of the points (n, 3) lie in a box."""
    return np.any([np.all((points >= low) & (points <= high), axis=1) for low, high in boxes], axis=0)


def require_faces(fields: Mapping[str, np.ndarray], flows: np.ndarray) -> None:
    """Refuse walls that were not told where their face is.

    Args:
        fields: start values (n, ...) as :meth:`warpsph.core.term.Term.start` has them.
        flows: which particles (n,) the fluid feels.

    Raises:
        InputError: there are such walls.
    """
    walls = np.isin(fields["role"], (Role.WALL, Role.DUMMY)) & flows
    if np.any(np.linalg.norm(fields["to_surface"][walls], axis=1) == 0.0):
        raise InputError("particles: walls need 'to_surface', the way [m] from each to the face of the wall")
