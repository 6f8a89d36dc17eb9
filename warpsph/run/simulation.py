"""A run: the clock, the schedule of output and diagnostics, progress, and the watch over divergence."""

import time as wall_clock
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from warpsph.core.composition import compose
from warpsph.core.executor import Executor
from warpsph.core.footprint import refuse_what_does_not_fit
from warpsph.core.initial import initial_state
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.registry import Registry, Remembers
from warpsph.core.solver import Solver
from warpsph.core.state import Snapshot
from warpsph.core.term import Term
from warpsph.core.turns import in_turn
from warpsph.errors import DivergenceError, InputError, number, numbers, shown
from warpsph.files.checkpoint import Checkpoint
from warpsph.files.output import ResultWriter
from warpsph.run.checkpoints import Checkpoints, continued_schedule, identity, place_of_checkpoints, refuse_foreign
from warpsph.run.cycles import Cycles
from warpsph.run.divergence import refuse_divergence
from warpsph.run.estimate import Estimate, estimate_run, refuse_endless, refuse_full_disk
from warpsph.run.events import Events
from warpsph.run.facts import facts_of_run
from warpsph.run.interrupt import InterruptRequest
from warpsph.run.ledgers import Ledger, Ledgers, warn_of_open
from warpsph.run.meter import Meter
from warpsph.run.progress import Report
from warpsph.run.recorder import Describe, Observe, Recorder
from warpsph.run.result import Result
from warpsph.run.schedule import Schedule
from warpsph.run.timestep import moving_materials, plan_steps

FASTEST = 1.0e6  # [m/s], where no term knows a limit


