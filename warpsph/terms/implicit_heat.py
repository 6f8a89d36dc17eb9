"""An implicit step of conduction: Newton's method around the linear solvers of Warp."""

from collections.abc import Callable
from functools import cached_property, partial
from typing import Any

import numpy as np
import warp as wp
from warp.optim.linear import LinearOperator, bicgstab, cg
from warp.utils import array_inner

from warpsph.core.launch import Launch
from warpsph.core.state import State, members_of
from warpsph.errors import DivergenceError
from warpsph.kernels.heat.implicit import (
    ImplicitStep,
    change_heat,
    find_known,
    find_rest,
    multiply_rows,
    precondition,
    retreat,
    settle_heat,
)
from warpsph.kernels.heat.rows import HeatRows
from warpsph.terms.integrators import CrankNicolson, Implicit

MOST_ITERATES = 60  # of Newton's method: within a step a front may pass from particle to particle
FOLLOWED = (
    12  # iterates that rows follow; where conductivities jump, as when a front enters a particle, none fulfils all
)
EACH_SYSTEM = 1.0e-3  # to which share of its right hand side a system is solved before the next iterate
ENOUGH = 1.0e-9  # rest over the heat content where hardly anything moves any more: a millionth of a kelvin
ROUNDING = 1.0e-15  # of what the equations are made of, in double precision
HALVINGS = 6  # of a change that has made the rest larger
MOST_PREPARED = 64  # launches of the linear solver that are kept ready; each length of a step has its own
CHECK_EVERY = {True: 10, False: 1}  # iterations of a linear solver; on a GPU each look makes it wait for the host


class Equations:
    """What is solved for: how heat, temperature and rows hang together.

    Attributes:
        families: unknowns at each particle, 1 or 2.
        bend: whether the rows change with the temperatures.
        change: whether they change with time.
        symmetric: whether they are symmetric.
        walls: number of walls of heat.
    """

    families: int
    bend: bool
    change: bool
    symmetric: bool
    walls: int

    def begin(self, launch: Launch) -> None:
        """Write heat and supply of the solution."""
        raise NotImplementedError

    def find_iterate(self, launch: Launch) -> None:
        """Write temperature and capacity of the solution from its heat, and what the rows depend on."""
        raise NotImplementedError

    def find_rows(self, launch: Launch, ago: float) -> None:
        """Write the rows, as they were ``ago`` [s] before the end of the whole step."""
        raise NotImplementedError

    def count(self, launch: Launch, part: float) -> None:
        """Count what leaves the body in the time ``part`` [s], by the rows and temperatures of the moment."""
        raise NotImplementedError

    def end(self, launch: Launch) -> None:
        """Give the particles the heat of the solution."""
        raise NotImplementedError


