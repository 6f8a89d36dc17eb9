"""One step of the simulation, stage by stage."""

from collections import ChainMap
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.footprint import SKIN, farthest_reach
from warpsph.core.guard import Guard, Offender
from warpsph.core.labels import Phase
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.neighbours import Neighbours
from warpsph.core.state import State
from warpsph.core.term import MOMENTS, Term, acts_at
from warpsph.errors import InputError
from warpsph.nearest import did_you_mean


class Solver:
    """Advances the state; knows no file, no picture, no schedule, and no term by name.

    A step moves the flow by ``dt``; after some steps, a step with heat conducts for all of them at once. Stages ask the
    terms of the model in their order.

    Args:
        executor: where to run.
        model: what stays the same, composed.
        state: what changes.
        lower, upper: box (3,) of the neighbour grid [m].
        speed_limit: speed that no particle can have unless the simulation has diverged [m/s].
        skin: of the neighbour list, in spacings.
        small_steps: of which each half of the way has one or more, where motion is of second order.

    Attributes:
        dt: time step [s].
        interval: time between two steps with heat [s].
    """

    def __init__(
        self,
        executor: Executor,
        model: Model,
        state: State,
        lower: np.ndarray,
        upper: np.ndarray,
        speed_limit: float,
        skin: float = SKIN,
        small_steps: int = 1,
    ):
        self.executor, self.model, self.state, self.speed_limit = executor, model, state, speed_limit
        self.small_steps = small_steps
        state.hold("time", wp.zeros(1, dtype=wp.float64, device=state.device))
        state.hold("steps", wp.zeros(1, dtype=int, device=state.device))
        self.guard = Guard(model, state, speed_limit)
        starts_solid = np.any(state.numpy("phase") == Phase.SOLID)
        state.hold("phase_changed", wp.array([int(starts_solid)], dtype=int, device=state.device))
        self._constants: dict[str, Any] = {
            "dt": 0.0,
            "interval": 0.0,
            "small_dt": 0.0,
            "gravity": wp.vec3(*model.gravity),
        } | self.guard.constants
        for name in (*self._constants, "farthest_squared"):
            if hasattr(state, name):
                raise InputError(f"a field cannot be called '{name}': a constant of every kernel has that name")
        shared = ChainMap(self._constants, state.arrays, state.values, state.lists, state.scratch)
        self.launch = Launch(executor, state.count, shared)
        terms: list[Term] = list(model.terms)
        self.neighbours = Neighbours(
            self.launch,
            model,
            state,
            farthest_reach(model),
            skin * model.spacing,
            lower,
            upper,
            before_sorting=self._before_sorting,
            on_sorted=lambda: self.act("follow_sorting"),
            on_listed=self._on_listed,
        )
        self._constants["farthest_squared"] = self.neighbours.half_skin**2
        for term in terms:
            term.allocate(model, state)
        launches = [self.launch.within(term.arrays, term.constants(model, state)) for term in terms]
        self._acts = {
            moment: [(term, launch) for term, launch in zip(terms, launches, strict=True) if acts_at(term, moment)]
            for moment in (*MOMENTS, "initialise", "wrap", "follow_sorting", "follow_listing")
        }
        if model.periodic is None:
            self._acts["wrap"] = []
        if not any("small steps" in term.provides for term in terms):
            self._acts |= {"sum_fast_forces": [], "add_fast_forces": []}
        self.terms = terms

    @property
    def dt(self) -> float:
        return self._constants["dt"]

    @property
    def interval(self) -> float:
        return self._constants["interval"]

    def set_steps(self, dt: float, interval: float) -> None:
        """Choose the time step and the interval between two steps with heat [s], for what is launched from now on."""
        self._constants["dt"], self._constants["interval"] = dt, interval
        self._constants["small_dt"] = 0.5 * dt / self.small_steps

    def prepare(self) -> None:
        """Bring what follows from the initial state up to date: neighbours, temperature, density, bonds, forces."""
        dt, interval = self.dt, self.interval
        self.set_steps(0.0, 0.0)
        self.neighbours.renew_if_outdated()
        for moment in (
            "find_temperature",
            "find_density",
            "find_walls",
            "initialise",
            "change_phases",
            "sum_forces",
            "add_forces",
            "sum_fast_forces",
            "add_fast_forces",
        ):
            self.act(moment)
        self.set_steps(dt, interval)

    def step(self) -> None:
        """Advance the flow by one time step."""
        self.neighbours.renew_if_outdated()
        self._together("set_out")
        self._travel()
        self._together("find_density", "prescribe")
        self._together("arrive")
        self._travel()
        self._together("find_walls")
        self._together("sum_forces")
        self._together("add_forces", "kick")
        self._together("move", "watch")

    def _travel(self) -> None:
        """Half the way of the step, where motion is of second order: in small steps, between which fast forces act."""
        for _ in range(self.small_steps):
            if not self._acts["add_fast_forces"]:
                self._together("drift")
                continue
            self._together("kick_little", "drift")
            self._together("sum_fast_forces")
            self._together("add_fast_forces", "kick_little")

    def step_with_heat(self) -> None:
        """Advance the flow by one time step, and heat by as many as have passed since the last conduction."""
        self.step()
        self.neighbours.renew_if_outdated()
        self.act("sum_heat")
        self.act("add_heat")
        self.act("after_heat")
        self.act("find_temperature")
        self.act("change_phases")

    def act(self, moment: str) -> None:
        """Let all terms act at one moment, by the name of the method: "find_density", "sum_forces", "sum_heat", ...

        A step does so at all of them in turn. After :meth:`prepare`, or after something was changed by hand, it finds
        one quantity anew without a step.

        Raises:
            InputError: there is no such moment.
        """
        if moment not in self._acts:
            raise InputError(f"there is no moment '{moment}'{did_you_mean(moment, self._acts)}")
        for term, launch in self._acts[moment]:
            getattr(term, moment)(launch)

    def find_offender(self) -> Offender | None:
        """The first particle of the run that was beyond a bound, or is so now, or whose row in a list was too short."""
        return self.guard.find_offender(self.launch)

    def check(self) -> None:
        """Look, on the host, whether a term finds something wrong.

        Raises:
            DivergenceError: one does.
        """
        for term in self.terms:
            term.check(self.state)

    def _before_sorting(self) -> None:
        self.guard.note(self.launch)
        self.act("wrap")

    def _on_listed(self) -> None:
        self.guard.note_neighbours(self.launch)
        self.act("follow_listing")

    def _together(self, *moments: str) -> None:
        """Let terms act at moments at which nobody waits for anybody else."""
        if any(self._acts[moment] for moment in moments):
            with self.executor.section():
                for moment in moments:
                    self.act(moment)
