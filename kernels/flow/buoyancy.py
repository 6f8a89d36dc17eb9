"""Buoyancy in the approximation of Boussinesq: a field makes the fluid lighter, but nothing else of it."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role
from warpsph.kernels.basics.smoothing import wendland_c2_value
from warpsph.kernels.flow.corrected.scheme import FLUID, SOLID, WALL
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.kernel
def lift(
    first: int,
    downward: wp.vec3,
    reference: float,
    carrier: wp.array[float],
    role: wp.array[int],
    phase: wp.array[int],
    acceleration: wp.array[wp.vec3],
):
    """Add the acceleration (n,) [m/s^2] of free particles of liquid by what the ``carrier`` (n,) exceeds its reference.

    ``downward`` is gravity times the coefficient of expansion, [m/s^2] over the unit of the carrier.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE and phase[i] != Phase.SOLID:
        acceleration[i] -= downward * (carrier[i] - reference)


@wp.kernel
def lift_at_walls(
    first: int,
    downward: wp.vec3,
    reference: float,
    support: float,
    carrier: wp.array[float],
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    mass: wp.array[float],
    part: wp.array[int],
    volume_of_cell: float,
    bulk_modulus: float,
    pressure: wp.array[float],
    compression: wp.array[float],
):
    """Add what buoyancy makes of the ``pressure`` [Pa] and ``compression`` of walls and solids, (n,) each.

    Adami, Hu & Adams (2012), equation 27, with the buoyant part of the fluid's acceleration; without it a layer that
    is warmer than the reference would be pushed off a floor.
    """
    i = wp.tid() + first
    if part[i] == WALL or part[i] == SOLID:
        x_i = position[i]
        weight = float(0.0)
        weighted = float(0.0)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if part[j] == FLUID:
                d = difference(neighbours, x_i, position[j])
                W = wendland_c2_value(wp.dot(d, d), support)
                weight += W
                weighted -= W * mass[j] / volume_of_cell * (carrier[j] - reference) * wp.dot(downward, d)
        if weight > 0.0:
            pressure[i] += weighted / weight
            compression[i] += weighted / weight / bulk_modulus
