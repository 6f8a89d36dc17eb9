"""Bringing particles in from the reservoir and taking them out, with the ledger of what passes."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role

wp.set_module_options({"enable_backward": False})


@wp.struct
class Exchange:
    """What changes of a particle when it enters or leaves, each (n,), and what the ledger keeps of its passages.

    ``entered`` marks what has just come in; ``entries``, ``exits`` count passages; ``heat_entered``, ``heat_left`` [J]
    (float64) are the enthalpies that these carried. ``reference`` is the position at which the neighbour list was made;
    ``phase_changed`` (1,) asks for new bonds.

    Neither an entry nor an exit needs a new neighbour list at once: what has left weighs nothing and takes up no room
    until it comes back, and what enters has no neighbours until it has moved.
    """

    role: wp.array[int]
    phase: wp.array[int]
    position: wp.array[wp.vec3]
    position_carry: wp.array[wp.vec3]
    velocity: wp.array[wp.vec3]
    enthalpy: wp.array[float]
    enthalpy_carry: wp.array[float]
    mass: wp.array[float]
    fluid_mass: wp.array[float]
    volume: wp.array[float]
    reference: wp.array[wp.vec3]
    entered: wp.array[int]
    entries: wp.array[int]
    exits: wp.array[int]
    heat_entered: wp.array[wp.float64]
    heat_left: wp.array[wp.float64]
    phase_changed: wp.array[int]


@wp.func
def bring_in(exchange: Exchange, i: int, role: int, position: wp.vec3, velocity: wp.vec3, enthalpy: float):
    """Put the reservoir's particle ``i`` into the simulation."""
    exchange.role[i] = role
    exchange.phase[i] = Phase.LIQUID
    exchange.position[i] = position
    exchange.reference[i] = position
    exchange.position_carry[i] = wp.vec3()
    exchange.velocity[i] = velocity
    exchange.enthalpy[i] = enthalpy
    exchange.enthalpy_carry[i] = 0.0
    if role != Role.SPRAY:
        exchange.fluid_mass[i] = exchange.mass[i]
    exchange.entered[i] = 1
    exchange.entries[i] += 1
    exchange.heat_entered[i] += wp.float64(exchange.mass[i]) * wp.float64(enthalpy)


@wp.func
def next_parked(exchange: Exchange, place: int, end: int) -> int:
    """The first particle from ``place`` on that is still in the reservoir, or ``end``."""
    while place < end and exchange.role[place] != Role.RESERVOIR:
        place += 1
    return place


@wp.func
def take_out(exchange: Exchange, i: int):
    """Return particle ``i`` to the reservoir."""
    exchange.role[i] = Role.RESERVOIR
    exchange.phase[i] = Phase.LIQUID
    exchange.velocity[i] = wp.vec3()
    exchange.fluid_mass[i] = 0.0
    exchange.volume[i] = 0.0
    exchange.exits[i] += 1
    exchange.heat_left[i] += wp.float64(exchange.mass[i]) * wp.float64(exchange.enthalpy[i])
    exchange.phase_changed[0] = 1