class ImplicitHeat:
    """Finds the heats at the end of a step; belongs to one simulation.

    Args:
        integrator: which equations the end of a step fulfils, and how exactly.
        equations: what they are made of.
        state: gives device, number of particles and neighbour list; holds the counters.

    Attributes:
        solution, rows: what the kernels work on; lists of these names.
    """

    def __init__(self, integrator: Implicit, equations: Equations, state: State):
        self.integrator, self.equations, self._state = integrator, equations, state
        self._symmetric = equations.symmetric
        self._bind: Callable[[Launch], None] | None = None
        self._size = size = equations.families * state.count
        entries = equations.families**2 * len(state.neighbours.entry)

        def doubles(*shape: int) -> Any:
            return wp.zeros(shape, dtype=wp.float64, device=state.device)

        self.solution: Any = ImplicitStep()
        for name in members_of(self.solution):
            setattr(
                self.solution,
                name,
                wp.zeros(size, dtype=int, device=state.device) if name == "bound" else doubles(size),
            )
        self.rows: Any = HeatRows()
        self.rows.families = equations.families
        self.rows.beside = wp.zeros(entries, dtype=float, device=state.device)
        self.rows.here = doubles(size if equations.families > 1 else 0)
        self.rows.diagonal, self.rows.source = doubles(size), doubles(size)
        self.rows.to_wall, self.rows.wall_source = (doubles(equations.walls, state.count) for _ in range(2))
        state.hold_list("solution", self.solution, scratch=True)
        state.hold_list("rows", self.rows, scratch=True)
        self._counters = state.hold("implicit.counters", wp.zeros(3, dtype=int, device=state.device))
        self._prepared: dict[tuple, Callable[[], None]] = {}

    def bind(self, find_rows: Callable[[Launch], None]) -> None:
        """Let ``find_rows`` put other rows in the place of those of particles without heat, and mark them ``bound``."""
        self._bind, self._symmetric = find_rows, False

    @property
    def method(self) -> str:
        """Name of the linear solver."""
        return "conjugate gradients" if self._symmetric else "BiCGSTAB"

    @property
    def counters(self) -> tuple[int, int, int]:
        """Steps so far, iterates of Newton's method, and iterations of the linear solver."""
        steps, iterates, iterations = self._counters.numpy()
        return int(steps), int(iterates), int(iterations)

    def summary(self) -> dict[str, str]:
        """How much it took to solve the steps."""
        steps, iterates, iterations = self.counters
        each = max(steps, 1)
        return {
            "conduction": f"{steps} implicit steps, in each {iterates / each:.3g} systems of equations and "
            f"{iterations / each:.3g} iterations of {self.method}"
        }

    @cached_property
    def _solve(self) -> Any:
        """The linear solver, with its arrays."""
        device, size = self._state.device, self._size
        # one sum from begin to end: what Warp does for several systems at once is many times faster on a CPU
        offsets: Any = None if device.is_cuda else wp.array([0, size], dtype=int, device=device)
        matrix, inverse = (
            LinearOperator((size, size), wp.float64, device, partial(self._multiply, kernel), offsets)
            for kernel in (multiply_rows, precondition)
        )
        return (cg if self._symmetric else bicgstab)(
            matrix,
            self.solution.right_side,
            self.solution.change,
            tol=EACH_SYSTEM,
            atol=0.0,
            maxiter=self.integrator.most_iterations,
            M=inverse,
            check_every=CHECK_EVERY[device.is_cuda],
            run=False,
        )

    def advance(self, launch: Launch, interval: float) -> None:
        """Conduct heat for ``interval`` [s]."""
        self._launch = launch
        counters = self._counters.numpy().copy()
        self.solution.bound.zero_()
        self.equations.begin(launch)
        left = interval
        for share_of_end, step in self._parts(int(counters[0]), interval):
            left -= step
            counters[1:] += self._go(share_of_end, step, max(left, 0.0))
        self.equations.end(launch)
        counters[0] += 1
        self._counters.assign(counters)

    def _parts(self, steps_done: int, interval: float) -> list[tuple[float, float]]:
        """The parts of a step: how much heat as it flows at their end counts, and how long they are [s]."""
        if not isinstance(self.integrator, CrankNicolson):
            return [(1.0, interval)]
        if steps_done < self.integrator.damped_steps:
            return [(1.0, 0.5 * interval)] * 2
        return [(0.5, interval)]

    def _go(self, share_of_end: float, step: float, left: float) -> tuple[int, int]:
        """Go on by ``step`` [s], with ``left`` [s] after it; return the number of iterates and of iterations."""
        launch, equations = self._launch, self.equations
        begin, self._end, self._left = (1.0 - share_of_end) * step, share_of_end * step, left
        others = self._bind is not None or equations.change  # at the begin, or where heat is counted
        self._find_rows()
        equations.find_iterate(launch)
        if others:
            equations.find_rows(launch, left + step if begin > 0.0 else left)
        self._each(find_known, begin=begin, step=step)
        if begin > 0.0:
            equations.count(launch, begin)
        if others:
            self._find_rows()
        norm = self._rest()
        iterates = iterations = 0
        while not norm <= (goal := self._goal()):
            if iterates == MOST_ITERATES or not np.isfinite(norm):
                raise self._failure("Newton's method", iterates, norm, goal)
            iterates += 1
            iterations += self._change()
            norm = self._accept(norm, follow=equations.bend and iterates <= FOLLOWED)
        self._each(settle_heat)
        if self._bind is not None:
            equations.find_rows(launch, left)
        equations.count(launch, self._end)
        return iterates, iterations

    def _each(self, kernel: wp.Kernel, **given: Any) -> None:
        """Launch ``kernel`` over the unknowns."""
        self._launch(kernel, self._size, **given)

    def _find_rows(self) -> None:
        """Find the rows of the end of the step, and those of particles without heat."""
        self.equations.find_rows(self._launch, self._left)
        if self._bind is not None:
            self._bind(self._launch)

    def _rest(self) -> float:
        """Find the rest, and return its norm."""
        self._each(find_rest, end=self._end)
        return _norm(self.solution.rest)

    def _goal(self) -> float:
        """The largest rest [J] that is accepted."""
        solution = self.solution
        enough = max(ENOUGH * _norm(solution.content), ROUNDING * _norm(solution.terms))
        return max(self.integrator.tolerance * _norm(solution.moved), enough)

    def _change(self) -> int:
        """Solve for the change of the temperatures and let heats follow; return the number of iterations."""
        iterations, error, goal = self._solve()
        if not error <= goal:
            raise self._failure(self.method, iterations, error, goal)
        self._each(change_heat, end=self._end)
        return iterations

    def _accept(self, before: float, follow: bool) -> float:
        """Find the rest after a change, and take back half of it as long as the rest is larger than ``before``.

        ``follow``: whether the rows follow the change.
        """
        for halving in range(HALVINGS + 1):
            self.equations.find_iterate(self._launch)
            if follow:
                self._find_rows()
            norm = self._rest()
            if norm <= before or halving == HALVINGS:
                break
            self._each(retreat, share=0.5 ** (halving + 1))
        return norm

    def _multiply(self, kernel: wp.Kernel, x: wp.array, y: wp.array, z: wp.array, alpha: float, beta: float) -> None:
        key = (kernel.key, self._end, alpha, beta, x.ptr, y.ptr, z.ptr)
        if key not in self._prepared:
            if len(self._prepared) >= MOST_PREPARED:
                self._prepared.clear()
            given: dict[str, Any] = {"alpha": float(alpha), "beta": float(beta), "x": x, "y": y, "z": z}
            self._prepared[key] = self._launch.prepared(kernel, self._size, end=self._end, **given)
        self._prepared[key]()

    def _failure(self, method: str, count: int, norm: float, goal: float) -> DivergenceError:
        state = self._state
        rest = np.abs(self.solution.rest.numpy())
        unknown = int(np.argmax(np.where(np.isnan(rest), np.inf, rest)))  # that of particle i in family f at f n + i
        worst = unknown % state.count
        place = ", ".join(f"{x:.4g}" for x in state.numpy("position")[worst])
        message = (
            f"conduction: {method} has not converged after {count} iterations before "
            f"t = {float(state.time.numpy()[0]):.6g} s: the rest is {norm:.3g} J, {goal:.3g} J is asked for; "
            f"the largest part, {rest[unknown]:.3g} J, is that of particle {state.numpy('id')[worst]} at ({place}) m"
        )
        return DivergenceError(
            message, {"usual cause": "shorter steps, more iterations or a larger tolerance may help"}
        )


def _norm(values: wp.array) -> float:
    return float(np.sqrt(array_inner(values, values)))
