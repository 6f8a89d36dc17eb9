"""Implicit steps of a binary alloy: rows of its liquid and its ice, and the temperature of liquid that freezes."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import cubic_spline_slope
from warpsph.kernels.heat.alloy import NO_ICE, AlloyTable, conductivities, volumes_behind, wall_ice
from warpsph.kernels.heat.freezing import chord_slope, ice_formed, liquidus
from warpsph.kernels.heat.implicit import STILL, ImplicitStep
from warpsph.kernels.heat.mirrors import image_distance, mirrors_of
from warpsph.kernels.heat.rows import HeatRows
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def begin_alloy(first: int, solution: ImplicitStep, liquid_heat: wp.array[wp.float64], ice_heat: wp.array[wp.float64]):
    """Begin with the heat [J] of liquid and ice."""
    i = wp.tid() + first
    n = liquid_heat.shape[0]
    solution.heat[i] = liquid_heat[i]
    solution.heat[n + i] = ice_heat[i]


@wp.kernel
def find_alloy_iterate(
    first: int,
    alloy: AlloyTable,
    solution: ImplicitStep,
    role: wp.array[int],
    solute_mass: wp.array[wp.float64],
    liquid_mass: wp.array[wp.float64],
    ice_mass: wp.array[wp.float64],
):
    """Write temperature and capacity of the solution from its heat.

    Liquid below its liquidus has the temperature that it will have when its ice has formed: Monaghan et al. (2005),
    (4.4) and (4.9), of which the derivative is taken along a straight liquidus. Ice without mass has no say.
    """
    i = wp.tid() + first
    n = liquid_mass.shape[0]
    m = liquid_mass[i]
    c_l, c_i, L = alloy.capacity_liquid, alloy.capacity_ice, alloy.latent_heat
    h = solution.heat[i] / m
    T, share = h / c_l, wp.float64(1.0) / c_l
    C = solute_mass[i] / m
    T_L = liquidus(alloy, C) - alloy.reference
    q = c_l * T_L - h
    if q > wp.float64(0.0) and wp.float64(0.0) < C:
        ice = ice_formed(alloy, C, q)
        x = (q - ice * L) / (ice * c_i + (wp.float64(1.0) - ice) * c_l)
        GC = C * chord_slope(alloy, C, C)
        if ice > wp.float64(0.0):
            GC = x * (wp.float64(1.0) - ice) / ice
        T = T_L - x
        share = (x + GC) / (wp.float64(2.0) * c_i * x + L + GC * c_l - q)
    solution.temperature[i] = alloy.reference + T
    solution.capacity[i] = m / share
    solution.temperature[n + i] = alloy.reference + T
    solution.capacity[n + i] = STILL
    m_i = ice_mass[i]
    if m_i > NO_ICE * m:
        solution.temperature[n + i] = alloy.reference + solution.heat[n + i] / (m_i * c_i)
        solution.capacity[n + i] = m_i * c_i
    if role[i] == Role.RESERVOIR:
        solution.capacity[i] = STILL
        solution.capacity[n + i] = STILL


@wp.kernel
def find_alloy_rows(
    first: int,
    alloy: AlloyTable,
    walls: HeatWalls,
    neighbours: NeighbourList,
    rows: HeatRows,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    thermal_volume: wp.array[float],
    bulk_solute: wp.array[float],
    solid_fraction: wp.array[float],
    liquid_volume: wp.array[float],
    ice_volume: wp.array[float],
):
    """Write the rows of what :data:`SUM_ALLOY_HEAT` sums, liquid first, then ice."""
    i = wp.tid() + first
    n = neighbours.count.shape[0]
    x_i = position[i]
    volume_i = wp.vec2(liquid_volume[i], ice_volume[i])
    mirrors = mirrors_of(walls, alloy.support, x_i)
    diagonal, source = wp.vec2d(wp.float64(0.0), wp.float64(0.0)), wp.vec2d(wp.float64(0.0), wp.float64(0.0))
    factor = -2.0 * alloy.slope_scale
    for k in range(neighbours.count[i] + 1):
        j = int(i)  # last of all itself: its liquid and its ice, and its own images
        if k < neighbours.count[i]:
            j = index_of(entry_of(neighbours, i, k))
        nothing = wp.float64(0.0)
        beside = wp.mat22d(nothing, nothing, nothing, nothing)
        whole = wp.mat22d(nothing, nothing, nothing, nothing)
        if role[i] != Role.RESERVOIR and role[j] != Role.RESERVOIR:
            d = difference(neighbours, x_i, position[j])
            volume_j = wp.vec2(liquid_volume[j], ice_volume[j])
            kappa = conductivities(alloy, solid_fraction[i], solid_fraction[j])
            slope = cubic_spline_slope(wp.dot(d, d), alloy.support)
            for f in range(2):
                for g in range(2):
                    if k < neighbours.count[i] or f != g:
                        weight = wp.float64(factor * ((volume_i[f] * volume_j[g]) * (kappa[2 * f + g] * slope)))
                        beside[f, g] += weight
                        whole[f, g] += weight
            planes = int(mirrors)
            while planes != 0:
                r_squared = image_distance(neighbours, walls, planes, x_i, position[j])
                if r_squared < alloy.support * alloy.support:
                    keeper = int(-1)  # a wall of given temperature
                    sign, rest = wp.float64(1.0), wp.float64(0.0)  # the image has sign T_j + rest
                    for p in range(walls.offset.shape[0]):
                        if (planes >> p) & 1 != 0 and walls.conductance[p] == wp.inf:
                            keeper = p
                            sign, rest = -sign, wp.float64(2.0) * wp.float64(walls.outside[p]) - rest
                    V = wp.vec2(volume_j[0], volume_j[1])  # a copy: a plain name would change that of the particle
                    if keeper >= 0:
                        ice = wall_ice(alloy, keeper, bulk_solute[j])
                        kappa = conductivities(alloy, solid_fraction[i], ice)
                        V = volumes_behind(alloy, ice, thermal_volume[j])
                    else:
                        kappa = conductivities(alloy, solid_fraction[i], solid_fraction[j])
                    slope = cubic_spline_slope(r_squared, alloy.support)
                    for f in range(2):
                        for g in range(2):
                            weight = wp.float64(factor * ((volume_i[f] * V[g]) * (kappa[2 * f + g] * slope)))
                            beside[f, g] += sign * weight
                            source[f] += rest * weight
                            whole[f, g] += weight
                planes = (planes - 1) & mirrors
        at = i * neighbours.row_stride + k * neighbours.entry_stride
        for f in range(2):
            for g in range(2):
                if k < neighbours.count[i]:
                    rounded = float(beside[f, g])
                    rows.beside[(2 * f + g) * neighbours.entry.shape[0] + at] = rounded
                    diagonal[f] += wp.float64(rounded) + (whole[f, g] - beside[f, g])
                elif f == g:
                    diagonal[f] += whole[f, g] - beside[f, g]
                else:
                    rows.here[f * n + i] = beside[f, g]
                    diagonal[f] += whole[f, g]
    for f in range(2):
        rows.diagonal[f * n + i] = diagonal[f]
        rows.source[f * n + i] = source[f]


@wp.kernel
def end_alloy(
    first: int,
    solution: ImplicitStep,
    liquid_heat: wp.array[wp.float64],
    ice_heat: wp.array[wp.float64],
):
    """Write the heat [J] of liquid and ice."""
    i = wp.tid() + first
    n = liquid_heat.shape[0]
    liquid_heat[i] = solution.heat[i]
    ice_heat[i] = solution.heat[n + i]
