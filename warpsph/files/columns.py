"""The columns of particle files, as they stand there: CSV, NumPy, and what PyVista reads."""

import csv
import io
import os
import subprocess
import sys
import zipfile
from collections import Counter
from pathlib import Path

import numpy as np

from warpsph.errors import InputError, cut, printable

Columns = dict[str, np.ndarray]

PARAVIEW = {"Points:0": "x", "Points:1": "y", "Points:2": "z"}  # as it calls positions in its CSV
MATERIAL = "material"  # the column that may hold names
LONGEST_NAME = 100  # letters of a material or a column
MOST_COLUMNS = 1000
LARGEST_RATIO, LEAST_BYTES = 16, 2**28  # what may unfold, over its size in the file; what may in any case
SECONDS, BYTES_PER_SECOND = 60.0, 1e6  # after which VTK has lost itself
VTK_SUFFIXES = (".vtk", ".vtp", ".vtu", ".vti", ".vtr", ".vts", ".ply", ".stl", ".obj")  # none leads to other files


def read_columns(path: Path) -> Columns:
    """The columns of a file by name, (n,) or (n, k), positions that have no name as "position".

    Raises:
        InputError: the file cannot be read; one line says which and why.
    """
    if not os.path.isfile(path):
        what = "is no regular file" if os.path.exists(path) else "no such file"
        raise InputError(f"{path}: {'is a folder' if os.path.isdir(path) else what}; give a file of particles")
    if path.stat().st_size == 0:
        raise InputError(f"{path}: is empty; give a file of particles")
    readers = {".csv": _read_csv, ".npy": _read_numpy, ".npz": _read_numpy, **dict.fromkeys(VTK_SUFFIXES, _read_vtk)}
    read = readers.get(path.suffix.lower())
    if read is None:
        raise InputError(f"{path}: files of particles end in {', '.join(readers)} or .vtkhdf")
    try:
        columns = read(path)
        if len(columns) > MOST_COLUMNS:
            raise InputError(f"{path}: has {len(columns)} columns; at most {MOST_COLUMNS} are read")
        return {cut(printable(name), LONGEST_NAME): values for name, values in columns.items()}
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
    for name, count in Counter(names).items():
        if not name or count > 1:
            what = f"two columns are called '{name}'" if name else "a column has no name"
            raise InputError(f"{path}: {what}; its first line must name each column, such as x,y,temperature")
    for line, row in rows:
        if len(row) != len(names):
            raise InputError(f"{path}: line {line} has {len(row)} values; the header names {len(names)} columns")
    return {
        name: np.array([cut(row[k].strip(), LONGEST_NAME) for _, row in rows], str)
        if name == MATERIAL
        else _numbers(path, name, k, rows)
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
    if path.suffix.lower() == ".npz":
        with zipfile.ZipFile(path) as packed:
            unfolded = sum(entry.file_size for entry in packed.infolist())
        if unfolded > max(LARGEST_RATIO * path.stat().st_size, LEAST_BYTES):
            raise ValueError(f"it unfolds to {unfolded:.3g} bytes, more than {LARGEST_RATIO} times its size")
    # from the disk, where an array that claims to be larger than its file is found out
    content = np.load(path, mmap_mode="r", allow_pickle=False)
    if not isinstance(content, np.ndarray):
        with content:
            return dict(content)
    if content.dtype.names is None:
        return {"position": np.array(content)}
    return {name: np.array(content[name]) for name in content.dtype.names}


def _read_vtk(path: Path) -> Columns:
    """What VTK reads, in a process of its own: of a damaged file it may take all memory or die."""
    size = path.stat().st_size
    command = [sys.executable, "-P", "-m", "warpsph.files.vtk_columns", str(path.absolute()), str(size)]
    limit = SECONDS + size / BYTES_PER_SECOND
    one_thread = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    try:
        done = subprocess.run(command, capture_output=True, timeout=limit, env=one_thread)
    except subprocess.TimeoutExpired:
        raise ValueError(f"VTK has not read it in {limit:.0f} s") from None
    if done.returncode == InputError.exit_code:
        raise ValueError(done.stderr.decode(errors="replace"))
    if done.returncode:
        raise ValueError("VTK cannot read it")
    with np.load(io.BytesIO(done.stdout), allow_pickle=False) as columns:
        return dict(columns)
