"""How conduction goes from one step with heat to the next: explicitly, or by solving for the end of the step."""

from dataclasses import dataclass
from numbers import Integral
from typing import Any

from warpsph.errors import number, require


@dataclass(frozen=True)
class Explicit:
    """The heat of a step is that at its begin: cheap, and stable up to a step that goes with the spacing squared."""


@dataclass(frozen=True)
class Implicit:
    """What the implicit integrators share: the step is solved for, by Newton's method over linear systems.

    Args:
        tolerance: largest rest of a step over the heat that it moves, both as root mean squares over the particles.
        most_iterations: of the linear solver, for each system.
    """

    tolerance: float = 1.0e-5
    most_iterations: int = 2000

    def __post_init__(self) -> None:
        require(self, "tolerance", 1e-12 <= number(self.tolerance) <= 1e-2, "from 1e-12 to 1e-2")
        require(self, "most_iterations", _whole(self.most_iterations, 1), "a whole number, 1 or more")


@dataclass(frozen=True)
class BackwardEuler(Implicit):
    """Heat as it flows at the end of the step: first order in the step, stable and free of ringing for any.

    Rook, Yildiz & Dost (2007), equation (15).
    """


@dataclass(frozen=True)
class CrankNicolson(Implicit):
    """The mean of begin and end of the step: second order in the step, stable for any.

    Rook, Yildiz & Dost (2007), equation (18). It does not damp what is much shorter than a step can follow, so what
    jumps at the start would ring: the first steps are two halves of :class:`BackwardEuler` each (Rannacher 1984).

    Args:
        damped_steps: how many.
    """

    damped_steps: int = 2

    def __post_init__(self) -> None:
        super().__post_init__()
        require(self, "damped_steps", _whole(self.damped_steps, 0), "a whole number, 0 or more")


def _whole(value: Any, least: int) -> bool:
    return isinstance(value, Integral) and not isinstance(value, bool) and int(value) >= least


Integrator = Explicit | BackwardEuler | CrankNicolson
EXPLICIT = Explicit()
INTEGRATORS = "Explicit(), BackwardEuler() or CrankNicolson()"
NO_LIMIT = "an implicit integrator is stable for any step; say how long it is [s]"
