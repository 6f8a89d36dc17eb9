"""Watching over the particles at the end of a step, and keeping the first offence of a run as it was."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.labels import Role

wp.set_module_options({"enable_backward": False, "fast_math": False})

# What has become of the first offence
SEEN = wp.constant(1)
NOTED = wp.constant(2)

# What may offend beside a bounded field, by number
NEIGHBOURS = wp.constant(-1)
BONDS = wp.constant(-2)

NO_ID = wp.constant(2**31 - 1)

SLOTS = 6  # fields at which one launch looks
WHO = 8  # integers that are kept of an offence
NUMBERS = 7  # real numbers that are kept of it, before those of the bounded fields


vec_slots = wp.types.vector(SLOTS, float)


@wp.struct
class Bounded:
    """A field (n,) and what its values lie between. Both limits are excluded: infinite ones ask for numbers only."""

    values: wp.array[float]
    lower: float
    upper: float


@wp.struct
class Offence:
    """The first offence of a run.

    ``state`` (1,): 0 none, SEEN, or NOTED. ``who`` (WHO,): quantity, id, role, material, phase, steps so far, and of a
    row that is too long its length and what it has room for. ``numbers`` (NUMBERS + fields,): time [s], position [m],
    velocity [m/s] and the values of the bounded fields. The quantity is the number of the field, of the speed, which
    follows the fields, or of the position, which follows that; or NEIGHBOURS or BONDS.
    """

    state: wp.array[int]
    who: wp.array[int]
    numbers: wp.array[wp.float64]


@wp.func
def within(value: float, lower: float, upper: float) -> bool:
    return value > lower and value < upper


@wp.func
def offending_quantity(
    i: int, x: wp.vec3, u: wp.vec3, speed_limit_squared: float, bounded: wp.array[Bounded], none: int
) -> int:
    """Which quantity of particle i is beyond its bounds, the first one of several; ``none`` where all is well."""
    for k in range(bounded.shape[0]):
        if not within(bounded[k].values[i], bounded[k].lower, bounded[k].upper):
            return k
    if not (wp.dot(u, u) < speed_limit_squared):
        return none - 2
    if not wp.isfinite(wp.dot(x, x)):
        return none - 1
    return none


@wp.func
def keep_offence(
    i: int,
    quantity: int,
    steps: wp.array[int],
    time: wp.array[wp.float64],
    id: wp.array[int],
    role: wp.array[int],
    material: wp.array[int],
    phase: wp.array[int],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    bounded: wp.array[Bounded],
    offence: Offence,
):
    offence.who[0] = quantity
    offence.who[1] = id[i]
    offence.who[2] = role[i]
    offence.who[3] = material[i]
    offence.who[4] = phase[i]
    offence.who[5] = steps[0]
    offence.numbers[0] = time[0]
    for axis in range(3):
        offence.numbers[1 + axis] = wp.float64(position[i][axis])
        offence.numbers[4 + axis] = wp.float64(velocity[i][axis])
    for k in range(bounded.shape[0]):
        offence.numbers[wp.static(NUMBERS) + k] = wp.float64(bounded[k].values[i])
    offence.state[0] = NOTED


def _make(fields: int) -> Callable[..., None]:
    def watch(
        first: int,
        role: wp.array[int],
        position: wp.array[wp.vec3],
        velocity: wp.array[wp.vec3],
        reference: wp.array[wp.vec3],
        farthest_squared: float,
        speed_limit_squared: float,
        lower: vec_slots,
        upper: vec_slots,
        field_0: wp.array[float],
        field_1: wp.array[float],
        field_2: wp.array[float],
        field_3: wp.array[float],
        field_4: wp.array[float],
        field_5: wp.array[float],
        outdated: wp.array[int],
        offence_state: wp.array[int],
    ):
        """Raise ``outdated`` where a particle is farther from its ``reference`` position than allowed or out of bounds.

        ``farthest_squared`` [m^2], ``speed_limit_squared`` [m^2/s^2]. An offence renews the list because what comes
        first there is :func:`note_offence`, before anything has moved; after that no list is renewed for it.
        """
        i = wp.tid() + first
        if role[i] != Role.RESERVOIR:
            d = position[i] - reference[i]
            u = velocity[i]
            sound = wp.dot(u, u) < speed_limit_squared
            if wp.static(fields > 0):
                sound = sound and within(field_0[i], lower[0], upper[0])
            if wp.static(fields > 1):
                sound = sound and within(field_1[i], lower[1], upper[1])
            if wp.static(fields > 2):
                sound = sound and within(field_2[i], lower[2], upper[2])
            if wp.static(fields > 3):
                sound = sound and within(field_3[i], lower[3], upper[3])
            if wp.static(fields > 4):
                sound = sound and within(field_4[i], lower[4], upper[4])
            if wp.static(fields > 5):
                sound = sound and within(field_5[i], lower[5], upper[5])
            if not (sound and wp.dot(d, d) <= farthest_squared) and offence_state[0] == 0:
                outdated[0] = 1
                if not (sound and wp.isfinite(wp.dot(position[i], position[i]))):
                    offence_state[0] = SEEN

    return watch


# By the number of fields that are bounded: a loop over an array of structures would take three times as long.
WATCH = [wp.Kernel(_make(fields), key=f"watch_{fields}", module=wp.get_module(__name__)) for fields in range(SLOTS + 1)]


@wp.kernel
def note_offence(
    first: int,
    count: int,
    speed_limit_squared: float,
    steps: wp.array[int],
    time: wp.array[wp.float64],
    id: wp.array[int],
    role: wp.array[int],
    material: wp.array[int],
    phase: wp.array[int],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    bounded: wp.array[Bounded],
    offence: Offence,
):
    """Keep who has offended, if somebody has been seen: of the first quantity the particle with the smallest id.

    One thread.
    """
    if offence.state[0] == SEEN:
        none = bounded.shape[0] + 2
        worst = none
        found = first
        for i in range(count):
            if role[i] != Role.RESERVOIR:
                quantity = offending_quantity(i, position[i], velocity[i], speed_limit_squared, bounded, none)
                if quantity < worst or (quantity == worst and quantity < none and id[i] < id[found]):
                    worst = quantity
                    found = i
        offence.state[0] = 0
        if worst < none:
            keep_offence(found, worst, steps, time, id, role, material, phase, position, velocity, bounded, offence)


@wp.kernel
def note_overflow(
    first: int,
    count: int,
    quantity: int,
    capacity: int,
    longest: wp.array[int],
    row_length: wp.array[int],
    steps: wp.array[int],
    time: wp.array[wp.float64],
    id: wp.array[int],
    role: wp.array[int],
    material: wp.array[int],
    phase: wp.array[int],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    bounded: wp.array[Bounded],
    offence: Offence,
):
    """Keep whose row was too short, if ``longest`` (1,) says that one was: the smallest id of a ``row_length`` (n,)
    above ``capacity``. ``quantity`` is NEIGHBOURS or BONDS. One thread.
    """
    if longest[0] > 0 and offence.state[0] != NOTED:
        found = first
        smallest = int(NO_ID)
        for i in range(count):
            if row_length[i] > capacity and id[i] < smallest:
                found = i
                smallest = id[i]
        if smallest < NO_ID:
            keep_offence(found, quantity, steps, time, id, role, material, phase, position, velocity, bounded, offence)
            offence.who[6] = row_length[found]
            offence.who[7] = capacity
