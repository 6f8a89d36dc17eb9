"""An implicit step of conduction: Newton's method around the linear solvers of Warp."""

from collections.abc import Callable
from functools import cached_property, partial
from typing import Any

import numpy as np
import warp as wp
from warp.optim.linear import LinearOperator, bicgstab, cg
from warp.utils import array_inner

from warpsph.core.executor import Recording
from warpsph.core.launch import Launch
from warpsph.core.state import State, members_of
from warpsph.errors import DivergenceError
from warpsph.kernels.heat.implicit import (
    ImplicitStep,
    begin_implicit,
    change_heat,
    count_implicit_heat,
    end_implicit,
    find_known,
    find_rest,
    find_right_side,
    multiply_rows,
    precondition,
    retreat,
    settle_heat,
)
from warpsph.kernels.heat.rows import HeatRows
from warpsph.terms.integrators import CrankNicolson, Implicit

MOST_ITERATES = 60  # of Newton's method: within a step a front may pass from particle to particle
FOLLOWED = (
    12  # iterates that conductivities follow; where they jump, as when a front enters a particle, none fulfils all
)
EACH_SYSTEM = 1.0e-3  # to which share of its right hand side a system is solved before the next iterate
ROUNDING = 1.0e-15  # of what the equations are made of, in double precision
HALVINGS = 6  # of a change that has made the rest larger
WORTH_THREADS = 20_000  # particles, above which several threads multiply faster than one
CHECK_EVERY = {True: 10, False: 1}  # iterations of a linear solver; on a GPU each look makes it wait for the host


