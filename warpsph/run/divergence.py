"""The watch over divergence."""

import numpy as np

from warpsph.core.labels import Role
from warpsph.core.solver import Solver
from warpsph.errors import DivergenceError
from warpsph.run.timestep import Limits, listed


def refuse_divergence(solver: Solver, limits: Limits) -> None:
    """Stop a run that has diverged or whose lists were too short.

    Raises:
        DivergenceError: which particle, where, how fast, and the limits [s] of the time step.
    """
    solver.check()
    state = solver.state
    if (index := int(state.runaway.numpy()[0]) - 1) < 0:
        return
    place = ", ".join(f"{x:.4g}" for x in state.numpy("position")[index])
    speed = float(np.linalg.norm(state.numpy("velocity")[index]))
    name = solver.model.materials[state.numpy("material")[index]].name
    role = Role(int(state.numpy("role")[index])).name.lower()
    raise DivergenceError(
        f"diverged before t = {float(state.time.numpy()[0]):.6g} s: particle {state.numpy('id')[index]} "
        f"({role}, {name}) at ({place}) m has speed {speed:.4g} m/s, limit {solver.speed_limit:.4g} m/s; "
        f"dt = {solver.dt:.3g} s against limits {listed(limits)}"
    )
