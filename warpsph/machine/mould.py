"""The mould: walls that oscillate along y."""

from warpsph.core.term import BoundaryDevice
from warpsph.kernels.machine.mould import oscillate


class OscillatingMould(BoundaryDevice):
    """Moves every wall particle sinusoidally up and down (Vijaykumar 2012, sections 6.1 and 7.3).

    Args:
        stroke: distance between the turning points [m].
        frequency: [Hz].
    """

    def __init__(self, stroke: float, frequency: float):
        self.amplitude, self.frequency = 0.5 * stroke, frequency

    def bind(self, solver) -> None:
        super().bind(solver)
        self.state.add("rest_position", self.state.numpy("position"), self.state.position.dtype)

    def after_move(self, dt: float) -> None:
        s = self.state
        oscillate(
            self.launch,
            self.amplitude,
            self.frequency,
            self.solver.time,
            s.role,
            s.rest_position,
            s.position,
            s.velocity,
        )
