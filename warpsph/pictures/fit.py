"""What of a frame can be drawn: places that are numbers and near, labels that are labels. A file may hold any."""

import warnings
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from warpsph.core.labels import Role
from warpsph.errors import InputError
from warpsph.pictures.parts import Fields

FARTHEST = 1.0e9  # place that is drawn [m]
MOST_LABELS = 50  # all beyond are one
LABELS = ("role", "phase", "material")
SHAPES: Mapping[str, tuple[int, ...]] = {
    **dict.fromkeys((*LABELS, "temperature"), ()),
    **dict.fromkeys(("velocity", "mean_velocity"), (3,)),
}


def fit_to_draw(path: Path, points: np.ndarray, fields: Fields) -> tuple[np.ndarray, Fields]:
    """A frame as pictures need it: with roles, and without particles whose places are no numbers or far away.

    Args:
        path: of the file.
        points: positions (n, 3) [m].
        fields: by name, (n,) or (n, k).

    Raises:
        InputError: a field has not the shape or the kind that its name promises.
    """
    for name, shape in SHAPES.items():
        if name in fields and fields[name].shape[1:] != shape:
            raise InputError(
                f"{path}: {name} has the shape {fields[name].shape}; ({len(points)}, ...{shape}) is needed"
            )
    fields = {"role": np.full(len(points), int(Role.FREE)), **fields}
    for name in LABELS:
        if name in fields:
            fields[name] = _labels(path, name, fields[name])
    fields["role"] = np.where(np.isin(fields["role"], list(Role)), fields["role"], int(Role.FREE))
    near = np.all(np.abs(points) <= FARTHEST, axis=1)
    if np.all(near):
        return points, fields
    warnings.warn(f"{path}: particles without a place within {FARTHEST:g} m are not drawn", stacklevel=2)
    return points[near], {name: values[near] for name, values in fields.items()}


def _labels(path: Path, name: str, values: np.ndarray) -> np.ndarray:
    if values.dtype.kind not in "iub":
        raise InputError(f"{path}: {name} holds {values.dtype} values; integers are needed")
    labels = values.astype(np.int64)
    return np.where((labels >= 0) & (labels < MOST_LABELS), labels, MOST_LABELS)
