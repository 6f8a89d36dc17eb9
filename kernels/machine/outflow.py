"""The withdrawal of the strand: a zone that moves with the casting speed, at whose end particles leave."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.machine.exchange import Exchange, take_out

wp.set_module_options({"enable_backward": False})


@wp.kernel
def hold_zone(
    first: int,
    pressure_per_height: float,
    speeds: wp.array[float],
    role: wp.array[int],
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    pressure: wp.array[float],
):
    """Give the outflow zone the casting speed ``speeds[1]`` and the pressure below a level of ``speeds[0]``."""
    i = wp.tid() + first
    if role[i] == Role.OUTFLOW:
        pressure[i] = wp.max(pressure_per_height * (speeds[0] - position[i][1]), 0.0)
        velocity[i] = wp.vec3(0.0, -speeds[1], 0.0)


@wp.kernel
def pass_on(first: int, begin: float, end: float, width: float, exchange: Exchange):
    """Take particles into the zone below ``begin`` [m] (x, z below ``width`` [m]), and out of the run below ``end``."""
    i = wp.tid() + first
    role = exchange.role[i]
    if role == Role.FREE or role == Role.OUTFLOW:
        x = exchange.position[i]
        if x[1] < end:
            take_out(exchange, i)
        elif role == Role.FREE and x[1] < begin and wp.max(x[0], x[2]) < width:
            exchange.role[i] = Role.OUTFLOW
