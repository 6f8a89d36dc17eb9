"""Water spray: particles that fly to the strand, ride on it, boil away, and are sprayed again."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.machine.exchange import Exchange, bring_in, next_parked, take_out
from warpsph.kernels.machine.rolls import RollConstants, way_from_roll
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})

# Evenly spread for any number of particles, alone and as a pair (powers of the golden and of the plastic ratio)
GOLDEN_RATIO = wp.constant(wp.float64(0.6180339887498949))
PLASTIC_RATIO = wp.constant(wp.float64(0.7548776662466927))
OUTWARDS = wp.constant(100.0)  # rate at which water gets out of the way of a strand that bulges [1/s]


@wp.struct
class SprayZones:
    """The zones, each (zones,): ``low``, ``high`` ends [m]; ``rate`` [particles/s]; ``off`` time of failure [s]."""

    low: wp.array[float]
    high: wp.array[float]
    rate: wp.array[float]
    off: wp.array[float]


@wp.struct
class WaterConstants:
    """``nozzle`` x, or z, of the nozzles [m]; ``speed`` [m/s]; ``reach`` contact distance [m]; ``stand`` distance at
    which it stands on the strand [m]; ``spacing`` [m]; ``lost`` x and z behind which water has missed the strand, and
    ``end`` height below which it has left with it [m]; ``breadth`` of the faces [m], 0 in the plane; ``enthalpy`` when
    sprayed and when ``boiled`` [J/kg]; its ``material``."""

    nozzle: float
    speed: float
    reach: float
    stand: float
    spacing: float
    lost: float
    end: float
    breadth: float
    enthalpy: float
    boiled: float
    material: int


@wp.func
def flight(water: WaterConstants, x: wp.vec3) -> wp.vec3:
    """Velocity of water at ``x`` on its way to the face before it."""
    velocity = wp.vec3(-water.speed, 0.0, 0.0)
    if water.breadth > 0.0 and x[2] > x[0]:
        velocity = wp.vec3(0.0, 0.0, -water.speed)
    return velocity


@wp.func
def distance(water: WaterConstants, x: wp.vec3) -> float:
    """Distance of water at ``x`` from the axis, along its flight."""
    away = x[0]
    if water.breadth > 0.0:
        away = wp.max(x[0], x[2])
    return away


@wp.kernel
def emit(
    first: int,
    interval: float,
    zones: SprayZones,
    water: WaterConstants,
    time: wp.array[wp.float64],
    reservoir_start: wp.array[int],
    due: wp.array[float],
    sprayed: wp.array[int],
    missing: wp.array[int],
    exchange: Exchange,
):
    """Spray the water that is due since the last time (Vijaykumar 2012, section 6.4); one thread.

    ``due`` (zones,) is the fraction of the next particle; ``sprayed`` (zones,) counts particles; ``missing`` (1,) those
    that the reservoir could not give.
    """
    place = reservoir_start[water.material]
    end = reservoir_start[water.material + 1]
    for zone in range(zones.rate.shape[0]):
        if time[0] < wp.float64(zones.off[zone]):
            due[zone] += zones.rate[zone] * interval
        while due[zone] >= 1.0:
            due[zone] -= 1.0
            place = next_parked(exchange, place, end)
            if place < end:
                sprayed[zone] += 1
                count = sprayed[zone]
                if water.breadth > 0.0:
                    count = sprayed[zone] / 2  # the faces take turns
                turn = wp.float64(count) * GOLDEN_RATIO
                height = zones.low[zone] + float(turn - wp.floor(turn)) * (zones.high[zone] - zones.low[zone])
                turn = wp.float64(count) * PLASTIC_RATIO
                across = float(turn - wp.floor(turn)) * water.breadth
                x = wp.vec3(water.nozzle, height, across)
                if water.breadth > 0.0 and sprayed[zone] % 2 == 0:
                    x = wp.vec3(across, height, water.nozzle)
                bring_in(exchange, place, int(Role.SPRAY), x, flight(water, x), water.enthalpy)
            else:
                missing[0] += 1


@wp.func
def beside_rolls(rolls: RollConstants, away: float, height: float, velocity: wp.vec2) -> wp.vec2:
    """What is left of a velocity (away, up) beside the rolls, into which water cannot run."""
    for roll in range(rolls.heights.shape[0]):
        way = way_from_roll(rolls, roll, away, height)
        normal = wp.vec2(way[1], way[2])
        if way[0] < rolls.clearance:
            velocity -= wp.min(wp.dot(velocity, normal), 0.0) * normal
    return velocity


@wp.kernel
def ride(
    first: int,
    water: WaterConstants,
    rolls: RollConstants,
    neighbours: NeighbourList,
    caught: wp.array[int],
    exchange: Exchange,
):
    """Let water fly, and ride on the strand: on its nearest particle within reach, outside of all that are beside it.

    In the nip of a roll it stands until it boils. What the strand has closed over all the same is taken out, and
    counted in ``caught`` (1,).
    """
    i = wp.tid() + first
    if exchange.role[i] == Role.SPRAY:
        x_i = exchange.position[i]
        away = distance(water, x_i)
        velocity = flight(water, x_i)
        outwards = velocity / -water.speed
        nearest = water.reach * water.reach
        surface = float(-1.0e30)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if exchange.role[j] == Role.FREE or exchange.role[j] == Role.OUTFLOW:
                d = difference(neighbours, x_i, exchange.position[j])
                beyond = wp.dot(d, outwards)
                if wp.length(d - beyond * outwards) < 0.75 * water.spacing:
                    surface = wp.max(surface, away - beyond)
                if wp.dot(d, d) < nearest:
                    nearest = wp.dot(d, d)
                    velocity = exchange.velocity[j]
        behind = surface + water.stand - away
        if behind > 0.0:
            velocity += outwards * wp.min(OUTWARDS * behind, water.speed)
        if water.breadth > 0.0 and outwards[2] > 0.0:
            left = beside_rolls(rolls, x_i[2], x_i[1], wp.vec2(velocity[2], velocity[1]))
            velocity = wp.vec3(velocity[0], left[1], left[0])
        else:
            left = beside_rolls(rolls, x_i[0], x_i[1], wp.vec2(velocity[0], velocity[1]))
            velocity = wp.vec3(left[0], left[1], velocity[2])
        exchange.velocity[i] = velocity
        if behind > water.stand + water.spacing:
            take_out(exchange, i)
            wp.atomic_add(caught, 0, 1)


@wp.kernel
def boil(first: int, water: WaterConstants, exchange: Exchange):
    """Take out the water that has boiled, missed the strand, or left with it."""
    i = wp.tid() + first
    if exchange.role[i] == Role.SPRAY:
        x = exchange.position[i]
        if exchange.enthalpy[i] >= water.boiled or distance(water, x) < water.lost or x[1] < water.end:
            take_out(exchange, i)
