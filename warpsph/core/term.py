"""What boundary devices have in common."""

from typing import TYPE_CHECKING

import numpy as np
import warp as wp

from warpsph.kernels.machine.exchange import Exchange

if TYPE_CHECKING:
    from warpsph.core.solver import Solver


class BoundaryDevice:
    """Acts on the particles at three moments of a step; a subclass fills in those that it needs."""

    def bind(self, solver: "Solver") -> None:
        """Take hold of the solver's state and allocate what the device needs, once, before the first step."""
        self.solver, self.state, self.launch = solver, solver.state, solver.executor

    def after_density(self, dt: float) -> None:
        """Act on single particles between the pressure and the forces of a step of ``dt`` [s]."""

    def after_move(self, dt: float) -> None:
        """Act on single particles at the end of a step of ``dt`` [s]."""

    def after_heat(self, interval: float) -> None:
        """Act after heat has been conducted for ``interval`` [s], before phases change."""


def exchange_of(solver: "Solver") -> Exchange:
    """The arrays through which devices bring particles in and take them out; adds the ledger to the state."""
    state = solver.state
    if "entries" not in state.per_particle:
        for name in ("entries", "exits"):
            state.add(name, np.zeros(state.count), int)
        for name in ("heat_entered", "heat_left"):
            state.add(name, np.zeros(state.count), wp.float64)
    exchange = Exchange()
    for name in (
        "role", "phase", "position", "position_carry", "velocity", "enthalpy", "enthalpy_carry", "mass",
        "fluid_mass", "volume", "entries", "exits", "heat_entered", "heat_left",
    ):  # fmt: skip
        setattr(exchange, name, state.per_particle[name])
    exchange.reference = solver.neighbours.reference
    exchange.phase_changed = solver.phase_changed
    return exchange
