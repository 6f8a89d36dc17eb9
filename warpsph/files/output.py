"""Writing results: the frames as VTKHDF and, beside them, what made them and what was measured on the way."""

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np

from warpsph.core.quantity import Quantity, undeclared
from warpsph.errors import InputError, WarpsphError
from warpsph.files.continuation import Counts, cut_back, refuse_other_run
from warpsph.files.described import attributes_of
from warpsph.files.results import ResultFile
from warpsph.files.vtkhdf import STEPS_PER_CHUNK, append_step, commit, create_layout, extendable, put

TIME = Quantity("time", "s")


class ResultWriter:
    """Writes one result file; after every frame and when it is killed the file is readable.

    Groups: ``/VTKHDF`` (the frames), ``/warpsph/parameters`` and ``/warpsph/provenance`` (JSON texts),
    ``/warpsph/diagnostics/<name>`` (float64, one row a time) and ``/warpsph/events/{time,text}``, of which the
    attribute ``Rows`` counts what is whole.

    Args:
        path: the file to make.
        parameters: the resolved case.
        provenance: what made the file; its ``status`` is "unfinished" until :meth:`finish`.
        overwrite: whether an existing file is replaced.
        quantities: what the fields of the frames are called and in which unit; pictures read it.

    Raises:
        InputError: the file exists and ``overwrite`` is false, or it cannot be made; an older file stays as it was.
    """

    def __init__(
        self,
        path: str | Path,
        parameters: dict,
        provenance: dict,
        overwrite: bool = False,
        quantities: dict[str, Quantity] | None = None,
    ) -> None:
        if not isinstance(path, str | Path):
            raise InputError(f"output = {path!r}: must be the name of a file")
        self.path = Path(path)
        places = enumerate((quantities or {}).items())
        self._attributes = {name: attributes_of(quantity, place) for place, (name, quantity) in places}
        self._provenance = {"status": "unfinished"} | provenance
        _check_target(self.path, overwrite)
        unfinished = self.path.with_name(f".{self.path.name}.{os.getpid()}")
        try:
            with h5py.File(unfinished, "w", locking=False) as file:
                create_layout(file)
                group = file.create_group("warpsph")
                group["parameters"] = _as_json(parameters)
                group["provenance"] = _as_json(self._provenance)
                extendable(group, "diagnostics/time", (), "f8", STEPS_PER_CHUNK)
                group["diagnostics/time"].attrs.update(attributes_of(TIME))
                extendable(group, "events/time", (), "f8", STEPS_PER_CHUNK)
                extendable(group, "events/text", (), h5py.string_dtype(), STEPS_PER_CHUNK)
                for series in (group["diagnostics"], group["events"]):
                    series.attrs["Rows"] = np.int64(0)
            os.replace(unfinished, self.path)
            # without a lock, so that a run can be looked at while it goes on
            self._file = h5py.File(self.path, "r+", locking=False)
        except OSError as error:
            unfinished.unlink(missing_ok=True)
            raise InputError(f"{self.path}: cannot be written: {error.strerror or error}") from None

    @classmethod
    def continued(cls, path: str | Path, parameters: dict, counts: Counts) -> "ResultWriter":
        """Go on writing the file of a run that is resumed; what was written after its checkpoint is taken back.

        Args:
            path: the file.
            parameters: the resolved case; what may change in a run, such as its duration, may be another than before.
            counts: what :meth:`counts` gave for the checkpoint.

        Raises:
            InputError: it is the file of another run, or holds less than the checkpoint.
        """
        before = ResultFile(path)
        refuse_other_run(before, counts)
        writer = cls.__new__(cls)
        writer.path, writer._attributes = before.path, {}
        writer._provenance = before.provenance | {"status": "unfinished"}
        with writer._writing():
            writer._file = h5py.File(before.path, "r+", locking=False)
            cut_back(writer._file, counts)
            writer._file["warpsph/parameters"][()] = _as_json(parameters)
            writer._file["warpsph/provenance"][()] = _as_json(writer._provenance)
            writer._file.flush()
        return writer

    def counts(self) -> dict[str, str | int]:
        """How much the file holds, and the name of its run; a checkpoint keeps it."""
        group = self._file["warpsph"]
        return {
            "run": self._provenance.get("run", ""),
            "frames": int(self._file["VTKHDF/Steps"].attrs["NSteps"]),
            "diagnostics": int(group["diagnostics"].attrs["Rows"]),
            "events": int(group["events"].attrs["Rows"]),
        }

    def write_frame(self, time: float, points: np.ndarray, fields: dict[str, np.ndarray]) -> None:
        """Append a frame and flush.

        Args:
            time: physical time [s].
            points: positions (n, 3) [m]; n differs from frame to frame.
            fields: (n,) or (n, 3), float32 or int32, with the same names in every frame.
        """
        with self._writing():
            append_step(self._file, time, np.asarray(points, "f4"), fields, self._attributes)

    def write_diagnostics(
        self, time: float, values: dict[str, float | np.ndarray], quantities: dict[str, Quantity] | None = None
    ) -> None:
        """Append a row to the time series.

        Args:
            time: physical time [s].
            values: numbers, or arrays of a fixed shape. What is missing in a row is not a number there.
            quantities: what they are called and in which unit.
        """
        with self._writing():
            group = self._file["warpsph/diagnostics"]
            row = int(group.attrs["Rows"])
            for name, value in values.items():
                if name not in group:
                    extendable(group, name, np.shape(value), "f8", STEPS_PER_CHUNK)
                    quantity = (quantities or {}).get(name, undeclared(name))
                    group[name].attrs.update(attributes_of(quantity, len(group)))
                    put(group[name], 0, np.full((row, *np.shape(value)), np.nan))
            for name, series in group.items():
                if name != "time":
                    put(series, row, [values.get(name, np.full(series.shape[1:], np.nan))])
            put(group["time"], row, [time])
            commit(group, "Rows", row + 1)

    def write_event(self, time: float, text: str) -> None:
        """Append something that happened, for example a breakout, at ``time`` [s]."""
        with self._writing():
            events = self._file["warpsph/events"]
            row = int(events.attrs["Rows"])
            put(events["text"], row, [text])
            put(events["time"], row, [time])
            commit(events, "Rows", row + 1)

    def finish(self, **provenance) -> None:
        """Add what is known only at the end, for example ``wall_time``, ``steps`` and ``status``."""
        self._provenance |= provenance
        with self._writing():
            self._file["warpsph/provenance"][()] = _as_json(self._provenance)
            self._file.flush()

    def close(self) -> None:
        """Close the file; nothing can be written afterwards."""
        self._file.close()

    def __enter__(self) -> "ResultWriter":
        return self

    def __exit__(self, *exception) -> None:
        self.close()

    @contextmanager
    def _writing(self) -> Iterator[None]:
        """A full disk becomes one line."""
        try:
            yield
        except OSError as error:
            raise WarpsphError(f"{self.path}: writing failed, the frames before this are safe: {error}") from None


def _check_target(path: Path, overwrite: bool) -> None:
    if path.is_dir():
        raise InputError(f"{path}: is a folder; give the name of a file")
    if not path.parent.is_dir():
        raise InputError(f"{path}: there is no folder {path.parent}; make it first")
    if path.exists() and not overwrite:
        raise InputError(f"{path}: exists already; choose another name, or give overwrite=True to replace it")


def _as_json(values: dict) -> str:
    return json.dumps(values, default=_plain, allow_nan=True)


def _plain(value):
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, Path):
        return str(value)
    raise TypeError(f"{value!r} cannot be stored as JSON")
