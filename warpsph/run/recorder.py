"""Keeping what a run produces: frames and diagnostics, in the file and in memory."""

from typing import TYPE_CHECKING

from warpsph.core.labels import Role
from warpsph.files.output import ResultWriter
from warpsph.run.diagnostics import common_diagnostics

if TYPE_CHECKING:
    from warpsph.run.simulation import Simulation

FRAME_FIELDS = (
    "id", "role", "material", "phase", "velocity", "density", "pressure", "temperature", "enthalpy", "solid_fraction",
)  # fmt: skip


class Recorder:
    """Keeps frames and diagnostics, in the file and in memory."""

    def __init__(self, simulation: "Simulation", writer: ResultWriter | None):
        self.simulation, self.writer = simulation, writer
        self.series: dict[str, list] = {"time": []}
        self.note = ""

    def keep(self) -> None:
        """Keep the present state: a frame without the reservoir, the diagnostics, and the events since the last one."""
        simulation, time = self.simulation, self.simulation.time
        snapshot = simulation.snapshot()
        values = common_diagnostics(snapshot)
        if simulation.observe is not None:
            values |= simulation.observe(snapshot, time)
        self.series["time"].append(time)
        for name, value in values.items():
            self.series.setdefault(name, []).append(value)
        if simulation.describe is not None:
            self.note = simulation.describe(values)
        if self.writer is not None:
            present = snapshot["role"] != Role.RESERVOIR
            fields = {name: snapshot[name][present] for name in FRAME_FIELDS if name in snapshot}
            self.writer.write_frame(time, snapshot["position"][present], fields)
            self.writer.write_diagnostics(time, values)
            for event in simulation.new_events:
                self.writer.write_event(*event)
        simulation.new_events.clear()
