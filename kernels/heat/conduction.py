"""Heat conduction between particles, and the enthalpy and temperature that follow."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.compensation import compensated_sum
from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.specialised import for_each_smoothing_kernel
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})

CONDUCTING = ("poly6", "cubic_spline")  # the smoothing kernels of conduction
THINNEST = wp.constant(1.0e-3)  # spacings, of a layer of solid or liquid in a particle: nothing is divided by zero


def for_conducting(
    make: Callable[[wp.Function, bool], Callable[..., None]], form: str, module: str, sharp: bool
) -> dict[str, wp.Kernel]:
    """Kernels by smoothing kernel, of which ``make`` defines one; ``sharp``: whether particles have fronts in them."""
    return for_each_smoothing_kernel(
        lambda shape: make(shape, sharp), form, CONDUCTING, module, "_sharp" if sharp else ""
    )


@wp.struct
class ThermalTable:
    """Per material: enthalpy curve, melting range and conductivities; per pair of materials: the film between them.

    ``enthalpy`` [J/kg] and ``temperature`` [K] (materials, nodes), both rising; ``solidus``, ``liquidus`` [K], one for
    a pure substance, and ``enthalpy_solid``, ``enthalpy_liquid`` [J/kg] there, ``conductivity_solid``,
    ``conductivity_liquid`` [W/(m K)] (materials,); ``film`` (materials, materials) [W/(m^2 K)], which times the
    distance of a pair is a conductivity in series with it; infinite where there is no film. ``support`` [m] and
    ``scale``, the normalisation, of the smoothing kernel.
    """

    enthalpy: wp.array2d[float]
    temperature: wp.array2d[float]
    solidus: wp.array[float]
    liquidus: wp.array[float]
    enthalpy_solid: wp.array[float]
    enthalpy_liquid: wp.array[float]
    conductivity_solid: wp.array[float]
    conductivity_liquid: wp.array[float]
    film: wp.array2d[float]
    support: float
    scale: float


@wp.func
def pair_conductivity(table: ThermalTable, a: int, b: int, k_a: float, k_b: float, r_squared: float) -> float:
    """Conductivity [W/(m K)] between particles of the materials a and b: harmonic mean, with the film in series."""
    k = 2.0 * k_a * k_b / (k_a + k_b + 1.0e-30)
    film = table.film[a, b]
    if film < wp.inf:
        through_film = film * wp.sqrt(r_squared)
        k = k * through_film / (k + through_film + 1.0e-30)
    return k


@wp.func
def towards(table: ThermalTable, material: int, conductivity: float, solid_fraction: float, difference: float) -> float:
    """Conductivity [W/(m K)] of a particle towards one that is colder by ``difference`` [K], which may be negative.

    A particle that freezes at one temperature has a front in it. On its colder side, half a spacing, heat passes as
    much solid as is in it, f of a spacing, so it conducts 1 / 2f of what solid does; on its warmer side 1 / 2(1 - f) of
    what liquid does.
    """
    f = solid_fraction
    if f > 0.0 and f < 1.0 and table.solidus[material] == table.liquidus[material]:
        if difference > 0.0:
            return table.conductivity_solid[material] / (2.0 * f + THINNEST)
        return table.conductivity_liquid[material] / (2.0 * (1.0 - f) + THINNEST)
    return conductivity


def _sum_heat(slope: wp.Function, sharp: bool) -> Callable[..., None]:
    def sum_heat(
        first: int,
        table: ThermalTable,
        neighbours: NeighbourList,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        temperature: wp.array[float],
        conductivity: wp.array[float],
        solid_fraction: wp.array[float],
        thermal_volume: wp.array[float],
        material: wp.array[int],
        heat_rate: wp.array[float],
    ):
        """Write the heat that flows into each particle, ``heat_rate`` (n,) [W] (per metre of depth in 2D).

        Vijaykumar (2012), equation (3.2), with the harmonic mean of the conductivities [W/(m K)]; antisymmetric in each
        pair, so that no heat is lost. ``thermal_volume`` (n,) is the mass over the material's density.
        """
        i = wp.tid() + first
        x_i = position[i]
        T_i = temperature[i]
        k_i = conductivity[i]
        total = float(0.0)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if role[j] != Role.RESERVOIR:
                d = difference(neighbours, x_i, position[j])
                r_squared = wp.dot(d, d)
                k_a, k_b = k_i, float(conductivity[j])
                if wp.static(sharp):
                    colder = T_i - temperature[j]
                    k_a = towards(table, material[i], k_i, solid_fraction[i], colder)
                    k_b = towards(table, material[j], k_b, solid_fraction[j], -colder)
                k_pair = pair_conductivity(table, material[i], material[j], k_a, k_b, r_squared)
                total += k_pair * thermal_volume[j] * (T_i - temperature[j]) * slope(r_squared, table.support)
        heat_rate[i] = 2.0 * table.scale * thermal_volume[i] * total  # Vijaykumar (3.2), times the mass

    return sum_heat


SUM_HEAT = {sharp: for_conducting(_sum_heat, "slope", __name__, sharp) for sharp in (False, True)}


@wp.func
def temperature_of(table: ThermalTable, material: int, enthalpy: float) -> float:
    segment = int(0)
    last = table.enthalpy.shape[1] - 2
    while segment < last and enthalpy > table.enthalpy[material, segment + 1]:
        segment += 1
    low = table.enthalpy[material, segment]
    T_low = table.temperature[material, segment]
    slope = (table.temperature[material, segment + 1] - T_low) / (table.enthalpy[material, segment + 1] - low)
    return T_low + slope * (enthalpy - low)


@wp.kernel
def add_heat(
    first: int,
    interval: float,
    role: wp.array[int],
    heat_rate: wp.array[float],
    mass: wp.array[float],
    held: wp.array[int],
    enthalpy: wp.array[float],
    enthalpy_carry: wp.array[float],
    heat_held: wp.array[wp.float64],
):
    """Add the heat of ``interval`` [s] to the enthalpy (n,) [J/kg], compensated.

    Where ``held`` is not zero the temperature stays and the heat goes to ``heat_held`` (n,) [J] (float64) instead.
    """
    i = wp.tid() + first
    if role[i] != Role.RESERVOIR:
        if held[i] != 0:
            heat_held[i] += wp.float64(heat_rate[i] * interval)
        else:
            h, carry = compensated_sum(enthalpy[i], heat_rate[i] * interval / mass[i], enthalpy_carry[i])
            enthalpy[i] = h
            enthalpy_carry[i] = carry


@wp.kernel
def update_temperature(
    first: int,
    table: ThermalTable,
    material: wp.array[int],
    enthalpy: wp.array[float],
    temperature: wp.array[float],
    solid_fraction: wp.array[float],
    conductivity: wp.array[float],
):
    """Write temperature [K], solid fraction and conductivity [W/(m K)] (n,) from the enthalpy [J/kg].

    Temperature is piecewise linear in enthalpy (Vijaykumar 2012, figure 3.1); the solid fraction falls linearly with
    the temperature from solidus to liquidus, and with the enthalpy at the melting point of a pure substance.
    """
    i = wp.tid() + first
    m = material[i]
    T = temperature_of(table, m, enthalpy[i])
    solid = float(0.0)
    if table.solidus[m] < table.liquidus[m]:
        solid = wp.clamp((table.liquidus[m] - T) / (table.liquidus[m] - table.solidus[m]), 0.0, 1.0)
    else:
        latent_heat = table.enthalpy_liquid[m] - table.enthalpy_solid[m]
        solid = wp.clamp((table.enthalpy_liquid[m] - enthalpy[i]) / latent_heat, 0.0, 1.0)
    temperature[i] = T
    solid_fraction[i] = solid
    conductivity[i] = solid * table.conductivity_solid[m] + (1.0 - solid) * table.conductivity_liquid[m]
