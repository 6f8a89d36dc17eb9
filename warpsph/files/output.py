"""Writing results: the frames as VTKHDF and, beside them, what made them and what was measured on the way."""

import atexit
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np

from warpsph.core.quantity import Quantity, undeclared
from warpsph.errors import InputError, WarpsphError
from warpsph.files.beside import cannot_be_written
from warpsph.files.continuation import Counts, cut_back, refuse_other_run
from warpsph.files.described import attributes_of
from warpsph.files.disk import Disk
from warpsph.files.placement import Placement
from warpsph.files.results import ResultFile
from warpsph.files.vtkhdf import STEPS_PER_CHUNK, append_step, commit, create_layout, extendable, put

TIME = Quantity("time", "s")
ROOM = 2048  # bytes by which the provenance may grow in its place, for which a full disk has no other


class ResultWriter:
    """Writes one result file, which appears with its first frame; from then on it is readable, whatever happens.

    Groups: ``/VTKHDF`` (the frames), ``/warpsph/parameters`` and ``/warpsph/provenance`` (JSON texts),
    ``/warpsph/diagnostics/<name>`` (float64, one row a time) and ``/warpsph/events/{time,text}``, of which the
    attribute ``Rows`` counts what is whole.

    Args:
        path: the file to make; where it is a symbolic link, what it points to.
        parameters: the resolved case.
        provenance: what made the file; its ``status`` is "unfinished" until :meth:`finish`.
        overwrite: whether an existing file is replaced, when the first frame is whole.
        quantities: what the fields of the frames are called and in which unit; pictures read it.

    Raises:
        InputError: the file exists and ``overwrite`` is false, it cannot be made, or another run writes it; an older
            file stays as it was.
        WarpsphError: the disk is full or broken; an older file stays as it was.
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
        self._failed = ""
        self._place = Placement(self.path, overwrite)
        self._disk = Disk(self._place.descriptor)
        self._file = h5py.File(self._disk, "w")
        atexit.register(self.close)  # HDF5 would write through an interpreter that has gone
        try:
            self._begin(parameters)
            self._file.flush()
            self._disk.commit()
        except BaseException as error:
            self.close()
            if isinstance(error, OSError):
                raise cannot_be_written(self.path, error) from None
            raise

    def _begin(self, parameters: dict) -> None:
        create_layout(self._file)
        group = self._file.create_group("warpsph")
        group["parameters"] = _as_json(parameters)
        self._keep_provenance()
        extendable(group, "diagnostics/time", (), "f8", STEPS_PER_CHUNK)
        group["diagnostics/time"].attrs.update(attributes_of(TIME))
        extendable(group, "events/time", (), "f8", STEPS_PER_CHUNK)
        extendable(group, "events/text", (), h5py.string_dtype(), STEPS_PER_CHUNK)
        for series in (group["diagnostics"], group["events"]):
            series.attrs["Rows"] = np.int64(0)

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
        writer = cls.__new__(cls)
        writer.path, writer._attributes, writer._failed = Path(path), {}, ""
        writer._place = Placement(writer.path, overwrite=True, existing=True)
        try:
            before = ResultFile(path)
            refuse_other_run(before, counts)
            writer._provenance = before.provenance | {"status": "unfinished"}
            writer._disk = Disk(writer._place.descriptor)
            writer._file = h5py.File(writer._disk, "r+")
        except BaseException:
            writer._place.close()
            raise
        atexit.register(writer.close)
        with writer._writing():
            cut_back(writer._file, counts)
            del writer._file["warpsph/parameters"]
            writer._file["warpsph/parameters"] = _as_json(parameters)
            writer._keep_provenance()
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
        """Add what is known only at the end, for example ``wall_time``, ``steps`` and ``status``.

        Where a writing has failed before, the reason is added too, and it is no error if the disk has no room for that.
        """
        self._provenance |= provenance
        try:
            with self._writing(appears=False):
                self._keep_provenance()
                self._file.flush()
            os.fsync(self._place.descriptor)
        except (OSError, WarpsphError) as error:
            if not self._failed:
                raise error if isinstance(error, WarpsphError) else self._trouble(error) from None

    def close(self) -> None:
        """Close the file; nothing can be written afterwards. A file without a frame is not kept."""
        atexit.unregister(self.close)
        self._disk.sink()
        self._file.close()
        self._place.close()

    def __enter__(self) -> "ResultWriter":
        return self

    def __exit__(self, *exception) -> None:
        self.close()

    @contextmanager
    def _writing(self, appears: bool = True) -> Iterator[None]:
        """What is written inside is in the file as a whole or not at all; a full disk becomes one line."""
        try:
            self._place.refuse_removed()
            yield
            self._file.flush()
            self._disk.commit()
            if appears:
                self._place.appear()
        except BaseException as error:
            failure = self._disk.failure or (error if isinstance(error, OSError) else None)
            self._take_back()
            if failure is not None:
                raise self._trouble(failure) from None
            raise

    def _take_back(self) -> None:
        """Go back to what was whole, in the file and in HDF5's memory of it."""
        self._disk.sink()
        self._file.close()
        try:
            self._disk.roll_back()
        except OSError as error:
            raise WarpsphError(f"{self.path}: writing failed, and the file may be damaged: {_reason(error)}") from None
        self._disk = Disk(self._place.descriptor)
        self._file = h5py.File(self._disk, "r+")

    def _trouble(self, error: OSError) -> WarpsphError:
        self._failed = _reason(error)
        self._provenance["reason"] = self._failed
        if not self._place.appeared:
            return cannot_be_written(self.path, error)
        return WarpsphError(f"{self.path}: writing failed, the frames before this are safe: {self._failed}")

    def _keep_provenance(self) -> None:
        """Write the provenance in its place, or where it has outgrown that, in a new one."""
        group, text = self._file["warpsph"], _as_json(self._provenance).encode()
        if "provenance" in group and group["provenance"].dtype.itemsize < len(text):
            del group["provenance"]
        if "provenance" not in group:
            group.create_dataset("provenance", (), h5py.string_dtype("utf-8", len(text) + ROOM))
        group["provenance"][()] = text


def _reason(error: OSError) -> str:
    return error.strerror or str(error)


def _as_json(values: dict) -> str:
    return json.dumps(values, default=_plain, allow_nan=True)


def _plain(value):
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, Path):
        return str(value)
    raise TypeError(f"{value!r} cannot be stored as JSON")
