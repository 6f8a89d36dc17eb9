"""The cycles of a run: steps, the last one with heat, recorded once and replayed many times."""

from warpsph.core.executor import Executor, Recording
from warpsph.core.solver import Solver
from warpsph.errors import DivergenceError
from warpsph.run.divergence import refuse_divergence
from warpsph.run.schedule import CycleSteps
from warpsph.run.timestep import StepPlan


class Cycles:
    """Replays the cycles of one simulation.

    Args:
        executor, solver: what makes a step.
        plan: whether heat is conducted.
    """

    def __init__(self, executor: Executor, solver: Solver, plan: StepPlan):
        self.executor, self.solver, self.plan = executor, solver, plan
        self._recordings: dict[CycleSteps, list[tuple[Recording, int]]] = {}

    def replay(self, steps: CycleSteps, cycles: int) -> None:
        """Go on by so many cycles. Where the host finds no solution on the way, the particle that broke it is named.

        Raises:
            DivergenceError: there is no solution.
        """
        try:
            self.executor.replay(self._recorded(steps) * cycles)
        except DivergenceError:
            refuse_divergence(self.solver, self.plan)
            raise

    def seconds(self, steps: CycleSteps) -> float:
        """Wall time [s] of a cycle, by a few of its steps, which are done."""
        return sum(self.executor.seconds(recording) * count for recording, count in self._recorded(steps))

    def _recorded(self, steps: CycleSteps) -> list[tuple[Recording, int]]:
        """What is replayed for a cycle; recorded once for each length."""
        if steps not in self._recordings:
            solver, record = self.solver, self.executor.record
            usual = solver.dt, solver.interval
            solver.set_steps(steps.dt, steps.duration)
            recordings = [(record(solver.step_with_heat if self.plan.with_heat else solver.step), 1)]
            if steps.count > 1:
                recordings.insert(0, (record(solver.step), steps.count - 1))
            solver.set_steps(*usual)
            self._recordings[steps] = recordings
        return self._recordings[steps]
