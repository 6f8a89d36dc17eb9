"""Reading results: frames, parameters, provenance and diagnostics of one result file."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np

from warpsph.core.quantity import Quantity
from warpsph.errors import InputError
from warpsph.files.described import place_of, read_quantity
from warpsph.files.tables import Diagnosed
from warpsph.files.vtkhdf import read_step, read_times


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
            self.parameters: dict = _read_json(file["warpsph/parameters"])
            self.provenance: dict = _read_json(file["warpsph/provenance"])
            self.diagnostics: dict[str, np.ndarray] = _read_diagnostics(file["warpsph/diagnostics"])
            self.quantities = _read_quantities(file["warpsph/diagnostics"])
            self.field_quantities = _read_quantities(file["VTKHDF/PointData"])
            self.events = _read_events(file["warpsph/events"])

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

    @contextmanager
    def _open(self) -> Iterator[h5py.File]:
        """Open the file for one reading; a damaged one may raise anything inside HDF5, h5py or JSON."""
        if not self.path.is_file():
            raise InputError(f"{self.path}: {'is a folder' if self.path.is_dir() else 'no such file'}")
        try:
            with h5py.File(self.path, "r", locking=False) as file:
                if "VTKHDF" not in file or "warpsph" not in file:
                    raise InputError(f"{self.path}: is not a result file of warpsph")
                yield file
        except InputError:
            raise
        except PermissionError:
            raise InputError(f"{self.path}: may not be read") from None
        except Exception as error:
            reason = " ".join(str(error).split()) or type(error).__name__
            raise InputError(f"{self.path}: is damaged or not a result file of warpsph ({reason})") from None


def _read_json(dataset: h5py.Dataset) -> dict:
    values = json.loads(dataset.asstr()[()])
    if not isinstance(values, dict):
        raise ValueError(f"{dataset.name} holds no table")
    return values


def _read_diagnostics(group: h5py.Group) -> dict[str, np.ndarray]:
    """All series, as far as they were written whole."""
    rows = int(group.attrs["Rows"])
    return {name: group[name][:rows].astype("f8") for name in dict.fromkeys(("time", *group))}


def _read_quantities(group: h5py.Group) -> dict[str, Quantity]:
    """What the datasets of a group are, in the order of their declaration."""
    return {name: read_quantity(group[name]) for name in sorted(group, key=lambda name: place_of(group[name]))}


def _read_events(group: h5py.Group) -> list[tuple[float, str]]:
    rows = int(group.attrs["Rows"])
    return list(zip(group["time"][:rows].tolist(), group["text"].asstr()[:rows].tolist(), strict=True))
