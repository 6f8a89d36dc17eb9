"""What a term is: a kind of physics, or a part of a machine, that acts at the moments of a step."""

from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsph.core.bound import Bound
from warpsph.core.content import Content
from warpsph.core.field import Field, Value
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State

MOMENTS = (
    "set_out", "kick_little", "drift", "sum_fast_forces", "add_fast_forces",
    "find_density", "prescribe", "arrive", "find_walls", "sum_forces", "add_forces", "kick", "move", "watch",
    "sum_heat", "add_heat", "after_heat", "find_temperature", "change_phases",
)  # fmt: skip


class Term:
    """One kind of physics or one part of a machine.

    A subclass is a dataclass whose fields are its parameters. It declares the arrays that it needs as class attributes,
    :class:`~warpsph.core.field.Field` and :class:`~warpsph.core.field.Value`, and overrides the moments of a step at
    which it acts. A moment that no term of a case acts at costs nothing.

    Class attributes:
        provides: what others may need of it; two terms that provide the same exclude each other.
        needs: what others of the case must provide.
        follows: what it acts after, where that is there; also after what it needs, unless that needs it, too.
    """

    provides: ClassVar[tuple[str, ...]] = ()
    needs: ClassVar[tuple[str, ...]] = ()
    follows: ClassVar[tuple[str, ...]] = ()

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        for name, value in vars(cls).items():
            if isinstance(value, Field | Value) and hasattr(Term, name):
                raise TypeError(f"{cls.__name__}: every term has something called '{name}'; choose another name")

    # whether its forces are opposite in each pair, so that free bodies keep their momentum to rounding; asked of all
    # that acts where there are forces, or where velocities change
    keeps_momentum: ClassVar[bool] = False

    @property
    def arrays(self) -> dict[str, wp.array]:
        """The device arrays of its values, by name, once it belongs to a simulation."""
        return self.__dict__.setdefault("_arrays", {})

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Start values (n, ...) of fields that are more than one number or what the particles were given.

        ``fields`` holds those of all fields so far; material indices under "material".
        """
        return {}

    def allocate(self, model: Model, state: State) -> None:
        """Make lists that are not one entry a particle, by ``state.hold_list``."""

    def bytes_each(self, model: Model) -> float:
        """Memory [bytes] a particle of the lists that it allocates."""
        return 0.0

    def constants(self, model: Model, state: State) -> dict[str, Any]:
        """Constants and lists for its kernels, by the names of their arguments; called once, before the first step."""
        return {}

    def reach(self, model: Model) -> float:
        """Distance [m] up to which it must know the neighbours of a particle."""
        return 0.0

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        """Longest stable time steps [s], each with its reason; ``moving`` are the indices of materials that move."""
        return {}

    def longest_small_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        """Longest stable small steps [s] between two moments of its fast forces, each with its reason."""
        return {}

    def longest_intervals(self, model: Model) -> dict[str, float]:
        """Longest stable intervals [s] between two steps with heat, each with its reason."""
        return {}

    def speed_limit(self, model: Model) -> float:
        """Speed [m/s] that no particle can have unless the simulation has diverged."""
        return np.inf

    def bounds(self, model: Model, state: State) -> dict[str, Bound]:
        """What values of fields, by their names, cannot reach unless the simulation has diverged.

        Looked at after each step on the device; of several that are beyond their bounds the first one is reported, so
        causes stand before what follows from them. ``state`` is that of the start. Fields of ``float`` only.
        """
        return {}

    def initialise(self, launch: Launch) -> None:
        """Bring up to date what follows from the initial state, before phases change for the first time."""

    def set_out(self, launch: Launch) -> None:
        """Begin to move halfway, before the density is found there; single particles only."""

    def drift(self, launch: Launch) -> None:
        """Move by ``small_dt``, one or more times on either half of the way; single particles only."""

    def sum_fast_forces(self, launch: Launch) -> None:
        """Begin the fast acceleration of a small step, and find for each particle what it is made of."""

    def add_fast_forces(self, launch: Launch) -> None:
        """Add to the fast acceleration what is made of the sums that ``sum_fast_forces`` has found for others."""

    def kick_little(self, launch: Launch) -> None:
        """Advance the velocity by the fast acceleration, for half a small step; single particles only."""

    def find_density(self, launch: Launch) -> None:
        """Find density, pressure and volume of the fluid. May read other particles' positions, masses and velocities.

        Here ``dt`` is zero before the first step. What reads velocities ends with ``launch.meet()``.
        """

    def prescribe(self, launch: Launch) -> None:
        """Set pressure and velocity of the particles that a part leads; single particles only."""

    def arrive(self, launch: Launch) -> None:
        """Act between the density in the middle of the step and the other half of the way; single particles only."""

    def find_walls(self, launch: Launch) -> None:
        """Find what walls show to the fluid, from density and pressure."""

    def sum_forces(self, launch: Launch) -> None:
        """Add to the acceleration, and find for each particle what other terms' forces are made of."""

    def add_forces(self, launch: Launch) -> None:
        """Add to the acceleration what is made of the sums that ``sum_forces`` has found for other particles.

        May not read other particles' velocities: ``kick`` changes them at the same time.
        """

    def kick(self, launch: Launch) -> None:
        """Advance the velocity by the step ``dt``; single particles only."""

    def move(self, launch: Launch) -> None:
        """Advance the position by the step ``dt``, or correct it; single particles only."""

    def watch(self, launch: Launch) -> None:
        """Look at the particles at the end of a step."""

    def sum_heat(self, launch: Launch) -> None:
        """Find, or add to, the heat that flows into each particle in unit time."""

    def add_heat(self, launch: Launch) -> None:
        """Add the heat of ``interval``."""

    def after_heat(self, launch: Launch) -> None:
        """Act after heat has been conducted for ``interval``: measure, bring particles in and take them out."""

    def find_temperature(self, launch: Launch) -> None:
        """Find what follows from the enthalpy."""

    def change_phases(self, launch: Launch) -> None:
        """Change phases, and what hangs on them."""

    def wrap(self, launch: Launch) -> None:
        """Bring places into the periodic box, before particles are sorted; only where there is one."""

    def follow_sorting(self, launch: Launch) -> None:
        """Follow the particles to their new places: ``order`` and ``place`` say where they came from and went."""

    def follow_listing(self, launch: Launch) -> None:
        """Act on a neighbour list that has just been made."""

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        """The axes (0, 1, 2) along which it has one place in space: along them the box cannot be periodic."""
        return ()

    def contents(self, model: Model, state: State) -> dict[str, Content]:
        """What there is now of the quantities that it conserves, by name; for the ledgers of a run.

        What changes them from outside, other terms say in :meth:`gains`.
        """
        return {}

    def gains(self, state: State) -> dict[str, dict[str, float | np.ndarray]]:
        """How much of conserved quantities has come in since the start, by quantity and way; terms may share a way."""
        return {}

    def summary(self) -> dict[str, str]:
        """What is to be said of it at the end of a run, by a few words."""
        return {}

    def facts(self) -> dict[str, Any]:
        """What pictures must know of it, for the provenance of a result file."""
        return {}

    def check(self, state: State) -> None:
        """Look, on the host, whether something has gone wrong.

        Raises:
            DivergenceError: it has.
        """


def acts_at(term: Term, moment: str) -> bool:
    """Whether a term does something at a moment."""
    return getattr(type(term), moment) is not getattr(Term, moment)
