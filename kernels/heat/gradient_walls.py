"""Walls that the particles on them keep by their own temperature: its gradient is that of the flux that leaves."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.specialised import for_each_smoothing_kernel
from warpsph.kernels.heat.conduction import CONDUCTING, ThermalTable
from warpsph.kernels.heat.implicit import ImplicitStep
from warpsph.kernels.heat.rows import HeatRows
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.struct
class GradientPlanes:
    """Planes on which particles stand: (planes,) each.

    ``normal``, into the body; ``conductance`` [W/(m^2 K)] of a film before an ``outside`` [K]; ``flux`` [W/m^2] that
    leaves besides.
    """

    normal: wp.array[wp.vec3]
    conductance: wp.array[float]
    outside: wp.array[float]
    flux: wp.array[float]


@wp.func
def gradient_weight(planes: GradientPlanes, on: int, d: wp.vec3, slope: float) -> float:
    """2 n . grad W of a neighbour at ``-d`` [m], summed over the planes ``on`` (a bit each); ``slope`` is W'/r.

    Times V_j and the normalisation it is the weight [1/m] of T_j - T_i in the gradient at a particle on the planes.
    Rook, Yildiz & Dost (2007), equation (9) with the factor 2 of section 4.2: half of the neighbours are missing.
    """
    total = float(0.0)
    for p in range(planes.flux.shape[0]):
        if (on >> p) & 1 != 0:
            total += 2.0 * slope * wp.min(wp.dot(planes.normal[p], d), 0.0)
    return total


@wp.func
def gradient_beyond(planes: GradientPlanes, on: int, conductivity: float) -> wp.vec2:
    """What stands outside the planes ``on``: (a, b) in dT/dn = a T - b, a in 1/m and b in K/m, n into the body.

    The flux conductance (T - outside) + flux over the ``conductivity`` [W/(m K)]; of several planes the sum.
    """
    a, b = float(0.0), float(0.0)
    for p in range(planes.flux.shape[0]):
        if (on >> p) & 1 != 0:
            a += planes.conductance[p] / conductivity
            b += (planes.conductance[p] * planes.outside[p] - planes.flux[p]) / conductivity
    return wp.vec2(a, b)


def _find_surface(slope: wp.Function) -> Callable[..., None]:
    def find_surface(
        first: int,
        table: ThermalTable,
        neighbours: NeighbourList,
        gradient_planes: GradientPlanes,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        on_gradient_walls: wp.array[int],
        thermal_volume: wp.array[float],
        conductivity: wp.array[float],
        temperature: wp.array[float],
        surface_temperature: wp.array[float],
    ):
        """Write the ``surface_temperature`` (n,) [K] at which particles on walls have the gradient of their flux.

        Of several walls, in a corner, the sum of the gradients is that of the sum of the fluxes.
        """
        i = wp.tid() + first
        on = on_gradient_walls[i]
        if on == 0 or role[i] == Role.RESERVOIR:
            return
        beyond = gradient_beyond(gradient_planes, on, conductivity[i])
        weights, known = beyond[0], beyond[1]
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if role[j] != Role.RESERVOIR:
                d = difference(neighbours, position[i], position[j])
                weight = gradient_weight(gradient_planes, on, d, slope(wp.dot(d, d), table.support))
                weight *= table.scale * thermal_volume[j]
                weights += weight
                known += weight * temperature[j]
        surface_temperature[i] = wp.where(weights > 0.0, known / weights, temperature[i])

    return find_surface


FIND_SURFACE = for_each_smoothing_kernel(_find_surface, "slope", CONDUCTING, __name__)


@wp.func
def enthalpy_of(table: ThermalTable, material: int, temperature: float) -> float:
    """Enthalpy [J/kg] at a ``temperature`` [K]; where the curve is flat, at a melting point, its lower end."""
    segment = int(0)
    last = table.enthalpy.shape[1] - 2
    while segment < last and temperature > table.temperature[material, segment + 1]:
        segment += 1
    low, T_low = table.enthalpy[material, segment], table.temperature[material, segment]
    rise = table.temperature[material, segment + 1] - T_low
    share = wp.where(rise > 0.0, (temperature - T_low) / rise, 0.0)
    return low + share * (table.enthalpy[material, segment + 1] - low)


@wp.kernel
def set_surface(
    first: int,
    table: ThermalTable,
    role: wp.array[int],
    on_gradient_walls: wp.array[int],
    material: wp.array[int],
    surface_temperature: wp.array[float],
    temperature: wp.array[float],
    enthalpy: wp.array[float],
    enthalpy_carry: wp.array[float],
):
    """Give the particles on walls their ``surface_temperature`` (n,) [K], and the enthalpy [J/kg] that goes with it."""
    i = wp.tid() + first
    if on_gradient_walls[i] != 0 and role[i] != Role.RESERVOIR:
        temperature[i] = surface_temperature[i]
        enthalpy[i] = enthalpy_of(table, material[i], surface_temperature[i])
        enthalpy_carry[i] = 0.0


def _bind_surface(slope: wp.Function) -> Callable[..., None]:
    def bind_surface(
        first: int,
        table: ThermalTable,
        neighbours: NeighbourList,
        gradient_planes: GradientPlanes,
        rows: HeatRows,
        solution: ImplicitStep,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        on_gradient_walls: wp.array[int],
        thermal_volume: wp.array[float],
        conductivity: wp.array[float],
    ):
        """Write the rows of particles on walls: what :data:`FIND_SURFACE` solves for, times k V / support [W/K]."""
        i = wp.tid() + first
        on = on_gradient_walls[i]
        solution.bound[i] = wp.where(on != 0, 1, 0)
        if on == 0 or role[i] == Role.RESERVOIR:
            return
        factor = conductivity[i] * thermal_volume[i] / table.support
        beyond = gradient_beyond(gradient_planes, on, conductivity[i])
        diagonal = wp.float64(factor * beyond[0])
        for k in range(neighbours.count[i]):
            at = i * neighbours.row_stride + k * neighbours.entry_stride
            j = index_of(neighbours.entry[at])
            weight = float(0.0)
            if role[j] != Role.RESERVOIR:
                d = difference(neighbours, position[i], position[j])
                weight = gradient_weight(gradient_planes, on, d, slope(wp.dot(d, d), table.support))
                weight *= factor * table.scale * thermal_volume[j]
            rows.beside[at] = weight
            diagonal += wp.float64(weight)
        rows.diagonal[i] = diagonal
        rows.source[i] = wp.float64(factor * beyond[1])

    return bind_surface


BIND_SURFACE = for_each_smoothing_kernel(_bind_surface, "slope", CONDUCTING, __name__)
