"""The submerged nozzle: rows of melt that enter at its start and are free beyond its mouth."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.machine.exchange import Exchange, bring_in, next_parked

wp.set_module_options({"enable_backward": False})


@wp.struct
class Nozzle:
    """``direction`` of the flow and ``mouth``, x . direction at its end [m]; ``spacing`` of the rows [m]; the melt's
    ``enthalpy`` [J/kg] and ``material``."""

    direction: wp.vec3
    mouth: float
    spacing: float
    enthalpy: float
    material: int


@wp.kernel
def _pour(
    first: int,
    interval: float,
    nozzle: Nozzle,
    row: wp.array[wp.vec3],
    speeds: wp.array[float],
    reservoir_start: wp.array[int],
    travel: wp.array[float],
    missing: wp.array[int],
    exchange: Exchange,
):
    travel[0] += speeds[2] * interval
    place = reservoir_start[nozzle.material]
    end = reservoir_start[nozzle.material + 1]
    while travel[0] >= nozzle.spacing:
        travel[0] -= nozzle.spacing
        for k in range(row.shape[0]):
            place = next_parked(exchange, place, end)
            if place < end:
                x = row[k] + nozzle.direction * travel[0]
                bring_in(exchange, place, int(Role.INFLOW), x, nozzle.direction * speeds[2], nozzle.enthalpy)
            else:
                missing[0] += 1


@wp.kernel
def _lead(first: int, nozzle: Nozzle, speeds: wp.array[float], exchange: Exchange):
    i = wp.tid() + first
    if exchange.role[i] == Role.INFLOW:
        exchange.velocity[i] = nozzle.direction * speeds[2]
        if wp.dot(exchange.position[i], nozzle.direction) > nozzle.mouth:
            exchange.role[i] = Role.FREE


def pour(launch, interval, nozzle, row, speeds, reservoir_start, travel, missing, exchange) -> None:
    """Move the melt in the nozzle with the pouring speed ``speeds[2]`` and bring in the rows that follow.

    ``row`` (k,) are the places of a row at the nozzle's start [m]; ``travel`` (1,) [m] is how far the last row has come
    from there; ``missing`` (1,) counts particles that the reservoir could not give.
    """
    launch(_lead, exchange.role.shape[0], [nozzle, speeds, exchange])
    launch.whole(_pour, 1, [interval, nozzle, row, speeds, reservoir_start, travel, missing, exchange])
