"""The submerged nozzle: rows of melt that enter at its start and are free beyond its mouth."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.machine.exchange import Exchange, bring_in, next_parked

wp.set_module_options({"enable_backward": False})


@wp.struct
class InletConstants:
    """``direction`` of the flow and ``mouth``, x . direction at its end [m]; ``spacing`` of the rows [m]; the melt's
    ``enthalpy`` [J/kg] and ``material``."""

    direction: wp.vec3
    mouth: float
    spacing: float
    enthalpy: float
    material: int


@wp.kernel
def pour(
    first: int,
    interval: float,
    inlet: InletConstants,
    row: wp.array[wp.vec3],
    speeds: wp.array[float],
    reservoir_start: wp.array[int],
    travel: wp.array[float],
    missing: wp.array[int],
    exchange: Exchange,
):
    """Bring in the rows of melt that follow at the pouring speed ``speeds[2]``; one thread.

    ``row`` (k,) are the places of a row at the nozzle's start [m]; ``travel`` (1,) [m] is how far the last row has come
    from there; ``missing`` (1,) counts particles that the reservoir could not give.
    """
    travel[0] += speeds[2] * interval
    place = reservoir_start[inlet.material]
    end = reservoir_start[inlet.material + 1]
    while travel[0] >= inlet.spacing:
        travel[0] -= inlet.spacing
        for k in range(row.shape[0]):
            place = next_parked(exchange, place, end)
            if place < end:
                x = row[k] + inlet.direction * travel[0]
                bring_in(exchange, place, int(Role.INFLOW), x, inlet.direction * speeds[2], inlet.enthalpy)
            else:
                missing[0] += 1


@wp.kernel
def lead(first: int, inlet: InletConstants, speeds: wp.array[float], exchange: Exchange):
    """Move the melt in the nozzle with the pouring speed ``speeds[2]``; beyond the mouth it is free."""
    i = wp.tid() + first
    if exchange.role[i] == Role.INFLOW:
        exchange.velocity[i] = inlet.direction * speeds[2]
        if wp.dot(exchange.position[i], inlet.direction) > inlet.mouth:
            exchange.role[i] = Role.FREE
