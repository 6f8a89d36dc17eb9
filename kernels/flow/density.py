"""Density by summation, and the pressure and the volume that follow."""

import warp as wp

from warpsph.kernels.basics.roles import is_fluid
from warpsph.kernels.basics.smoothing import poly6_value
from warpsph.kernels.flow.fluid import FluidConstants, pressure_of
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.kernel
def sum_density(
    first: int,
    fluid: FluidConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    fluid_mass: wp.array[float],
    bonded_density: wp.array[float],
    role: wp.array[int],
    density: wp.array[float],
    pressure: wp.array[float],
    volume: wp.array[float],
):
    """Write density [kg/m^3], pressure [Pa] and volume (m^3, or m^2 in 2D) of every fluid particle, each (n,).

    Vijaykumar (2012), equations (2.1) and (1.5). ``fluid_mass`` [kg] is the mass with which a particle counts here:
    walls count like the fluid that they hold back (section 6.5), spray does not count. Bonded neighbours count as they
    did when the bond was made, by ``bonded_density`` (n,) [kg/m^3]: they do not press on each other, so neither may
    their distance change the pressure with which they press on others, or that pressure does work out of nothing.
    """
    i = wp.tid() + first
    if is_fluid(role[i]):
        x_i = position[i]
        total = fluid_mass[i] * poly6_value(0.0, fluid.support)
        for k in range(neighbours.count[i]):
            entry = entry_of(neighbours, i, k)
            if entry >= 0:
                d = difference(neighbours, x_i, position[index_of(entry)])
                total += fluid_mass[index_of(entry)] * poly6_value(wp.dot(d, d), fluid.support)
        rho = fluid.density_scale * total + bonded_density[i]  # Vijaykumar (2.1)
        density[i] = rho
        pressure[i] = pressure_of(fluid, rho)
        volume[i] = fluid_mass[i] / rho
