"""Ice that an alloy forms as it cools along its liquidus, and its way to the ice of the neighbourhood."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import cubic_spline_value
from warpsph.kernels.heat.alloy import AlloyTable
from warpsph.kernels.heat.mirrors import image_values, mirrors_of
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.kernels.neighbours.pairs import NeighbourList, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})

TOLERANCE = wp.constant(wp.float64(1.0e-3))  # of the mass of ice, section 4.1
MOST_SWEEPS = wp.constant(30)


@wp.func
def segment_of(alloy: AlloyTable, C: wp.float64) -> int:
    """Which segment of the liquidus holds a concentration; the last one goes on beyond its end."""
    s = int(0)
    while s < alloy.melting.shape[0] - 2 and alloy.concentration[s + 1] < C:
        s += 1
    return s


@wp.func
def liquidus_slope(alloy: AlloyTable, C: wp.float64) -> wp.float64:
    """Gamma [K], by how much the liquidus falls there over a unit of concentration."""
    s = segment_of(alloy, C)
    return (alloy.melting[s] - alloy.melting[s + 1]) / (alloy.concentration[s + 1] - alloy.concentration[s])


@wp.func
def liquidus(alloy: AlloyTable, C: wp.float64) -> wp.float64:
    """Temperature [K] below which liquid of the concentration C freezes."""
    s = segment_of(alloy, C)
    return alloy.melting[s] - liquidus_slope(alloy, C) * (C - alloy.concentration[s])


@wp.func
def cooling(q: wp.float64, GC: wp.float64, L: wp.float64, c_l: wp.float64, c_i: wp.float64) -> wp.float64:
    """How far [K] liquid on a straight liquidus cools that loses the heat ``q`` [J/kg], ``GC`` being Gamma times C.

    The positive root of c_i x^2 + (L + GC c_l - q) x - q GC = 0, which Monaghan et al. (2005), equations (4.4) and
    (4.9), make of it.
    """
    b = L + GC * c_l - q
    return wp.float64(2.0) * q * GC / (b + wp.sqrt(b * b + wp.float64(4.0) * c_i * q * GC))


@wp.func
def ice_formed(alloy: AlloyTable, C: wp.float64, q: wp.float64) -> wp.float64:
    """Share of the liquid that turns to ice when it loses ``q`` [J/kg] from the liquidus on.

    On a bent liquidus the slope is that of the chord, found anew until the ice changes by less than ``TOLERANCE``.
    """
    G = liquidus_slope(alloy, C)
    ice, before = wp.float64(0.0), wp.float64(-1.0)
    for _sweep in range(MOST_SWEEPS):
        if wp.abs(ice - before) > TOLERANCE * wp.float64(0.5) * (ice + before):
            before = ice
            x = cooling(q, G * C, alloy.latent_heat, alloy.capacity_liquid, alloy.capacity_ice)
            ice = x / (G * C + x)  # Monaghan et al. (4.9)
            rise = C * ice / (wp.float64(1.0) - ice)  # Monaghan et al. (4.6)
            if rise > wp.float64(0.0):
                G = (liquidus(alloy, C) - liquidus(alloy, C + rise)) / rise  # Monaghan et al. (4.7)
    return ice


@wp.kernel
def freeze(
    first: int,
    alloy: AlloyTable,
    walls: HeatWalls,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    solute_mass: wp.array[wp.float64],
    liquid_mass: wp.array[wp.float64],
    liquid_heat: wp.array[wp.float64],
    heat_freed: wp.array[wp.float64],
    new_ice: wp.array[wp.float64],
    new_heat: wp.array[wp.float64],
):
    """Let liquid below its liquidus form ice until it is on it again.

    Write what there is of new ice, ``new_ice`` [kg], and its heat, ``new_heat`` [J], (n,), both over the sum of the
    smoothing kernel over all ice particles, the zeta of Monaghan et al. (2005), equation (4.14). ``heat_freed`` [J]
    counts by how much freezing has raised the heat of liquid and ice together. All in float64.
    """
    i = wp.tid() + first
    new_ice[i] = wp.float64(0.0)
    new_heat[i] = wp.float64(0.0)
    m = liquid_mass[i]
    if role[i] == Role.RESERVOIR or not solute_mass[i] > wp.float64(0.0):
        return
    c_l, c_i, L = alloy.capacity_liquid, alloy.capacity_ice, alloy.latent_heat
    C = solute_mass[i] / m
    T_L = liquidus(alloy, C) - alloy.reference
    q = c_l * T_L - liquid_heat[i] / m  # only what is lost from the liquidus on
    if q <= wp.float64(0.0):
        return
    ice = m * ice_formed(alloy, C, q)
    x = (q * m - ice * L) / (ice * c_i + (m - ice) * c_l)  # Monaghan et al. (4.4)
    liquid_mass[i] = m - ice
    liquid_heat[i] = (m - ice) * c_l * (T_L - x)
    heat_freed[i] += ice * (L - (c_l - c_i) * T_L)
    x_i = position[i]
    mirrors = mirrors_of(walls, alloy.support, x_i)
    total = wp.float64(0.0)
    for n in range(neighbours.count[i] + 1):
        j = int(i)
        if n < neighbours.count[i]:
            j = index_of(entry_of(neighbours, i, n))
        if role[j] != Role.RESERVOIR:
            d = x_i - position[j]
            W = cubic_spline_value(wp.dot(d, d), alloy.support)
            W += image_values(walls, mirrors, alloy.support, x_i, position[j])
            total += wp.float64(W)
    new_ice[i] = ice / total  # Monaghan et al. (4.14)
    new_heat[i] = new_ice[i] * c_i * (T_L - x)  # the parcel is ice: (4.15) with its heat capacity


@wp.kernel
def gather_ice(
    first: int,
    alloy: AlloyTable,
    walls: HeatWalls,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    new_ice: wp.array[wp.float64],
    new_heat: wp.array[wp.float64],
    ice_mass: wp.array[wp.float64],
    ice_heat: wp.array[wp.float64],
):
    """Add to the ice of each particle, mass (n,) [kg] and heat (n,) [J], its share of what has frozen around it."""
    i = wp.tid() + first
    if role[i] == Role.RESERVOIR:
        return
    x_i = position[i]
    mirrors = mirrors_of(walls, alloy.support, x_i)
    ice, heat = wp.float64(0.0), wp.float64(0.0)
    for n in range(neighbours.count[i] + 1):
        j = int(i)
        if n < neighbours.count[i]:
            j = index_of(entry_of(neighbours, i, n))
        if new_ice[j] > wp.float64(0.0):
            d = x_i - position[j]
            W = cubic_spline_value(wp.dot(d, d), alloy.support)
            W += image_values(walls, mirrors, alloy.support, x_i, position[j])
            ice += new_ice[j] * wp.float64(W)  # Monaghan et al. (4.12)
            heat += new_heat[j] * wp.float64(W)  # Monaghan et al. (4.15)
    ice_mass[i] += ice
    ice_heat[i] += heat
