"""Conduction in a binary alloy: liquid and ice at the same places, each with its mass and its temperature."""

from collections.abc import Callable
from typing import Any

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import cubic_spline_slope, cubic_spline_value
from warpsph.kernels.heat.mirrors import image_distance, image_values, mirrors_of
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})

NO_ICE = wp.constant(wp.float64(1.0e-9))  # of the mass of the liquid: less ice than that has no say


@wp.struct
class AlloyTable:
    """What is known of an alloy.

    ``concentration`` and ``melting`` [K], the nodes of the liquidus (float64), the one rising, the other falling;
    ``reference`` [K], from which heats count; ``latent_heat`` [J/kg]; ``capacity_liquid``, ``capacity_ice``
    [J/(kg K)]; ``conductivity_liquid``, ``conductivity_ice`` [W/(m K)]; ``density_liquid``, ``density_ice`` [kg/m^3];
    ``literal``, whether heat is conducted as printed; ``wall_concentration`` (walls,), that of liquid in equilibrium
    with ice at the temperature of a wall, 0 where there is none; ``support`` [m]; ``slope_scale`` and ``value_scale``,
    the normalisations of W'/r and W on the lattice.
    """

    concentration: wp.array[wp.float64]
    melting: wp.array[wp.float64]
    reference: wp.float64
    latent_heat: wp.float64
    capacity_liquid: wp.float64
    capacity_ice: wp.float64
    conductivity_liquid: float
    conductivity_ice: float
    density_liquid: float
    density_ice: float
    literal: int
    wall_concentration: wp.array[float]
    support: float
    slope_scale: float
    value_scale: float


@wp.func
def harmonic(a: float, b: float) -> float:
    return 2.0 * a * b / (a + b + 1.0e-30)


@wp.func
def conductivities(alloy: AlloyTable, ice_i: float, ice_j: float) -> wp.vec4:
    """Conductivities [W/(m K)] between liquid and liquid, liquid i and ice j, ice i and liquid j, ice and ice.

    As printed, the harmonic mean of theta times kappa, whoever the two are. Otherwise the intrinsic ones, and between
    the families, which lie beside each other, not one behind the other, their arithmetic mean: with volumes that add up
    to that of the place, the sum over all four is theta_ice kappa_ice + theta_liquid kappa_liquid.
    """
    k_l, k_i = alloy.conductivity_liquid, alloy.conductivity_ice
    if alloy.literal == 0:
        across = 0.5 * (k_l + k_i)
        return wp.vec4(k_l, across, across, k_i)
    a_l, a_i, b_l, b_i = (1.0 - ice_i) * k_l, ice_i * k_i, (1.0 - ice_j) * k_l, ice_j * k_i
    return wp.vec4(harmonic(a_l, b_l), harmonic(a_l, b_i), harmonic(a_i, b_l), harmonic(a_i, b_i))


@wp.func
def wall_ice(alloy: AlloyTable, p: int, bulk: float) -> float:
    """Volume fraction of ice in an alloy of the mean concentration ``bulk``, in equilibrium at wall p."""
    ice = 1.0 - bulk / wp.max(alloy.wall_concentration[p], 1.0e-30)  # from Monaghan et al. (4.5)
    return wp.clamp(ice * alloy.density_liquid / alloy.density_ice, 0.0, 1.0)


@wp.func
def volumes_behind(alloy: AlloyTable, ice: float, volume: float) -> wp.vec2:
    """Volumes [m^3] (m^2 in 2D) of liquid and ice of an image of ``volume`` with the fraction ``ice`` of it frozen."""
    if alloy.literal != 0:
        return wp.vec2(volume, wp.where(ice > 0.0, volume, 0.0))
    return wp.vec2(volume * (1.0 - ice), volume * ice)


@wp.func
def pair_heat(k: wp.vec4, slope: float, colder: wp.vec4, volume_j: wp.vec2) -> wp.vec2:
    """What liquid and ice of a particle lose to liquid and ice of another one, over twice their own volumes.

    ``colder`` [K]: by how much liquid j and ice j are colder than liquid i, then than ice i.
    """
    liquid = k[0] * volume_j[0] * colder[0] + k[1] * volume_j[1] * colder[1]
    ice = k[2] * volume_j[0] * colder[2] + k[3] * volume_j[1] * colder[3]
    return wp.vec2(liquid * slope, ice * slope)


