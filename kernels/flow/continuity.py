"""Density by the equation of continuity: it follows the flow, so that missing neighbours do not lower it."""

import warp as wp

from warpsph.kernels.basics.compensation import compensated_sum
from warpsph.kernels.basics.roles import is_fluid
from warpsph.kernels.basics.smoothing import spiky_slope
from warpsph.kernels.flow.fluid import FluidConstants, pressure_of
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def advance_density(
    first: int,
    fluid: FluidConstants,
    dt: float,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    fluid_mass: wp.array[float],
    role: wp.array[int],
    density: wp.array[float],
    density_carry: wp.array[float],
    pressure: wp.array[float],
    volume: wp.array[float],
):
    """Advance the density (n,) [kg/m^3] by ``dt`` [s], compensated; write pressure [Pa] and volume [m^3 or m^2], (n,).

    d rho_i / dt = rho_i sum_j V_j (u_i - u_j) . grad W with the smoothing kernel of the pressure force, so that the
    pressure works on just those volumes that it changes (Monaghan 1994, section 2). Bonded pairs do not press on each
    other, so their distance does not count.
    """
    i = wp.tid() + first
    if is_fluid(role[i]):
        x_i = position[i]
        u_i = velocity[i]
        total = float(0.0)
        for k in range(neighbours.count[i]):
            entry = entry_of(neighbours, i, k)
            if entry >= 0:
                j = index_of(entry)
                d = difference(neighbours, x_i, position[j])
                total += fluid_mass[j] * wp.dot(u_i - velocity[j], d) * spiky_slope(wp.dot(d, d), fluid.support)
        # volumes of neighbours at rho_0: their true density is being written at this moment
        rate = density[i] * fluid.pressure_scale * total / fluid.reference_density
        rho, carry = compensated_sum(density[i], rate * dt, density_carry[i])
        density[i] = rho
        density_carry[i] = carry
        pressure[i] = pressure_of(fluid, rho)
        volume[i] = fluid_mass[i] / rho
