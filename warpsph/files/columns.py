"""The columns of particle files, as they stand there: CSV, NumPy, and what PyVista reads."""

import csv
import logging
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from warpsph.errors import InputError

Columns = dict[str, np.ndarray]

PARAVIEW = {"Points:0": "x", "Points:1": "y", "Points:2": "z"}  # as it calls positions in its CSV
MATERIAL = "material"  # the column that may hold names


def read_columns(path: Path) -> Columns:
    """The columns of a file by name, (n,) or (n, k), positions that have no name as "position".

    Raises:
        InputError: the file cannot be read; one line says which and why.
    """
    if not path.is_file():
        raise InputError(f"{path}: {'is a folder' if path.is_dir() else 'no such file'}; give a file of particles")
    if path.stat().st_size == 0:
        raise InputError(f"{path}: is empty; give a file of particles")
    read = {".csv": _read_csv, ".npy": _read_numpy, ".npz": _read_numpy}.get(path.suffix.lower(), _read_vtk)
    try:
        return read(path)
    except InputError:
        raise
    except PermissionError:
        raise InputError(f"{path}: may not be read") from None
    except Exception as error:  # a damaged file may raise anything inside a reader
        reason = " ".join(str(error).split())[:120] or type(error).__name__
        raise InputError(f"{path}: is damaged or no file of particles ({reason})") from None


def _read_csv(path: Path) -> Columns:
    with path.open(newline="", encoding="utf-8-sig") as file:
        reader = csv.reader(file)
        rows = [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    if not rows:
        raise InputError(f"{path}: is empty; its first line must name the columns, such as x,y,temperature")
    names = [PARAVIEW.get(name.strip(), name.strip()) for name in rows.pop(0)[1]]
    _refuse_other_forms(path, names)
    for name in names:
        if not name or names.count(name) > 1:
            what = f"two columns are called '{name}'" if name else "a column has no name"
            raise InputError(f"{path}: {what}; its first line must name each column, such as x,y,temperature")
    for line, row in rows:
        if len(row) != len(names):
            raise InputError(f"{path}: line {line} has {len(row)} values; the header names {len(names)} columns")
    return {
        name: np.array([row[k].strip() for _, row in rows], str) if name == MATERIAL else _numbers(path, name, k, rows)
        for k, name in enumerate(names)
    }


def _refuse_other_forms(path: Path, names: list[str]) -> None:
    """A header that is no list of names with commas between them."""
    if len(names) == 1 and any(sign in names[0] for sign in ";\t "):
        raise InputError(f"{path}: its columns are not parted by commas; write them as in x,y,temperature")
    if any(_is_number(name) for name in names):
        raise InputError(f"{path}: has no header; its first line must name the columns, such as x,y,temperature")


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _numbers(path: Path, name: str, place: int, rows: list[tuple[int, list[str]]]) -> np.ndarray:
    """One column (n,) of a CSV file as numbers."""
    values = np.empty(len(rows))
    for k, (line, row) in enumerate(rows):
        try:
            values[k] = float(row[place])
        except ValueError:
            raise InputError(f"{path}: line {line}: '{name}' is '{row[place]:.40}'; a number is needed") from None
    return values


def _read_numpy(path: Path) -> Columns:
    content = np.load(path, allow_pickle=False)
    if not isinstance(content, np.ndarray):
        with content:
            return dict(content)
    if content.dtype.names is None:
        return {"position": content}
    return {name: content[name] for name in content.dtype.names}


def _read_vtk(path: Path) -> Columns:
    import pyvista  # takes long to import

    with _told_once(), pyvista.vtk_verbosity("off"), pyvista.VtkErrorCatcher(send_to_logging=False) as found:
        mesh = pyvista.read(path)
    if found.error_events:
        raise ValueError(found.error_events[0].alert)
    if not isinstance(mesh, pyvista.DataSet):
        raise InputError(f"{path}: holds a {type(mesh).__name__}, not one set of points; extract one of its blocks")
    return {"position": np.array(mesh.points), **{name: np.array(data) for name, data in mesh.point_data.items()}}


@contextmanager
def _told_once() -> Iterator[None]:
    """Keep from standard error what PyVista says and warns of a damaged file, in many lines: an error will tell."""
    before = logging.root.manager.disable
    logging.disable(logging.ERROR)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        logging.disable(before)