@wp.func
def colder_by(T_i: Any, T_j: Any) -> wp.vec4:
    """Differences [K] of liquid and ice, whatever their precision; see :func:`pair_heat`."""
    return wp.vec4(float(T_i[0] - T_j[0]), float(T_i[0] - T_j[1]), float(T_i[1] - T_j[0]), float(T_i[1] - T_j[1]))


def _sum_alloy_heat(dtype: type) -> Callable[..., None]:
    two = wp.vec2 if dtype is float else wp.vec2d

    def sum_alloy_heat(
        first: int,
        alloy: AlloyTable,
        walls: HeatWalls,
        neighbours: NeighbourList,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        id: wp.array[int],
        thermal_volume: wp.array[float],
        bulk_solute: wp.array[float],
        solid_fraction: wp.array[float],
        temperature: wp.array[dtype],
        ice_temperature: wp.array[dtype],
        liquid_volume: wp.array[float],
        ice_volume: wp.array[float],
        liquid_rate: wp.array[float],
        ice_rate: wp.array[float],
    ):
        """Write the heat that flows into the liquid and into the ice of each particle (n,) [W] (over depth in 2D).

        Monaghan et al. (2005), equation (4.2), times the mass, over both families, those at the same place among them.
        Of the images behind walls, those behind a wall of given temperature hold the ice of an alloy that is in
        equilibrium there; what they exchange is what the wall takes, ``walls.rate``.
        """
        i = wp.tid() + first
        for p in range(walls.offset.shape[0]):
            walls.rate[p, id[i]] = 0.0
        x_i = position[i]
        T_i = two(temperature[i], ice_temperature[i])
        volume_i = 2.0 * alloy.slope_scale * wp.vec2(liquid_volume[i], ice_volume[i])
        mirrors = mirrors_of(walls, alloy.support, x_i)
        total = wp.vec2(0.0, 0.0)
        for n in range(neighbours.count[i] + 1):
            j = int(i)  # last of all itself: its liquid and its ice, and its own images
            if n < neighbours.count[i]:
                j = index_of(entry_of(neighbours, i, n))
            if role[j] != Role.RESERVOIR:
                d = difference(neighbours, x_i, position[j])
                T_j = two(temperature[j], ice_temperature[j])
                volume_j = wp.vec2(liquid_volume[j], ice_volume[j])
                k = conductivities(alloy, solid_fraction[i], solid_fraction[j])
                total += pair_heat(k, cubic_spline_slope(wp.dot(d, d), alloy.support), colder_by(T_i, T_j), volume_j)
                planes = int(mirrors)
                while planes != 0:
                    r_squared = image_distance(neighbours, walls, planes, x_i, position[j])
                    if r_squared < alloy.support * alloy.support:
                        keeper = int(-1)  # a wall of given temperature
                        T = two(T_j[0], T_j[1])  # copies: a plain name would change the particle's own
                        V = wp.vec2(volume_j[0], volume_j[1])
                        for p in range(walls.offset.shape[0]):
                            if (planes >> p) & 1 != 0 and walls.conductance[p] == wp.inf:
                                keeper = p
                                mirror = dtype(2.0 * walls.outside[p])
                                T = two(mirror - T[0], mirror - T[1])
                        if keeper >= 0:
                            ice = wall_ice(alloy, keeper, bulk_solute[j])
                            k = conductivities(alloy, solid_fraction[i], ice)
                            V = volumes_behind(alloy, ice, thermal_volume[j])
                        else:
                            k = conductivities(alloy, solid_fraction[i], solid_fraction[j])
                        part = pair_heat(k, cubic_spline_slope(r_squared, alloy.support), colder_by(T_i, T), V)
                        total += part
                        if keeper >= 0:
                            walls.rate[keeper, id[i]] -= wp.dot(volume_i, part)
                    planes = (planes - 1) & mirrors
        liquid_rate[i] = volume_i[0] * total[0]  # Monaghan et al. (4.2), times the mass
        ice_rate[i] = volume_i[1] * total[1]

    return sum_alloy_heat


SUM_ALLOY_HEAT = {
    dtype: wp.Kernel(_sum_alloy_heat(dtype), key=f"sum_alloy_heat_{name}", module=wp.get_module(__name__))
    for name, dtype in (("single", float), ("double", wp.float64))
}


