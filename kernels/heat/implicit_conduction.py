"""Implicit steps of bodies that conduct: from enthalpies to heats and temperatures, and back."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.heat.conduction import ThermalTable
from warpsph.kernels.heat.implicit import STILL, ImplicitStep
from warpsph.kernels.heat.rows import HeatRows, heat_gained
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.kernels.neighbours.pairs import NeighbourList

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def supply_no_heat(first: int, heat_rate: wp.array[float]):
    """Set ``heat_rate`` (n,) [W] to zero, before others add what they bring."""
    heat_rate[wp.tid() + first] = 0.0


@wp.kernel
def begin_conduction(
    first: int,
    solution: ImplicitStep,
    mass: wp.array[float],
    heat_rate: wp.array[float],
    enthalpy: wp.array[float],
    enthalpy_carry: wp.array[float],
):
    """Begin with the enthalpy (n,) [J/kg], with what single precision has lost of it, and what others bring."""
    i = wp.tid() + first
    solution.heat[i] = wp.float64(mass[i]) * (wp.float64(enthalpy[i]) - wp.float64(enthalpy_carry[i]))
    solution.supply[i] = wp.float64(heat_rate[i])


def _find_iterate(mixing: bool) -> Callable[..., None]:
    def find_iterate(
        first: int,
        table: ThermalTable,
        solution: ImplicitStep,
        material: wp.array[int],
        mass: wp.array[float],
        role: wp.array[int],
        held: wp.array[int],
        temperature: wp.array[float],
        solid_fraction: wp.array[float],
        conductivity: wp.array[float],
    ):
        """Write temperature and capacity of the solution from its heat, in double precision.

        And temperature [K], solid fraction and, where it is mixed from the two phases, conductivity [W/(m K)] (n,).
        """
        i = wp.tid() + first
        m = material[i]
        h = solution.heat[i] / wp.float64(mass[i])
        segment = int(0)
        while segment < table.enthalpy.shape[1] - 2 and h > wp.float64(table.enthalpy[m, segment + 1]):
            segment += 1
        low, T_low = wp.float64(table.enthalpy[m, segment]), wp.float64(table.temperature[m, segment])
        rise = wp.float64(table.temperature[m, segment + 1]) - T_low
        slope = rise / (wp.float64(table.enthalpy[m, segment + 1]) - low)
        T = T_low + slope * (h - low)
        solution.temperature[i] = T
        solution.capacity[i] = wp.float64(mass[i]) / slope
        if role[i] == Role.RESERVOIR or (held[i] != 0 and solution.bound[i] == 0):
            solution.capacity[i] = STILL
        solid = float(0.0)
        if table.solidus[m] < table.liquidus[m]:
            solid = wp.clamp((table.liquidus[m] - float(T)) / (table.liquidus[m] - table.solidus[m]), 0.0, 1.0)
        else:
            latent_heat = table.enthalpy_liquid[m] - table.enthalpy_solid[m]
            solid = wp.clamp((table.enthalpy_liquid[m] - float(h)) / latent_heat, 0.0, 1.0)
        temperature[i] = float(T)
        solid_fraction[i] = solid
        if wp.static(mixing):
            conductivity[i] = solid * table.conductivity_solid[m] + (1.0 - solid) * table.conductivity_liquid[m]

    return find_iterate


FIND_ITERATE = {
    mixing: wp.Kernel(
        _find_iterate(mixing), key=f"find_iterate_{'mixed' if mixing else 'kept'}", module=wp.get_module(__name__)
    )
    for mixing in (False, True)
}


@wp.kernel
def count_conduction(
    first: int,
    part: wp.float64,
    neighbours: NeighbourList,
    walls: HeatWalls,
    rows: HeatRows,
    solution: ImplicitStep,
    id: wp.array[int],
    held: wp.array[int],
    heat_held: wp.array[wp.float64],
):
    """Count what walls and held particles take in the time ``part`` [s], by ids: ``walls.taken``, ``heat_held``."""
    i = wp.tid() + first
    T = solution.temperature[i]
    for p in range(walls.offset.shape[0]):
        rate = rows.to_wall[p, i] * T + rows.wall_source[p, i]
        walls.rate[p, id[i]] = float(rate)
        walls.taken[p, id[i]] += part * rate
    if held[i] != 0:
        gained = heat_gained(rows, neighbours, solution.temperature, i) + rows.source[i]
        heat_held[i] += part * (gained + solution.supply[i])


@wp.kernel
def end_conduction(
    first: int,
    solution: ImplicitStep,
    role: wp.array[int],
    held: wp.array[int],
    mass: wp.array[float],
    enthalpy: wp.array[float],
    enthalpy_carry: wp.array[float],
):
    """Write the enthalpy (n,) [J/kg] and what single precision loses of it."""
    i = wp.tid() + first
    if role[i] != Role.RESERVOIR and (held[i] == 0 or solution.bound[i] != 0):
        h = solution.heat[i] / wp.float64(mass[i])
        enthalpy[i] = float(h)
        enthalpy_carry[i] = float(wp.float64(float(h)) - h)
