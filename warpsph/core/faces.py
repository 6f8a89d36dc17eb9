"""Where the face of a wall is, seen from the particles behind it."""

from collections.abc import Sequence

import numpy as np

from warpsph.errors import InputError, numbers


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
