"""Acceleration of the fluid: pressure and viscosity in one sweep over the neighbours."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import spiky_slope, viscosity_laplacian
from warpsph.kernels.flow.fluid import FluidConstants
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.kernel
def add_fluid_forces(
    first: int,
    fluid: FluidConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    density: wp.array[float],
    pressure: wp.array[float],
    volume: wp.array[float],
    viscosity: wp.array[float],
    fluid_mass: wp.array[float],
    mass: wp.array[float],
    role: wp.array[int],
    acceleration: wp.array[wp.vec3],
):
    """Add the acceleration (n,) [m/s^2] of every free particle by pressure and viscosity.

    Vijaykumar (2012), equations (2.3), (2.5), (2.6). Bonded pairs do not press on each other: their bond does; and
    viscosity damps their distance only, for all of it would brake the turning of a solid.
    ``viscosity`` (n,) [Pa s] enters a pair as the harmonic mean; a wall without viscosity lets the fluid slip.
    ``mass`` (n,) [kg] of a solid may differ from the ``fluid_mass`` (n,) by which it counts in the sums.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE:
        x_i = position[i]
        u_i = velocity[i]
        p_i = pressure[i]
        mu_i = viscosity[i]
        pressure_sum = wp.vec3()
        viscous_sum = wp.vec3()
        for k in range(neighbours.count[i]):
            entry = entry_of(neighbours, i, k)
            j = index_of(entry)
            d = difference(neighbours, x_i, position[j])
            r_squared = wp.dot(d, d)
            if r_squared < fluid.support * fluid.support:
                if entry >= 0:
                    # Vijaykumar (2.3) without its 1/2, which would halve the pressure gradient
                    pressure_sum += d * ((p_i + pressure[j]) * volume[j] * spiky_slope(r_squared, fluid.support))
                mu_j = viscosity[j]
                mu_ij = 2.0 * mu_i * mu_j / (mu_i + mu_j + 1.0e-20)
                u_ji = velocity[j] - u_i
                if entry < 0:
                    u_ji = d * (fluid.bond_damping * wp.dot(d, u_ji) / (r_squared + 1.0e-20))
                # Vijaykumar (2.5)
                laplacian = viscosity_laplacian(r_squared, fluid.support)
                viscous_sum += u_ji * (mu_ij * volume[j] * laplacian)
        force = viscous_sum * fluid.viscosity_scale - pressure_sum * fluid.pressure_scale
        # Vijaykumar (2.6), for a solid of another density by its own mass
        acceleration[i] = force / density[i] * (fluid_mass[i] / mass[i]) + acceleration[i]
