"""Keeping what a run produces: frames and diagnostics, in the file and in memory."""

from collections.abc import Callable
from typing import Any

import numpy as np

from warpsph.core.labels import Role
from warpsph.core.quantity import Quantity
from warpsph.core.state import Snapshot, State
from warpsph.errors import InputError, shown
from warpsph.files.output import TIME, ResultWriter
from warpsph.run.diagnostics import common_diagnostics
from warpsph.run.events import Events
from warpsph.run.measured import Values, quantity_of, value_of
from warpsph.run.statistics import undefined_is_no_number

Numbers = dict[str, float | np.ndarray]
Observe = Callable[[Snapshot, float], Values]
Describe = Callable[[dict[str, Any]], str]


class Recorder:
    """Keeps frames, diagnostics and events.

    Args:
        state: what is recorded.
        dimension: 2 or 3.
        events: what happens.
        observe: gives the scenario's own diagnostics from a snapshot and the time [s].
        describe: gives a note for people from the latest diagnostics, the time [s] among them.

    Attributes:
        series: diagnostics by name, a list over time each.
        quantities: what they are called and in which unit.
        note: the latest note.
        writer: the file, or None.
    """

    def __init__(
        self, state: State, dimension: int, events: Events, observe: Observe | None, describe: Describe | None
    ):
        self.state, self.dimension, self.events = state, dimension, events
        self.observe, self.describe = observe, describe
        self.writer: ResultWriter | None = None
        self.begin(None)

    def begin(self, writer: ResultWriter | None) -> None:
        """Begin anew, with a file or without."""
        self.writer = writer
        self.series: dict[str, list] = {"time": []}
        self.quantities: dict[str, Quantity] = {"time": TIME}
        self.note = ""

    def keep(self) -> None:
        """Keep the present state: a frame without the reservoir, the diagnostics, and the events since the last one."""
        snapshot, time = self.state.snapshot(), float(self.state.time.numpy()[0])
        if self.writer is not None:
            present = snapshot["role"] != Role.RESERVOIR
            fields = {name: snapshot[name][present] for name, field in self.state.fields.items() if field.written}
            self.writer.write_frame(time, snapshot["position"][present], fields)
        with undefined_is_no_number():
            measured = common_diagnostics(snapshot)
            if self.observe is not None:
                measured |= _observed(self.observe(snapshot, time))
        values: Numbers = {name: _numeric(name, value_of(given)) for name, given in measured.items()}
        self._refuse_misfits(values)
        for name, given in measured.items():
            self.quantities.setdefault(name, quantity_of(name, given, self.dimension))
        self._append(time, values)
        if self.describe is not None:
            self.note = self.describe(values | {"time": time})
        new_events = self.events.take_new()
        if self.writer is not None:
            self.writer.write_diagnostics(time, values, self.quantities)
            for event in new_events:
                self.writer.write_event(*event)

    def last_frame(self) -> dict[str, str]:
        """Where the last frame is, for people; empty where there is none."""
        times = self.series["time"]
        if not times:
            return {}
        where = f"frame {len(times)} of {self.writer.path}" if self.writer is not None else f"row {len(times)}"
        return {"last good frame": f"{where}, at t = {times[-1]:.6g} s"}

    def diagnostics(self) -> dict[str, np.ndarray]:
        """The time series."""
        return {name: np.array(values) for name, values in self.series.items()}

    def memory(self) -> dict[str, Any]:
        return {"series": {name: list(values) for name, values in self.series.items()}, "note": self.note}

    def restore(self, memory: dict[str, Any]) -> None:
        self.series = {name: list(values) for name, values in memory["series"].items()}
        self.note = memory["note"]

    def _refuse_misfits(self, values: Numbers) -> None:
        """A diagnostic has a name that a file can have, and the same shape at all times."""
        for name, value in values.items():
            if name == "time" or not name or "/" in name:
                raise InputError(f"an observer cannot call a diagnostic '{name}'; choose another name")
            if name in self.series and np.shape(self.series[name][0]) != np.shape(value):
                before = np.shape(self.series[name][0])
                raise InputError(f"diagnostic '{name}' had the shape {before} and has {np.shape(value)} now")

    def _append(self, time: float, values: Numbers) -> None:
        """One row more; what was not measured this time, or not before, is not a number."""
        rows = len(self.series["time"])
        for name, value in values.items():
            self.series.setdefault(name, [np.full(np.shape(value), np.nan)] * rows).append(value)
        for name, series in self.series.items():
            if name != "time" and name not in values:
                series.append(np.full(np.shape(series[-1]), np.nan))
        self.series["time"].append(time)


def _observed(given: Any) -> Values:
    if not isinstance(given, dict):
        raise InputError(f"observe gave {shown(given)}; it must give values by name, such as {{'level': 0.1}}")
    return given


def _numeric(name: str, value: Any) -> float | np.ndarray:
    """A copy of a measured value, in double precision."""
    try:
        return np.array(value, float)[()]
    except (TypeError, ValueError):
        raise InputError(f"diagnostic '{name}' is no number: {shown(value)}") from None
