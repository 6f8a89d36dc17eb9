"""Ice that an alloy forms as it cools along its liquidus, and its way to the ice of the neighbourhood."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import cubic_spline_value
from warpsph.kernels.heat.alloy import AlloyTable
from warpsph.kernels.heat.mirrors import image_values, mirrors_of
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})

TOLERANCE = wp.constant(
    wp.float64(1.0e-10)
)  # of the mass of ice; 1e-3 in section 4.1, too rough a curve for implicit steps
MOST_SWEEPS = wp.constant(30)
MOST_ICE = wp.constant(wp.float64(0.999999))  # of the liquid of a place in one step: some stays, to be reported


@wp.func
def segment_of(alloy: AlloyTable, C: wp.float64) -> int:
    """Which segment of the liquidus holds a concentration; the last one goes on beyond its end."""
    s = int(0)
    while s < alloy.melting.shape[0] - 2 and alloy.concentration[s + 1] < C:
        s += 1
    return s


@wp.func
def slope_of(alloy: AlloyTable, s: int) -> wp.float64:
    """Gamma [K] of a segment, by how much the liquidus falls over a unit of concentration."""
    return (alloy.melting[s] - alloy.melting[s + 1]) / (alloy.concentration[s + 1] - alloy.concentration[s])


@wp.func
def liquidus(alloy: AlloyTable, C: wp.float64) -> wp.float64:
    """Temperature [K] below which liquid of the concentration C freezes."""
    s = segment_of(alloy, C)
    return alloy.melting[s] - slope_of(alloy, s) * (C - alloy.concentration[s])


@wp.func
def chord_slope(alloy: AlloyTable, C: wp.float64, end: wp.float64) -> wp.float64:
    """Gamma [K] from one concentration to a higher one: of the segment that holds both, or else of the chord."""
    s, last = segment_of(alloy, C), alloy.melting.shape[0] - 2
    slope = slope_of(alloy, s)
    if s == last or alloy.concentration[s + 1] >= end:
        return slope
    fallen, start = wp.float64(0.0), wp.float64(C)
    while s < last and alloy.concentration[s + 1] < end:
        fallen += slope * (alloy.concentration[s + 1] - start)
        start = alloy.concentration[s + 1]
        s += 1
        slope = slope_of(alloy, s)
    return (fallen + slope * (end - start)) / (end - C)


@wp.func
def cooling(q: wp.float64, GC: wp.float64, L: wp.float64, c_l: wp.float64, c_i: wp.float64) -> wp.float64:
    """How far [K] liquid on a straight liquidus cools that loses the heat ``q`` [J/kg], ``GC`` being Gamma times C.

    The positive root of c_i x^2 + (L + GC c_l - q) x - q GC = 0, which Monaghan et al. (2005), equations (4.4) and
    (4.9), make of it.
    """
    b = L + GC * c_l - q
    root = wp.sqrt(b * b + wp.float64(4.0) * c_i * q * GC)
    if b < wp.float64(0.0):  # the other form of the root: a sum here, a small difference below
        return (root - b) / (wp.float64(2.0) * c_i)
    return wp.float64(2.0) * q * GC / (b + root)


@wp.func
def ice_formed(alloy: AlloyTable, C: wp.float64, q: wp.float64) -> wp.float64:
    """Share of the liquid that turns to ice when it loses ``q`` [J/kg] from the liquidus on.

    On a bent liquidus the slope is that of the chord, found anew until the ice changes by less than ``TOLERANCE``.
    """
    G = chord_slope(alloy, C, C)
    ice, before = wp.float64(0.0), wp.float64(-1.0)
    for _sweep in range(MOST_SWEEPS):
        if wp.abs(ice - before) > TOLERANCE * wp.float64(0.5) * (ice + before):
            before = ice
            x = cooling(q, G * C, alloy.latent_heat, alloy.capacity_liquid, alloy.capacity_ice)
            ice = wp.min(x / (G * C + x), MOST_ICE)  # Monaghan et al. (4.9)
            rise = C * ice / (wp.float64(1.0) - ice)  # Monaghan et al. (4.6)
            G = chord_slope(alloy, C, C + rise)  # Monaghan et al. (4.7)
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
    has_both = solute_mass[i] > wp.float64(0.0) and solute_mass[i] < m
    if role[i] == Role.RESERVOIR or not has_both:
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
            d = difference(neighbours, x_i, position[j])
            W = cubic_spline_value(wp.dot(d, d), alloy.support)
            W += image_values(neighbours, walls, mirrors, alloy.support, x_i, position[j])
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
            d = difference(neighbours, x_i, position[j])
            W = cubic_spline_value(wp.dot(d, d), alloy.support)
            W += image_values(neighbours, walls, mirrors, alloy.support, x_i, position[j])
            ice += new_ice[j] * wp.float64(W)  # Monaghan et al. (4.12)
            heat += new_heat[j] * wp.float64(W)  # Monaghan et al. (4.15)
    ice_mass[i] += ice
    ice_heat[i] += heat