@wp.kernel
def add_alloy_heat(
    first: int,
    interval: float,
    role: wp.array[int],
    liquid_rate: wp.array[float],
    ice_rate: wp.array[float],
    liquid_heat: wp.array[wp.float64],
    ice_heat: wp.array[wp.float64],
):
    """Add the heat of ``interval`` [s] to liquid and ice (n,) [J] (float64)."""
    i = wp.tid() + first
    if role[i] != Role.RESERVOIR:
        liquid_heat[i] += wp.float64(liquid_rate[i]) * wp.float64(interval)
        ice_heat[i] += wp.float64(ice_rate[i]) * wp.float64(interval)


@wp.kernel
def find_fractions(
    first: int,
    alloy: AlloyTable,
    walls: HeatWalls,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    liquid_mass: wp.array[wp.float64],
    ice_mass: wp.array[wp.float64],
    liquid_density: wp.array[float],
    ice_density: wp.array[float],
    solid_fraction: wp.array[float],
    liquid_fraction: wp.array[float],
):
    """Write densities [kg/m^3] and volume fractions (n,) of liquid and ice.

    Monaghan et al. (2005), section 4.3; walls mirror, where their sums would find too little.
    """
    i = wp.tid() + first
    x_i = position[i]
    mirrors = mirrors_of(walls, alloy.support, x_i)
    liquid, ice = float(0.0), float(0.0)
    for n in range(neighbours.count[i] + 1):
        j = int(i)
        if n < neighbours.count[i]:
            j = index_of(entry_of(neighbours, i, n))
        if role[j] != Role.RESERVOIR:
            d = difference(neighbours, x_i, position[j])
            W = cubic_spline_value(wp.dot(d, d), alloy.support)
            W += image_values(neighbours, walls, mirrors, alloy.support, x_i, position[j])
            liquid += float(liquid_mass[j]) * W
            ice += float(ice_mass[j]) * W
    liquid_density[i] = alloy.value_scale * liquid  # Monaghan et al. (4.11)
    ice_density[i] = alloy.value_scale * ice  # Monaghan et al. (4.18), with (4.21)
    theta = alloy.value_scale * ice / alloy.density_ice  # Monaghan et al. (4.22), (4.24)
    solid_fraction[i] = theta
    liquid_fraction[i] = wp.max(1.0 - theta, 0.0)  # Monaghan et al. (4.23)


@wp.kernel
def find_alloy_state(
    first: int,
    alloy: AlloyTable,
    thermal_volume: wp.array[float],
    solute_mass: wp.array[wp.float64],
    liquid_mass: wp.array[wp.float64],
    ice_mass: wp.array[wp.float64],
    liquid_heat: wp.array[wp.float64],
    ice_heat: wp.array[wp.float64],
    liquid_density: wp.array[float],
    ice_density: wp.array[float],
    temperature: wp.array[float],
    ice_temperature: wp.array[float],
    bulk_solute: wp.array[float],
    liquid_volume: wp.array[float],
    ice_volume: wp.array[float],
):
    """Write temperatures [K], volumes [m^3] (m^2 in 2D) of liquid and ice, and the mean concentration (n,).

    Ice that is nearly without mass has the temperature of the liquid and no volume. The volumes with which heat is
    conducted are as printed the masses over the smoothed densities; otherwise those of the true masses: the ice has
    its intrinsic density, and the liquid fills what is left of the place.
    """
    i = wp.tid() + first
    m_l, m_i = liquid_mass[i], ice_mass[i]
    T = float(alloy.reference + liquid_heat[i] / (m_l * alloy.capacity_liquid))
    temperature[i] = T
    bulk_solute[i] = float(solute_mass[i] / (m_l + m_i))
    ice_temperature[i] = T
    ice = float(0.0)
    if m_i > NO_ICE * m_l:
        ice_temperature[i] = float(alloy.reference + ice_heat[i] / (m_i * alloy.capacity_ice))
        ice = float(m_i) / alloy.density_ice
    ice_volume[i] = ice
    liquid_volume[i] = wp.max(thermal_volume[i] - ice, 0.0)
    if alloy.literal != 0:
        liquid_volume[i] = float(m_l) / liquid_density[i]
        if ice > 0.0:
            ice_volume[i] = float(m_i) / ice_density[i]