class Simulation:
    """Particles, physics and parts of a machine, ready to run.

    Args:
        executor: where to run.
        model: physics.
        particles: initial particles.
        parts: parts of a machine, in the order in which they act.
        lower, upper: box (3,) that holds the particles [m], by default theirs with a margin; along periodic axes the
            model's holds.
        dt: time step [s], by default the largest stable one; a larger one is refused.
        step_factor: what the limits of the flow's time step are multiplied by; more than 1 is for studies of stability.
        speed_limit: speed at which the run counts as diverged [m/s]; by default what the terms say.
        observe: gives the scenario's own diagnostics from a snapshot and the time [s]. One that remembers something has
            ``memory()`` and ``restore(memory)``.
        describe: gives the note of the progress bar and the summary from the latest diagnostics.

    Raises:
        InputError: terms exclude each other or lack something, particles do not fit the model, or ``dt`` is too long.

    Attributes:
        state: the device arrays.
        solver: the step.
        events: what happens; observers may note something there.
    """

    @in_turn
    def __init__(
        self,
        executor: Executor,
        model: Model,
        particles: Particles,
        *,
        parts: Sequence[Term] = (),
        lower: Sequence[float] | np.ndarray | None = None,
        upper: Sequence[float] | np.ndarray | None = None,
        dt: float | None = None,
        step_factor: float = 1.0,
        speed_limit: float | None = None,
        observe: Observe | None = None,
        describe: Describe | None = None,
    ):
        _refuse_other_kinds(executor=(executor, Executor), model=(model, Model), particles=(particles, Particles))
        _refuse_other_kinds(parts=(parts, Sequence))
        _refuse_no_functions(observe=observe, describe=describe)
        self.executor = executor
        self.model = model = compose(model, tuple(parts))
        if len(particles) == 0:
            raise InputError("particles: there is none; add some before the simulation is built")
        self.plan = plan_steps(model, moving_materials(model, particles), dt, step_factor)
        margin = 4.0 * model.support
        lower = particles.position.min(axis=0) - margin if lower is None else np.array(numbers(lower, 3))
        upper = particles.position.max(axis=0) + margin if upper is None else np.array(numbers(upper, 3))
        if not np.all(np.isfinite([lower, upper])) or np.any(lower > upper):
            raise InputError(f"lower, upper = {lower}, {upper}: must be two corners of a box [m], the lower one first")
        refuse_what_does_not_fit(model, len(particles), executor.device)
        self.state = state = initial_state(model, particles, executor.device)
        if speed_limit is None:
            known = min((term.speed_limit(model) for term in model.terms), default=np.inf)
            speed_limit = known if np.isfinite(known) else FASTEST
        if not number(speed_limit) > 0.0:
            raise InputError(f"speed_limit = {speed_limit!r}: must be positive [m/s]")
        self.solver = Solver(executor, model, state, lower, upper, speed_limit, small_steps=self.plan.small_steps)
        self.events = Events()
        self.ledgers = Ledgers(model, state)
        self.recorder = Recorder(state, model.dimension, self.events, observe, describe)
        self._cycles = Cycles(executor, self.solver, self.plan)

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return float(self.state.time.numpy()[0])

    @property
    def steps(self) -> int:
        """Steps done."""
        return int(self.state.steps.numpy()[0])

    @property
    def registry(self) -> Registry:
        """All that changes in a run."""
        memories: dict[str, Remembers] = {"events": self.events, "recorder": self.recorder, "ledgers": self.ledgers}
        observer = getattr(self.recorder.observe, "__self__", self.recorder.observe)
        if isinstance(observer, Remembers):
            memories["observer"] = observer
        return Registry(self.state, memories)

    def snapshot(self) -> Snapshot:
        """A copy of all per-particle fields on the host, in the order of the ids."""
        return self.state.snapshot()

    @in_turn
    def prepare(self) -> None:
        """Bring what follows from the initial state up to date; a run does so by itself before its first step."""
        self.solver.prepare()

    def schedule(
        self,
        duration: float,
        output_interval: float,
        checkpoint_every: float | None = None,
        resume: Checkpoint | None = None,
    ) -> Schedule:
        """The steps, frames and checkpoints of a run, as :meth:`run` makes them.

        Raises:
            InputError: there are no steps, or too many, or the checkpoint is of something else.
        """
        for name, value in (
            ("duration", duration),
            ("output_interval", output_interval),
            ("checkpoint_every", 1.0 if checkpoint_every is None else checkpoint_every),
        ):
            if not 0.0 < number(value) < np.inf:
                raise InputError(f"{name} = {value!r}: must be positive and finite [s]")
        if resume is None:
            return Schedule(self.plan, self.time, duration, output_interval, checkpoint_every)
        refuse_foreign(resume, self.executor.on_cuda)
        return continued_schedule(resume, self.plan, duration, output_interval, checkpoint_every)

    def estimate(self, schedule: Schedule) -> Estimate:
        """What a run by this schedule will take."""
        return estimate_run(self.state, schedule, self.executor.threads)

    def refuse_too_long(self, schedule: Schedule, output: str | Path | None = None) -> None:
        """Refuse a run that would take months, or more disk than there is; :meth:`run` does so by itself.

        Raises:
            InputError: how much it would take, and what makes it less.
        """
        estimate = self.estimate(schedule)
        refuse_endless(estimate, self.plan, schedule.output_interval, self.steps)
        if isinstance(output, str | Path):
            refuse_full_disk(estimate, Path(output))

    @in_turn
    def write_start(self, schedule: Schedule, output: str | Path, parameters: dict) -> None:
        """Write what there is before the first step as the only frame of a result file.

        Raises:
            InputError: the file exists, or cannot be made.
        """
        writer = self._open(output, False, parameters, None)
        self.recorder.begin(writer)
        try:
            self._begin_with(schedule)
            self.recorder.keep()
        finally:
            if writer is not None:
                writer.finish(status="not run", wall_time=0.0, steps=self.steps)
                writer.close()
            self.recorder.begin(None)

    @in_turn
    def measure(self, schedule: Schedule) -> float:
        """How long [s] a run by this schedule would take, by a few of its steps and one look, which are done."""
        self._begin_with(schedule)
        seconds = self._cycles.seconds(schedule.cycle_steps)
        started = wall_clock.perf_counter()
        self.recorder.keep()
        look = wall_clock.perf_counter() - started
        return seconds / schedule.cycle_steps.count * schedule.steps + look * schedule.frames

    @in_turn
    def run(
        self,
        duration: float,
        output_interval: float,
        *,
        output: str | Path | None = None,
        overwrite: bool = False,
        progress: Report | None = None,
        parameters: dict | None = None,
        checkpoint: str | Path | None = None,
        checkpoint_every: float | None = None,
        resume: str | Path | Checkpoint | None = None,
    ) -> Result:
        """Simulate for ``duration`` [s] from the present time on.

        The time step fills the output interval with whole cycles and does not depend on the duration; where that ends
        within a cycle, the steps of this last cycle are shorter. ``run(a)`` and then ``run(b)`` is ``run(a + b)`` as
        long as a is a multiple of the output interval. Of two runs in two threads of one process the second waits.

        Args:
            duration: physical time [s].
            output_interval: physical time between two frames and diagnostics [s].
            output: result file, none by default.
            overwrite: whether an existing file may be replaced.
            progress: called a few times a second.
            parameters: the resolved case, stored in the file.
            checkpoint: where checkpoints go, by default beside ``output``.
            checkpoint_every: physical time between two checkpoints [s]; without it there is one only where the run is
                interrupted.
            resume: a checkpoint of the same case from which to go on; ``duration`` counts from the begin of the run
                that wrote it, and ``output`` is continued.

        Raises:
            InputError: the file cannot be made, or the checkpoint belongs to something else.
            DivergenceError: the simulation diverged; the frames before are kept.
            WarpsphError: the file cannot be written any more, as on a full disk; the frames before are kept.
        """
        begun = resume if isinstance(resume, Checkpoint | None) else Checkpoint.read(resume)
        schedule = self.schedule(duration, output_interval, checkpoint_every, begun)
        self.refuse_too_long(schedule, output)
        _refuse_no_functions(progress=progress)
        _refuse_other_kinds(parameters=({} if parameters is None else parameters, dict))
        place = place_of_checkpoints(checkpoint, checkpoint_every, output)
        recorder = self.recorder
        recorder.begin(None)
        if begun:
            self.registry.load(begun.saved)  # before the file, which a checkpoint of something else must not harm
        recorder.writer = writer = self._open(output, overwrite, parameters or {}, begun)
        run_begin = begun.facts["run_begin"] if begun else schedule.begin
        constant = {"parameters": parameters or {}, "run_begin": run_begin}
        checkpoints = self._checkpoints(place, writer, constant)
        started = wall_clock.perf_counter() - (begun.facts["wall_time"] if begun else 0.0)
        status, ledgers = "failed", []
        interrupt = InterruptRequest()
        try:
            with interrupt:
                self._begin_with(schedule)
                if not begun:
                    refuse_divergence(self.solver, self.plan)
                    recorder.keep()
                self._advance(schedule, interrupt, Meter(schedule, progress), checkpoints, started)
            status = (self.events.outcome or "complete") if schedule.done else "interrupted"
            ledgers = self.ledgers.close()
        except DivergenceError as error:
            status = "diverged"
            error.facts |= recorder.last_frame() | (checkpoints.newest() if checkpoints else {})
            raise
        finally:
            wall_time = wall_clock.perf_counter() - started
            if writer is not None:
                with InterruptRequest():
                    writer.finish(status=status, wall_time=wall_time, steps=self.steps, ledgers=[*map(asdict, ledgers)])
                    writer.close()
            interrupt.send_on()
        warn_of_open(ledgers)
        return self._result(status, wall_time, interrupt.number, ledgers)

    def _advance(
        self,
        schedule: Schedule,
        interrupt: InterruptRequest,
        meter: Meter,
        checkpoints: Checkpoints | None,
        started: float,
    ) -> None:
        """Go on to the end of the schedule, or until somebody asks to stop."""
        stopping = interrupt.asked
        if schedule.done and not schedule.at_frame:  # resumed at its end, whose frame no longer run has
            self.recorder.keep()
        while not (schedule.done or stopping):
            cycles = schedule.next_batch(meter.cycles_at_once)
            self._cycles.replay(schedule.cycle_steps, cycles)
            refuse_divergence(self.solver, self.plan)
            if schedule.at_frame:
                self.state.time.fill_(schedule.time)
                self.recorder.keep()
                refuse_divergence(self.solver, self.plan)  # observers may have changed something
            stopping = interrupt.asked
            # before a frame that a longer run does not have, because its observers would remember it
            if checkpoints and (schedule.at_checkpoint or (stopping and schedule.on_whole_cycle)):
                checkpoints.write(schedule, wall_clock.perf_counter() - started)
            if (schedule.done or stopping) and not schedule.at_frame:
                if schedule.done:
                    self.state.time.fill_(schedule.time)
                self.recorder.keep()
            meter.update(cycles, self.recorder.note)

    def _open(
        self, output: str | Path | None, overwrite: bool, parameters: dict, begun: Checkpoint | None
    ) -> ResultWriter | None:
        if output is None:
            return None
        if begun and Path(output).exists():
            return ResultWriter.continued(output, parameters, begun.facts["result"])
        facts = facts_of_run(self.executor, self.model)
        quantities = {name: field.quantity for name, field in self.state.fields.items() if field.written}
        return ResultWriter(output, parameters, facts, overwrite, quantities)

    def _checkpoints(self, place: Path | None, writer: ResultWriter | None, constant: dict) -> Checkpoints | None:
        if place is None:
            return None
        return Checkpoints(place, self.registry, identity(self.executor.on_cuda) | constant, writer)

    def _begin_with(self, schedule: Schedule) -> None:
        """Set the time step of a run's cycles, and before the very first step bring the initial state up to date."""
        steps = schedule.cycle_steps
        self.solver.set_steps(steps.dt, steps.duration)
        if self.steps == 0:
            self.solver.prepare()
            self.ledgers.open()

    def _result(self, status: str, wall_time: float, stopped_by: int, ledgers: list[Ledger]) -> Result:
        fields = self.snapshot()
        recorder = self.recorder
        summary = {
            "simulated": f"{self.time:.4g} s in {self.steps} steps of {self.solver.dt:.3g} s",
            "computed on": f"{self.executor.description}, in {wall_time:.3g} s",
        }
        for term in self.model.terms:
            summary |= term.summary()
        summary |= {f"ledger of {ledger.quantity}": str(ledger) for ledger in ledgers}
        if recorder.note:
            summary["at the end"] = recorder.note
        return Result(
            positions=fields.pop("position"),
            fields=fields,
            diagnostics=recorder.diagnostics(),
            quantities=dict(recorder.quantities),
            events=list(self.events.all),
            time=self.time,
            steps=self.steps,
            status=status,
            stopped_by=stopped_by if status == "interrupted" else 0,
            wall_time=wall_time,
            materials=tuple(material.name for material in self.model.materials),
            summary=summary,
            ledgers=ledgers,
        )


def _refuse_other_kinds(**given: tuple[Any, type]) -> None:
    for name, (value, kind) in given.items():
        if not isinstance(value, kind):
            raise InputError(f"{name} = {shown(value)}: must be of the kind {kind.__name__}")


def _refuse_no_functions(**given: Any) -> None:
    for name, value in given.items():
        if value is not None and not callable(value):
            raise InputError(f"{name} = {shown(value)}: must be a function, or None")
