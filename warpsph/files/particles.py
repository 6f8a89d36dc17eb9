"""Particle files of other programs and of earlier runs, read as a start."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from warpsph.errors import InputError, cut, number, shown
from warpsph.files.columns import MATERIAL, read_columns
from warpsph.files.results import ResultFile
from warpsph.nearest import did_you_mean

AXES = ("x", "y", "z")
VELOCITIES = ("vx", "vy", "vz")
NUMBERED_ANEW = "id"
LONGEST_MATERIAL = 100  # letters of its name

Table = dict[str, np.ndarray]


def read_particles(
    path: str | Path, dimension: int, *, fields: Sequence[str] | None = None, time: float | None = None
) -> Table:
    """The particles of a file, as a table for :meth:`warpsph.core.particles.Particles.add_table`.

    ====================  ==============================================================================================
    ``.csv``              a header that names the columns: ``x``, ``y``, in 3D ``z``, and fields
    ``.npy``              positions (n, 2) or (n, 3), or a structured array with named columns
    ``.npz``              arrays by name: ``position`` (n, 2) or (n, 3), or ``x``, ``y``, ``z``; and fields
    ``.vtkhdf``           a result of warpsph
    ``.vtk``, ``.vtp``,   and other files of VTK that do not lead to further files: the points and their data
    ``.vtu``, ``.ply``
    ====================  ==============================================================================================

    A column is a field of the case, by its name and in its unit; ``vx``, ``vy``, ``vz`` make the velocity, and a column
    of texts may name the material. A column that no term of the case knows is refused when the simulation is built;
    ``fields`` leaves it out. Numbers of particles (``id``) are given anew. Particles of a result keep their role,
    material and phase; bonds, which no file holds, are made anew.

    Args:
        path: the file.
        dimension: 2 or 3, of the case.
        fields: columns to take besides the positions; all by default.
        time: of a result, the time [s] to whose nearest frame it is read; the last frame by default.

    Returns:
        "position" (n, 3) float64 [m], and the fields by name, (n,) or (n, 3).

    Raises:
        InputError: the file, what is wrong with it, and what is expected, in one line.
    """
    path = Path(path)
    if isinstance(fields, str):
        raise InputError(f"{path}: fields = '{fields}': must be a list of columns, as in ['{fields}']")
    if dimension not in (2, 3):
        raise InputError(f"{path}: dimension = {dimension!r}: must be 2 or 3, that of the case")
    if path.suffix.lower() == ".vtkhdf":
        table = _of_result(ResultFile(path), dimension, time)
    elif time is not None:
        raise InputError(f"{path}: time = {time!r}: only a result of warpsph (.vtkhdf) has frames; leave time out")
    else:
        table = _joined(path, read_columns(path))
    _refuse_bad_columns(path, table)
    table["position"] = _in_space(path, table["position"], dimension)
    if "velocity" in table and table["velocity"].shape[1:] == (2,):
        table["velocity"] = _with_depth(table["velocity"])
    table.pop(NUMBERED_ANEW, None)
    return table if fields is None else _selected(path, table, fields)


def _of_result(result: ResultFile, dimension: int, time: float | None) -> Table:
    """A frame of a result, its materials by their names."""
    if time is not None and not np.isfinite(number(time)):
        raise InputError(f"{result.path}: time = {time!r}: must be a number [s]")
    stored = result.provenance.get("dimension", dimension)
    if stored != dimension:
        raise InputError(f"{result.path}: is a result in {shown(stored)} dimensions; the case has {dimension}")
    points, fields = result.frame(-1 if time is None else result.nearest(time))
    names = result.provenance.get("materials")
    if MATERIAL in fields:
        indices = fields[MATERIAL]
        if indices.dtype.kind not in "iu" or indices.ndim != 1 or not isinstance(names, list):
            raise InputError(f"{result.path}: its particles have materials that it does not name")
        if np.any((indices < 0) | (indices >= len(names))):
            raise InputError(f"{result.path}: its particles have materials that it does not name")
        fields[MATERIAL] = np.array([cut(str(name), LONGEST_MATERIAL) for name in names], str)[indices]
    return {"position": points.astype(float), **fields}


def _joined(path: Path, columns: Mapping[str, np.ndarray]) -> Table:
    """Columns of coordinates as positions and velocities."""
    table = dict(columns)
    for name, parts in (("position", AXES), ("velocity", VELOCITIES)):
        given = [part for part in parts if part in table]
        if not given:
            continue
        if name in table or given != list(parts[: max(len(given), 2)]):
            found = ", ".join([*given, *([name] if name in table else [])])
            raise InputError(f"{path}: has {found}; give {', '.join(parts[:2])} and in 3D {parts[2]}, or {name} alone")
        coordinates = [table.pop(part) for part in given]
        _refuse_bad_columns(path, dict(zip(given, coordinates, strict=True)))
        table[name] = np.stack(coordinates, axis=-1)
    if "position" not in table:
        found = ", ".join(table) or "none"
        raise InputError(f"{path}: has no columns x, y and in 3D z, nor position; its columns: {found}")
    return table


def _refuse_bad_columns(path: Path, table: Mapping[str, np.ndarray]) -> None:
    """All columns have as many rows, and numbers in them; names of materials apart."""
    rows = {name: len(values) if values.ndim else 1 for name, values in table.items()}
    first, count = next(iter(rows.items()))
    if not any(rows.values()):
        raise InputError(f"{path}: holds no particles")
    for name, values in table.items():
        if rows[name] != count:
            raise InputError(f"{path}: '{name}' has {rows[name]} rows and '{first}' has {count}; give as many")
        if name == MATERIAL and values.dtype.kind in "UO":
            continue
        if values.dtype.kind not in "biuf":
            raise InputError(f"{path}: '{name}' holds {values.dtype} values; numbers are needed")
        bad = ~np.isfinite(values).reshape(count, -1).all(axis=1)
        if np.any(bad):
            where = f"{int(bad.sum())} of {count} rows, first in row {int(np.argmax(bad)) + 1}"
            raise InputError(f"{path}: '{name}' is not a finite number in {where}")


def _in_space(path: Path, position: np.ndarray, dimension: int) -> np.ndarray:
    """Positions (n, 3), refused where they do not have the dimension of the case."""
    if position.ndim != 2 or position.shape[1] not in (2, 3):
        raise InputError(f"{path}: its positions have the shape {position.shape}; give (n, 2) or (n, 3)")
    if dimension == 3 and position.shape[1] == 2:
        raise InputError(f"{path}: its positions have two coordinates; the case has three dimensions: give x, y, z")
    if dimension == 2 and position.shape[1] == 3 and np.any(position[:, 2] != 0.0):
        raise InputError(f"{path}: has positions with z other than 0; the case has two dimensions: give x, y")
    return (position if position.shape[1] == 3 else _with_depth(position)).astype(float)


def _with_depth(vectors: np.ndarray) -> np.ndarray:
    """Vectors (n, 3) of those in the plane (n, 2)."""
    return np.column_stack([vectors, np.zeros(len(vectors), vectors.dtype)])


def _selected(path: Path, table: Table, fields: Sequence[str]) -> Table:
    for name in fields:
        if name not in table:
            raise InputError(f"{path}: has no column '{name}'{did_you_mean(name, table)}")
    return {name: table[name] for name in ("position", *fields)}
