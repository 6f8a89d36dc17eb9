"""Water spray: particles that fly to the strand, ride on it, boil away, and are sprayed again."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.machine.exchange import Exchange, bring_in, next_parked, take_out
from warpsph.kernels.neighbours.pairs import NeighbourList, entry_of, index_of

wp.set_module_options({"enable_backward": False})

# Evenly spread for any number of particles, alone and as a pair (powers of the golden and of the plastic ratio)
GOLDEN_RATIO = wp.constant(wp.float64(0.6180339887498949))
PLASTIC_RATIO = wp.constant(wp.float64(0.7548776662466927))


@wp.struct
class SprayZones:
    """The zones, each (zones,): ``low``, ``high`` ends [m]; ``rate`` [particles/s]; ``off`` time of failure [s]."""

    low: wp.array[float]
    high: wp.array[float]
    rate: wp.array[float]
    off: wp.array[float]


@wp.struct
class WaterConstants:
    """``nozzle`` x, or z, of the nozzles [m]; ``speed`` [m/s]; ``reach`` contact distance [m]; ``lost`` x and z behind
    which water has missed the strand [m]; ``breadth`` of the faces [m], 0 in the plane; ``enthalpy`` when sprayed and
    when ``boiled`` [J/kg]; its ``material``."""

    nozzle: float
    speed: float
    reach: float
    lost: float
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


@wp.kernel
def ride(first: int, water: WaterConstants, neighbours: NeighbourList, exchange: Exchange):
    """Let water fly, and ride on the nearest free particle within its reach."""
    i = wp.tid() + first
    if exchange.role[i] == Role.SPRAY:
        x_i = exchange.position[i]
        nearest = water.reach * water.reach
        velocity = flight(water, x_i)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = x_i - exchange.position[j]
            if exchange.role[j] == Role.FREE and wp.dot(d, d) < nearest:
                nearest = wp.dot(d, d)
                velocity = exchange.velocity[j]
        exchange.velocity[i] = velocity


@wp.kernel
def boil(first: int, water: WaterConstants, exchange: Exchange):
    """Take out the water that has boiled, or missed the strand."""
    i = wp.tid() + first
    if exchange.role[i] == Role.SPRAY and (
        exchange.enthalpy[i] >= water.boiled or distance(water, exchange.position[i]) < water.lost
    ):
        take_out(exchange, i)
