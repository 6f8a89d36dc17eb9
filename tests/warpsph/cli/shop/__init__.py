"""A scenario package in miniature for the tests of the command line: no kernels, done in milliseconds."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import ClassVar, Literal

import numpy as np
from pydantic import model_validator

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.quantity import Quantity
from warpsph.errors import DivergenceError
from warpsph.files.output import ResultWriter
from warpsph.files.provenance import provenance

FIELDS = {"dye": Quantity("concentration of the dye", "kg/m^3", "magma")}
DIAGNOSTICS = {"level": Quantity("melt level", "m"), "profile": Quantity("profile")}


class FakeSimulation:
    """Cools one row of particles by 1 K a frame and ends as the scenario says."""

    def __init__(self, ending: str) -> None:
        self.ending = ending

    def run(
        self,
        duration: float,
        output_interval: float,
        *,
        output=None,
        overwrite: bool = False,
        progress: Callable | None = None,
        parameters: dict | None = None,
        **checkpoints,
    ) -> SimpleNamespace:
        stopped_by = 2 if self.ending == "interrupt" else 0
        status = "interrupted" if stopped_by else "complete"
        facts = provenance("cpu", 2) | {"spacing": 0.01}
        with ResultWriter(output, parameters, facts, overwrite, FIELDS) as writer:
            times = np.arange(0.0, duration + 0.5 * output_interval, output_interval)
            for k, now in enumerate(times):
                writer.write_frame(now, *_frame(300.0 - k))
                writer.write_diagnostics(now, {"level": 0.4, "profile": np.arange(3.0)}, DIAGNOSTICS)
                if progress:
                    progress(SimpleNamespace(**_progress(now, duration)))
            events = [(float(times[-1]), "the last drop froze")]
            writer.write_event(*events[0])
            writer.finish(status=status, steps=len(times))
        if self.ending == "diverge":
            raise DivergenceError("particle 7 at (0.1, 0.2, 0) m: speed 1e9 m/s at 0.5 s")
        summary = {"computed on": "cpu, 2 threads, in 0.001 s", "at the end": "level 0.400 m"}
        return SimpleNamespace(
            status=status,
            stopped_by=stopped_by,
            steps=len(times),
            time=float(times[-1]),
            summary=summary,
            events=events,
        )


class Ingot(Scenario):
    """A row of particles that cools."""

    name = "ingot"
    summary = "A row of particles that cools"
    source = "Nobody 1900, section 1"
    presets = ("small", "broken")
    default_preset: ClassVar[str] = "small"

    spacing: float = parameter(0.01, "m", "distance between particles", gt=0, le=1)
    count: int = parameter(3, "", "number of particles", ge=1, le=100)
    wall: Literal["copper", "steel"] = parameter("copper", "", "material of the wall")
    oscillates: bool = parameter(True, "", "whether the wall moves")
    zones: tuple[float, ...] = parameter((0.1, 0.2), "m", "heights of the spray zones")
    ending: Literal["normal", "diverge", "interrupt"] = parameter("normal", "", "how the run ends")

    @model_validator(mode="after")
    def _is_short(self) -> "Ingot":
        if self.count * self.spacing > 50.0:
            raise ValueError(f"count = {self.count}: the row must be shorter than 50 m")
        return self

    def build(self, executor) -> FakeSimulation:
        return FakeSimulation(self.ending)

    def run(self, device: str = "cpu", threads: int | None = None, **options) -> SimpleNamespace:
        if self.ending == "diverge":
            raise DivergenceError("particle 7 left")
        return SimpleNamespace(stopped_by=2 if self.ending == "interrupt" else 0, measured=1.02)

    def checks(self, result) -> list[Check]:
        return [Check("ingot", "front", "m", result.measured, 1.0, 0.05, "Nobody (1)")]


class Crooked(Ingot):
    """A scenario whose second check fails, the third with a value that is not a number."""

    name = "crooked"
    summary = "A row that bends"
    presets = ()
    default_preset = None

    def checks(self, result) -> list[Check]:
        good, nan = np.float64(1.01), np.float32("nan")
        rows = [("front", good, 1.0), ("bend", np.float32(0.2), None), ("twist", nan, 1.0)]
        return [Check("crooked", quantity, "", value, reference, 0.05, "None") for quantity, value, reference in rows]


class Diverging(Ingot):
    """A scenario whose verification diverges."""

    name = "diverging"
    presets = ()
    default_preset = None
    ending: Literal["normal", "diverge", "interrupt"] = parameter("diverge", "", "how the run ends")


class Patient(Ingot):
    """A scenario that has slow checks only."""

    name = "patient"
    presets = ()
    default_preset = None

    @classmethod
    def verify(cls, simulate, slow):
        if slow:
            yield Check("patient", "front", "m", 1.0, 1.0, 0.05, "Nobody (2)")


class Interrupted(Ingot):
    """A scenario whose verification is stopped by Ctrl-C."""

    name = "interrupted"
    presets = ()
    default_preset = None
    ending: Literal["normal", "diverge", "interrupt"] = parameter("interrupt", "", "how the run ends")


def _frame(temperature: float) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    labels = {name: np.zeros(3, "i4") for name in ("id", "role", "material", "phase")}
    scalars = ("density", "pressure", "temperature", "enthalpy", "solid_fraction", "dye")
    fields = {name: np.full(3, temperature, "f4") for name in scalars}
    points = np.array([[0, 0, 0], [0.01, 0, 0], [0.02, 0, 0]], "f4")
    return points, labels | fields | {"velocity": np.zeros((3, 3), "f4")}


def _progress(now: float, duration: float) -> dict:
    share = {"time": now, "duration": duration, "steps": 10, "steps_per_second": 100.0}
    return share | {"seconds_left": duration - now, "note": "level 0.400 m"}
