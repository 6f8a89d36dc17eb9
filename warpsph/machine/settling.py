"""Drag at the beginning of a run, so that a start that is not quite at rest comes to rest."""

from warpsph.core.term import BoundaryDevice
from warpsph.kernels.machine.settling import slow_down


class Settling(BoundaryDevice):
    """Slows all free particles down for a while.

    Args:
        rate: relative loss of velocity in unit time [1/s].
        until: time at which the drag ends [s].
    """

    def __init__(self, rate: float, until: float):
        self.rate, self.until = rate, until

    def after_move(self, dt: float) -> None:
        slow_down(self.launch, dt, self.rate, self.until, self.solver.time, self.state.role, self.state.velocity)
