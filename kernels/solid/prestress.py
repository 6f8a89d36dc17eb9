"""What the fluid is to solids: the pressure under which melt freezes, and the density that bonded neighbours give."""

import warp as wp

from warpsph.kernels.basics.smoothing import poly6_value, spiky_slope
from warpsph.kernels.flow.corrected.scheme import FlowConstants, slope_of
from warpsph.kernels.flow.fluid import FluidConstants
from warpsph.kernels.neighbours.pairs import NeighbourList, difference
from warpsph.kernels.solid.bonds import UNCHANGED, BondList, partner_of, place_of

wp.set_module_options({"enable_backward": False})


@wp.kernel
def keep_pressure(
    first: int,
    fluid: FluidConstants,
    bonds: BondList,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    froze: wp.array[int],
    pressure: wp.array[float],
    volume: wp.array[float],
):
    """Let the bonds of what just ``froze`` begin with the force of the pair in the fluid, Vijaykumar (2012), (2.3)."""
    i = wp.tid() + first
    for b in range(bonds.count[i]):
        place = place_of(bonds, i, b)
        j = partner_of(bonds, place)
        if froze[i] != 0 or froze[j] != 0:
            d = difference(neighbours, position[i], position[j])
            slope = spiky_slope(wp.dot(d, d), fluid.support) * fluid.pressure_scale
            bonds.whole[place] = d * (-(pressure[i] + pressure[j]) * (volume[i] * volume[j]) * slope)


@wp.kernel
def keep_flow_pressure(
    first: int,
    flow: FlowConstants,
    bonds: BondList,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    froze: wp.array[int],
    pressure: wp.array[float],
):
    """Let the bonds of what just ``froze`` begin with the force of a pair of fluid and solid."""
    i = wp.tid() + first
    for b in range(bonds.count[i]):
        place = i * bonds.capacity + b
        j = bonds.partner[place]
        if froze[i] != 0 or froze[j] != 0:
            d = difference(neighbours, position[i], position[j])
            bonds.whole[place] = d * (-(pressure[i] + pressure[j]) * flow.volume * slope_of(flow, wp.dot(d, d)))


@wp.kernel
def keep_density(
    first: int,
    fluid: FluidConstants,
    bonds: BondList,
    rebonded: wp.array[int],
    fluid_mass: wp.array[float],
    bonded_density: wp.array[float],
):
    """Write what bonded neighbours give to the density of a particle, ``bonded_density`` (n,) [kg/m^3], where bonds
    have come or gone: what they gave when the bond was made (Vijaykumar 2012, equation 2.1)."""
    i = wp.tid() + first
    if rebonded[i] != UNCHANGED:
        total = float(0.0)
        for b in range(bonds.count[i]):
            place = place_of(bonds, i, b)
            X = bonds.separation[place]
            total += fluid_mass[partner_of(bonds, place)] * poly6_value(wp.dot(X, X), fluid.support)
        bonded_density[i] = fluid.density_scale * total
