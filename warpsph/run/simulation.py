"""A run: the clock, the schedule of output and diagnostics, progress, and the watch over divergence."""

import time as wall_clock
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.solver import Solver
from warpsph.core.state import State
from warpsph.core.term import BoundaryDevice
from warpsph.errors import DivergenceError, InputError
from warpsph.files.output import ResultWriter
from warpsph.files.provenance import provenance
from warpsph.run.diagnostics import Snapshot
from warpsph.run.interrupt import InterruptRequest
from warpsph.run.progress import Meter, Progress
from warpsph.run.recorder import Recorder
from warpsph.run.timestep import conduction_limits, time_step_limits


@dataclass
class Result:
    """What a run leaves: the final state as NumPy arrays and the diagnostics as time series.

    ``positions`` (n, 3) [m] and ``fields`` (n, ...) hold every particle in the order of its id, those in the reservoir
    too; ``status`` is "complete" or "interrupted"; ``summary`` pairs a label with a text for people.
    """

    positions: np.ndarray
    fields: dict[str, np.ndarray]
    diagnostics: dict[str, np.ndarray]
    events: list[tuple[float, str]]
    time: float
    steps: int
    status: str
    wall_time: float
    summary: dict[str, str] = field(default_factory=dict)


class Simulation:
    """Particles, physics and devices, ready to run.

    Args:
        executor: where to run.
        model: physics.
        particles: initial particles.
        devices: boundary devices, in the order in which they act.
        lower, upper: box that holds the particles [m], by default theirs with a margin.
        dt: time step [s], by default the largest stable one; a larger one is refused.
        step_factor: what the limits of the flow's time step are multiplied by; more than 1 is for studies of stability.
        speed_limit: speed at which the run counts as diverged [m/s]; by default five times the sound speed.
        observe: gives the scenario's own diagnostics from a snapshot and the time.
        describe: gives the note of the progress bar and the summary from the latest diagnostics.
    """

    def __init__(
        self,
        executor: Executor,
        model: Model,
        particles: Particles,
        *,
        devices: Sequence[BoundaryDevice] = (),
        lower: Sequence[float] | None = None,
        upper: Sequence[float] | None = None,
        dt: float | None = None,
        step_factor: float = 1.0,
        speed_limit: float | None = None,
        observe: Callable[[Snapshot, float], dict[str, float | np.ndarray]] | None = None,
        describe: Callable[[dict[str, float | np.ndarray]], str] | None = None,
    ):
        self.executor, self.model = executor, model
        self.observe, self.describe = observe, describe
        limits = time_step_limits(model, tuple(np.unique(particles.material[particles.role == Role.FREE])))
        self.limits = {reason: step_factor * limit for reason, limit in limits.items()}
        self.longest_step = _choose_step(dt, self.limits)
        self.heat_every = 1
        if model.conduction is not None:
            self.heat_limits = conduction_limits(model)
            longest = min(self.heat_limits.values())
            if model.fluid is None:
                self.longest_step = _choose_step(dt, self.heat_limits)
            else:
                self.heat_every = max(int(longest / self.longest_step), 1)
                self.longest_step = min(self.longest_step, longest)
        if not np.isfinite(self.longest_step):
            raise InputError("dt: nothing limits the time step of this case; give one")
        margin = 4.0 * model.support
        lower = particles.position.min(axis=0) - margin if lower is None else np.asarray(lower)
        upper = particles.position.max(axis=0) + margin if upper is None else np.asarray(upper)
        if speed_limit is None:
            speed_limit = 5.0 * model.fluid.sound_speed if model.fluid else 1.0e6
        self.state = State(particles, model, executor.device)
        self.solver = Solver(
            executor, model, self.state, devices, self.longest_step, self.heat_every, lower, upper, speed_limit
        )
        self.events: list[tuple[float, str]] = []
        self.new_events: list[tuple[float, str]] = []

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return float(self.solver.time.numpy()[0])

    def note_event(self, time: float, text: str) -> None:
        """Keep that ``text`` happened at ``time`` [s]; it goes to the file and to the result."""
        self.events.append((time, text))
        self.new_events.append((time, text))

    def snapshot(self) -> Snapshot:
        """A copy of all per-particle arrays on the host, in the order of the ids."""
        order = np.argsort(self.state.numpy("id"))
        return {name: self.state.numpy(name)[order] for name in self.state.per_particle if "carry" not in name}

    def run(
        self,
        duration: float,
        output_interval: float,
        *,
        output: Path | None = None,
        overwrite: bool = False,
        progress: Callable[[Progress], None] | None = None,
        parameters: dict | None = None,
    ) -> Result:
        """Simulate for ``duration`` [s].

        Args:
            duration: physical time [s].
            output_interval: physical time between two frames and diagnostics [s].
            output: result file, none by default.
            overwrite: whether an existing file may be replaced.
            progress: called a few times a second.
            parameters: the resolved case, stored in the file.

        Raises:
            InputError: the file cannot be made.
            DivergenceError: the simulation diverged; the frames before are kept.
        """
        writer = self._open(output, overwrite, parameters or {})
        started = wall_clock.perf_counter()
        recorder = Recorder(self, writer)
        status = "failed"
        try:
            self._record(min(output_interval, duration))
            recorder.keep()
            cycles_done, cycles = 0, max(round(duration / self._cycle_time), 1)
            per_frame = max(round(output_interval / self._cycle_time), 1)
            meter = Meter(self, duration, progress)
            with InterruptRequest() as interrupt:
                stopping = False
                while cycles_done < cycles and not stopping:
                    until_frame = min(per_frame - cycles_done % per_frame, cycles - cycles_done)
                    batch = min(meter.cycles_at_once, until_frame)
                    self.executor.replay(self._schedule * batch)
                    cycles_done += batch
                    self._look()
                    stopping = interrupt.asked
                    if batch == until_frame or stopping:
                        recorder.keep()
                    meter.update(batch, cycles_done, recorder.note)
            status = "complete" if cycles_done == cycles else "interrupted"
        except DivergenceError:
            status = "diverged"
            raise
        finally:
            wall_time = wall_clock.perf_counter() - started
            if writer is not None:
                writer.finish(status=status, wall_time=wall_time, steps=int(self.solver.steps.numpy()[0]))
                writer.close()
        return self._result(recorder, status, wall_time)

    def _open(self, output: Path | None, overwrite: bool, parameters: dict) -> ResultWriter | None:
        if output is None:
            return None
        facts = provenance(self.executor.device_name, self.executor.threads) | {
            "spacing": self.model.spacing,
            "dimension": self.model.dimension,
            "materials": [material.name for material in self.model.materials],
        }
        return ResultWriter(output, parameters, facts, overwrite)

    def _record(self, interval: float) -> None:
        """Fit the time step to the output interval and record the cycle of ``heat_every`` steps."""
        solver = self.solver
        cycles = int(np.ceil(interval / (self.heat_every * self.longest_step) - 1e-9))
        self._cycle_time = interval / cycles
        solver.dt = self._cycle_time / self.heat_every
        solver.prepare()
        with_heat = self.model.conduction is not None
        last = self.executor.record(solver.step_with_heat if with_heat else solver.step)
        self._schedule = [(last, 1)]
        if self.heat_every > 1:
            self._schedule.insert(0, (self.executor.record(solver.step), self.heat_every - 1))

    def _look(self) -> None:
        """Stop a run that has diverged or whose lists were too short."""
        solver = self.solver
        for rows, limit in (
            (solver.neighbours.longest_row, solver.neighbours.list.capacity),
            (solver.longest_bond_row, self.state.bonds.capacity if self.state.bonds is not None else 0),
        ):
            if (length := int(rows.numpy()[0])) > 0:
                raise DivergenceError(
                    f"{length} neighbours around one particle, {limit} expected at most, before t = {self.time:.6g} s: "
                    "particles have collapsed onto each other; a smaller time step or a higher sound speed may help"
                )
        if (index := int(solver.runaway.numpy()[0])) > 0:
            s = self.state
            place = ", ".join(f"{x:.4g}" for x in s.numpy("position")[index - 1])
            speed = float(np.linalg.norm(s.numpy("velocity")[index - 1]))
            name = self.model.materials[s.numpy("material")[index - 1]].name
            role = Role(int(s.numpy("role")[index - 1])).name.lower()
            raise DivergenceError(
                f"diverged before t = {self.time:.6g} s: particle {s.numpy('id')[index - 1]} ({role}, {name}) at "
                f"({place}) m has speed {speed:.4g} m/s, limit {solver.speed_limit:.4g} m/s; "
                f"dt = {solver.dt:.3g} s against limits {_listed(self.limits)}"
            )

    def _result(self, recorder: Recorder, status: str, wall_time: float) -> Result:
        fields = self.snapshot()
        positions = fields.pop("position")
        diagnostics = {name: np.array(values) for name, values in recorder.series.items()}
        steps = int(self.solver.steps.numpy()[0])
        summary = {"simulated": f"{self.time:.4g} s in {steps} steps of {self.solver.dt:.3g} s"}
        if recorder.note:
            summary["at the end"] = recorder.note
        return Result(positions, fields, diagnostics, self.events, self.time, steps, status, wall_time, summary)


def _choose_step(dt: float | None, limits: dict[str, float]) -> float:
    longest = min(limits.values(), default=np.inf)
    if dt is None:
        return longest
    if dt > longest * (1.0 + 1e-9):
        raise InputError(f"time step {dt:.3g} s is too long; limits: {_listed(limits)}")
    return dt


def _listed(limits: dict[str, float]) -> str:
    return ", ".join(f"{reason} {limit:.3g} s" for reason, limit in limits.items())
