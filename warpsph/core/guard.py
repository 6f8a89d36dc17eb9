"""The guard over divergence: what is bounded, and what the device has kept of the first offence."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.bound import Bound
from warpsph.core.labels import Phase, Role
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.kernels.basics.guard import (
    BONDS,
    NEIGHBOURS,
    NOTED,
    NUMBERS,
    SLOTS,
    WATCH,
    WHO,
    Bounded,
    Offence,
    note_offence,
    note_overflow,
    vec_slots,
)
from warpsph.nearest import did_you_mean


@dataclass(frozen=True)
class Reading:
    """The value of a quantity of a particle, and its bound."""

    name: str
    value: float
    unit: str
    bound: Bound

    def __str__(self) -> str:
        return f"{self.name} {self.value:.6g} {self.unit}".rstrip()


@dataclass(frozen=True)
class Offender:
    """The particle that was the first beyond a bound.

    ``what`` is the quantity, or of what a row was too short: it then needed ``length`` entries and had ``room`` for
    fewer. ``readings`` are all quantities that are bounded, at that moment. ``position`` (3,) [m], ``time`` [s].
    """

    id: int
    role: Role
    material: str
    phase: Phase
    position: np.ndarray
    time: float
    steps: int
    what: str
    readings: tuple[Reading, ...]
    length: int
    room: int

    @property
    def reading(self) -> Reading | None:
        """The one that is beyond its bound; None where a row was too short."""
        return next((reading for reading in self.readings if reading.name == self.what), None)


class Guard:
    """Looks after each step whether every particle is within its bounds, on the device.

    The state gets ``offence``, the first one of the run: at the end of the step that it happened in, the quantity that
    comes first among the bounds of the terms, then speed and position, and of that the particle with the smallest id.

    Args:
        model: gives the terms, composed, and their bounds.
        state: the particles.
        speed_limit: [m/s].

    Raises:
        InputError: a term bounds what is no field of single numbers.

    Attributes:
        constants: for the kernels, by the names of their arguments.
    """

    def __init__(self, model: Model, state: State, speed_limit: float):
        self._model, self._state = model, state
        self.bounds = _bounds(model, state)
        self._speed = Bound(upper=speed_limit, cause=_TOO_FAST)
        bounded = [_on_device(state.arrays[name], bound) for name, bound in self.bounds.items()]
        self.constants: dict[str, Any] = {
            "speed_limit_squared": speed_limit**2,
            "bounded": wp.array(bounded, dtype=Bounded, device=state.device),
            "watched": _slots(list(self.bounds.values()), [state.arrays[name] for name in self.bounds], state.device),
        }
        offence: Any = Offence()
        offence.state = wp.zeros(1, dtype=int, device=state.device)
        offence.who = wp.zeros(WHO, dtype=int, device=state.device)
        offence.numbers = wp.zeros(NUMBERS + len(bounded), dtype=wp.float64, device=state.device)
        state.hold_list("offence", offence)

    def note(self, launch: Launch) -> None:
        """Keep what has been seen at the end of the step, before anything moves."""
        launch.whole(note_offence, count=launch.count)

    def note_neighbours(self, launch: Launch) -> None:
        """Keep whose row of neighbours is too short."""
        note_row(launch, NEIGHBOURS, launch.find("longest_row"), launch.find("neighbours").capacity)

    def find_offender(self, launch: Launch) -> Offender | None:
        """Look at the present state as well, from the host; the first offender of the run, if there is one."""
        watch(launch)
        self.note(launch)
        offence = self._state.offence
        if int(offence.state.numpy()[0]) != NOTED:
            return None
        quantity, id, role, material, phase, steps, length, room = (int(value) for value in offence.who.numpy())
        time, *vectors = (float(value) for value in offence.numbers.numpy())
        position, velocity, values = np.array(vectors[:3]), np.array(vectors[3:6]), vectors[6:]
        readings = self._readings(position, velocity, values)
        named = {NEIGHBOURS: "neighbours", BONDS: "bonds"}
        return Offender(
            id,
            Role(role),
            self._model.materials[material].name,
            Phase(phase),
            position,
            time,
            steps,
            named[quantity] if quantity in named else readings[quantity].name,
            readings,
            length,
            room,
        )

    def _readings(self, position: np.ndarray, velocity: np.ndarray, values: list[float]) -> tuple[Reading, ...]:
        fields = self._state.fields
        readings = [
            Reading(fields[name].label, value, fields[name].unit, bound)
            for (name, bound), value in zip(self.bounds.items(), values, strict=True)
        ]
        readings.append(Reading("speed", float(np.linalg.norm(velocity)), "m/s", self._speed))
        readings.append(Reading("distance from the origin", float(np.linalg.norm(position)), "m", _PLACE))
        return tuple(readings)


def watch(launch: Launch) -> None:
    """Look at the particles: whether the neighbour list is to be renewed, and whether all is within its bounds."""
    for fields, arguments in launch.find("watched"):
        launch(WATCH[fields], offence_state=launch.find("offence").state, **arguments)


def note_row(launch: Launch, quantity: int, longest: wp.array, capacity: int) -> None:
    """Keep whose row was too short, if ``longest`` (1,) says that one was longer than its ``capacity``."""
    launch.whole(note_overflow, count=launch.count, quantity=quantity, longest=longest, capacity=capacity)


_TOO_FAST = (
    "a time step beyond its limit, particles that overlap, a sound speed or stiffness that is too low for the "
    "motion; take a smaller step, or look at the frames before"
)
_PLACE = Bound(cause="a place or a velocity that somebody has set to what is no number; look at observers and parts")


def _bounds(model: Model, state: State) -> dict[str, Bound]:
    """The bounds of all terms by field; of two for one field the narrower limits hold."""
    bounds: dict[str, Bound] = {}
    for term in model.terms:
        for name, bound in term.bounds(model, state).items():
            if name not in state.fields or state.fields[name].dtype is not float:
                known = [known for known, field in state.fields.items() if field.dtype is float]
                kind = type(term).__name__
                raise InputError(
                    f"{kind}.bounds: no field of single numbers is called '{name}'{did_you_mean(name, known)}"
                )
            other = bounds.get(name, Bound())
            lower, upper = max(bound.lower, other.lower), min(bound.upper, other.upper)
            bounds[name] = Bound(lower, upper, bound.cause or other.cause)
    return bounds


def _slots(bounds: list[Bound], values: list[wp.array], device: wp.Device) -> list[tuple[int, dict[str, Any]]]:
    """How many fields each launch looks at, and its arguments for them."""
    launches = []
    empty = wp.zeros(0, dtype=float, device=device)
    for begin in range(0, max(len(bounds), 1), SLOTS):
        mine, arrays = bounds[begin : begin + SLOTS], values[begin : begin + SLOTS]
        unused = SLOTS - len(mine)
        arguments: dict[str, Any] = {f"field_{k}": array for k, array in enumerate(arrays + [empty] * unused)}
        arguments["lower"] = vec_slots(*(bound.lower for bound in mine), *[0.0] * unused)
        arguments["upper"] = vec_slots(*(bound.upper for bound in mine), *[0.0] * unused)
        launches.append((len(mine), arguments))
    return launches


def _on_device(values: wp.array, bound: Bound) -> Any:
    bounded: Any = Bounded()
    bounded.values, bounded.lower, bounded.upper = values, bound.lower, bound.upper
    return bounded