class ImplicitHeat:
    """Finds the enthalpies at the end of a step; belongs to one simulation.

    Args:
        integrator: which equations the end of a step fulfils, and how exactly.
        state: gives device, number of particles and neighbour list; holds the counters.
        walls: number of walls of heat.
        linear: whether rows and heat capacities are the same at all temperatures.
        symmetric: whether the rows are symmetric: then conjugate gradients serve, else BiCGSTAB.
        find_iterate: writes what follows from the enthalpies of the solution.
        find_rows: writes the rows, as they were so many seconds ago.
        timed: whether they change with time.

    Attributes:
        solution, rows: what the kernels work on, under these names.
    """

    def __init__(
        self,
        integrator: Implicit,
        state: State,
        walls: int,
        linear: bool,
        symmetric: bool,
        find_iterate: Callable[[Launch], None],
        find_rows: Callable[[Launch, float], None],
        timed: bool,
    ):
        self.integrator, self.linear = integrator, linear
        self._find_iterate, self._find_rows, self._timed = find_iterate, find_rows, timed
        self._state, n = state, state.count

        def doubles(*shape: int) -> Any:
            return wp.zeros(shape, dtype=wp.float64, device=state.device)

        self.solution: Any = ImplicitStep()
        for name in members_of(self.solution):
            if name != "bound":
                setattr(self.solution, name, doubles(n))
        self.solution.bound = wp.zeros(n, dtype=int, device=state.device)
        self.rows: Any = HeatRows()
        self.rows.beside = wp.zeros(len(state.neighbours.entry), dtype=float, device=state.device)
        self.rows.diagonal, self.rows.source = doubles(n), doubles(n)
        self.rows.to_wall, self.rows.wall_source = doubles(walls, n), doubles(walls, n)
        self._right_side = doubles(n)
        self._counters = state.hold("conduction.counters", wp.zeros(3, dtype=int, device=state.device))
        self._symmetric = symmetric
        self._bind: Callable[[Launch], None] = lambda launch: None
        self._recordings: dict[tuple, Recording] = {}

    def bind(self, find_rows: Callable[[Launch], None]) -> None:
        """Let ``find_rows`` put other rows in the place of those of particles without heat, and mark them ``bound``."""
        self._bind, self._symmetric = find_rows, False

    @property
    def method(self) -> str:
        """Name of the linear solver."""
        return "conjugate gradients" if self._symmetric else "BiCGSTAB"

    @cached_property
    def _solve(self) -> Any:
        """The linear solver, with its arrays."""
        state, n = self._state, self._state.count
        # one sum from begin to end: what Warp does for several systems at once is many times faster on a CPU
        offsets: Any = None if state.device.is_cuda else wp.array([0, n], dtype=int, device=state.device)
        matrix, inverse = (
            LinearOperator((n, n), wp.float64, state.device, partial(self._multiply, kernel), offsets)
            for kernel in (multiply_rows, precondition)
        )
        return (cg if self._symmetric else bicgstab)(
            matrix,
            self._right_side,
            self.solution.change,
            tol=EACH_SYSTEM,
            atol=0.0,
            maxiter=self.integrator.most_iterations,
            M=inverse,
            check_every=CHECK_EVERY[state.device.is_cuda],
            run=False,
        )

    @property
    def counters(self) -> tuple[int, int, int]:
        """Steps so far, iterates of Newton's method, and iterations of the linear solver."""
        steps, iterates, iterations = self._counters.numpy()
        return int(steps), int(iterates), int(iterations)

    def advance(self, launch: Launch, interval: float) -> None:
        """Conduct heat for ``interval`` [s]; what others bring in it stands in ``heat_rate``."""
        self._launch = launch
        counters = self._counters.numpy().copy()
        launch(begin_implicit)
        left = interval
        for share_of_end, step in self._parts(int(counters[0]), interval):
            left -= step
            counters[1:] += self._go(share_of_end, step, left)
        launch(end_implicit)
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
        launch, solution = self._launch, self.solution
        begin, self._end, self._left = (1.0 - share_of_end) * step, share_of_end * step, left
        self._find_equations()
        self._find_iterate(launch)
        self._find_rows(launch, left + step if begin > 0.0 else left)
        launch(find_known, begin=begin, step=step)
        launch(count_implicit_heat, part=begin)
        if self._timed and begin > 0.0:
            self._find_rows(launch, left)
        self._bind(launch)
        launch(find_rest, end=self._end)
        norm = _norm(solution.rest)
        iterates = iterations = 0
        while not norm <= (goal := self._goal()):
            if iterates == MOST_ITERATES or not np.isfinite(norm):
                raise self._failure("Newton's method", iterates, norm, goal)
            iterates += 1
            iterations += self._change()
            norm = self._accept(norm, follow=not self.linear and iterates <= FOLLOWED)
        launch(settle_heat)
        self._find_rows(launch, left)
        launch(count_implicit_heat, part=self._end)
        return iterates, iterations

    def _find_equations(self) -> None:
        """Find the rows, and those of particles without heat."""
        self._find_rows(self._launch, self._left)
        self._bind(self._launch)

    def _goal(self) -> float:
        """The largest rest [J] that is accepted."""
        solution = self.solution
        return max(self.integrator.tolerance * _norm(solution.moved), ROUNDING * _norm(solution.terms))

    def _change(self) -> int:
        """Solve for the change of the temperatures and let enthalpies follow; return the number of iterations."""
        launch = self._launch
        launch(find_right_side, right_side=self._right_side)
        iterations, error, goal = self._solve()
        if not error <= goal:
            raise self._failure(self.method, iterations, error, goal)
        launch(change_heat, end=self._end)
        return iterations

    def _accept(self, before: float, follow: bool) -> float:
        """Find the rest after a change, and take back half of it as long as the rest is larger than ``before``.

        ``follow``: whether conductivities follow the change.
        """
        launch = self._launch
        for halving in range(HALVINGS + 1):
            self._find_iterate(launch)
            if follow:
                self._find_equations()
            launch(find_rest, end=self._end)
            norm = _norm(self.solution.rest)
            if norm <= before or halving == HALVINGS:
                break
            launch(retreat, share=0.5 ** (halving + 1))
        return norm

    def _multiply(self, kernel: wp.Kernel, x: wp.array, y: wp.array, z: wp.array, alpha: float, beta: float) -> None:
        given: dict[str, Any] = {"end": self._end, "alpha": float(alpha), "beta": float(beta), "x": x, "y": y, "z": z}
        launch = self._launch
        executor = launch.executor
        if executor.threads == 1 or self._state.count < WORTH_THREADS:
            launch(kernel, **given)
            return
        key = (kernel.key, self._end, alpha, beta, x.ptr, y.ptr, z.ptr)
        if key not in self._recordings:
            self._recordings[key] = executor.record(lambda: launch(kernel, **given))
        executor.replay([(self._recordings[key], 1)])

    def _failure(self, method: str, count: int, norm: float, goal: float) -> DivergenceError:
        return DivergenceError(
            f"conduction: {method} has not converged after {count} iterations before "
            f"t = {float(self._state.time.numpy()[0]):.6g} s: the rest is {norm:.3g} J, {goal:.3g} J is asked for; "
            "shorter steps, more iterations or a larger tolerance may help"
        )


def _norm(values: wp.array) -> float:
    return float(np.sqrt(array_inner(values, values)))
