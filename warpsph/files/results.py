"""Reading results: frames, parameters, provenance and diagnostics of one result file."""

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from math import prod
from pathlib import Path

import h5py
import numpy as np

from warpsph.core.quantity import Quantity
from warpsph.errors import InputError, cut
from warpsph.files.described import place_of, read_quantity
from warpsph.files.guarded import GuardedFile, whole_number
from warpsph.files.stored_table import read_table
from warpsph.files.tables import Diagnosed
from warpsph.files.vtkhdf import read_step, read_times

LONGEST_REASON = 200  # letters


class ResultFile(Diagnosed):
    """A result file, whole or cut short by a killed run.

    Attributes:
        path: the file.
        times: times of the frames (S,) float64 [s].
        parameters: the resolved case.
        provenance: what made the file.
        diagnostics: time series by name (T,) or (T, m) float64, with ``time`` [s].
        quantities: what diagnostics are called and in which unit, in the order of their declaration.
        field_quantities: the same for the fields of the frames.
        events: (time [s], text) in the order in which they happened.

    Raises:
        InputError: the file is missing, damaged or none of ours.
    """

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        with self._open() as file:
            self.times: np.ndarray = read_times(file)
            self.parameters: dict = read_table(file, "warpsph/parameters")
            self.provenance: dict = self._read_provenance(file)
            self.diagnostics: dict[str, np.ndarray] = _read_diagnostics(file, "warpsph/diagnostics")
            self.quantities = _read_quantities(file, "warpsph/diagnostics")
            self.field_quantities = _read_quantities(file, "VTKHDF/PointData")
            self.events = _read_events(file, "warpsph/events")

    def frame(self, k: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        """Positions (n, 3) float32 [m] and fields by name, (n,) or (n, 3), of frame ``k``; -1 is the last."""
        if not -len(self.times) <= k < len(self.times):
            raise InputError(f"{self.path}: there is no frame {k}; it holds {len(self.times)} frames")
        with self._open() as file:
            return read_step(file, k % len(self.times))

    def nearest(self, time: float) -> int:
        """Number of the frame nearest to ``time`` [s]."""
        if len(self.times) == 0:
            raise InputError(f"{self.path}: holds no frame")
        return int(np.argmin(np.abs(self.times - time)))

    def _read_provenance(self, file: GuardedFile) -> dict:
        """What made the file; a run that was killed while it wrote this at its end has lost it, and nothing else."""
        try:
            return read_table(file, "warpsph/provenance")
        except OSError:
            warnings.warn(
                f"{self.path}: its run was killed while it wrote what made the file, which is lost", stacklevel=2
            )
            return {"status": "unfinished"}

    @contextmanager
    def _open(self) -> Iterator[GuardedFile]:
        """Open the file for one reading; a damaged one may raise anything inside HDF5, h5py or JSON."""
        if not os.path.isfile(self.path):
            what = "is no regular file" if os.path.exists(self.path) else "no such file"
            raise InputError(f"{self.path}: {'is a folder' if os.path.isdir(self.path) else what}")
        try:
            with h5py.File(self.path, "r", locking=False) as opened:
                file = GuardedFile(opened)
                if not (file.has("VTKHDF") and file.has("warpsph")):
                    raise InputError(f"{self.path}: is not a result file of warpsph")
                yield file
        except InputError:
            raise
        except PermissionError:
            raise InputError(f"{self.path}: may not be read") from None
        except Exception as error:
            reason = cut(" ".join(str(error).split()), LONGEST_REASON) or type(error).__name__
            raise InputError(f"{self.path}: is damaged or not a result file of warpsph ({reason})") from None


def _read_diagnostics(file: GuardedFile, path: str) -> dict[str, np.ndarray]:
    """All series, as far as they were written whole; what one of them lacks is not a number."""
    members = file.members(path)
    rows = max(0, min(whole_number(file.group(path), "Rows"), *file.dataset(members["time"]).shape))
    return {name: _padded(file, members[name], rows) for name in dict.fromkeys(("time", *members))}


def _padded(file: GuardedFile, path: str, rows: int) -> np.ndarray:
    """A series of so many rows."""
    shape = file.dataset(path).shape
    there = file.numbers(path, 0, min(rows, *shape[:1])).astype("f8")
    if len(there) == rows:
        return there
    missing = (rows - len(there), *shape[1:])
    file.spend(8.0 * prod(missing))
    return np.concatenate([there, np.full(missing, np.nan)])


def _read_quantities(file: GuardedFile, path: str) -> dict[str, Quantity]:
    """What the datasets of a group are, in the order of their declaration."""
    datasets = {name: file.dataset(member) for name, member in file.members(path).items()}
    return {name: read_quantity(datasets[name], name) for name in sorted(datasets, key=lambda n: place_of(datasets[n]))}


def _read_events(file: GuardedFile, path: str) -> list[tuple[float, str]]:
    rows = max(0, whole_number(file.group(path), "Rows"))
    times = file.numbers(f"{path}/time", 0, rows, "f").tolist()
    return list(zip(times, file.texts(f"{path}/text", rows), strict=True))
