"""Density by summation, pressure by Tait's equation of state, and the volume that follows."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import poly6_value
from warpsph.kernels.neighbours.pairs import NeighbourList, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.struct
class Fluid:
    """Constants of the weakly compressible fluid.

    ``support`` H [m]; ``density_scale`` normalisation of the density's smoothing kernel; ``reference_density`` rho_0
    [kg/m^3]; ``stiffness`` c_s^2 rho_0 / gamma [Pa]; ``lowest_pressure`` [Pa], 0 where tension is forbidden;
    ``pressure_scale`` and ``viscosity_scale`` normalisations of the pressure and viscosity sums; ``gravity`` [m/s^2].
    """

    support: float
    density_scale: float
    reference_density: float
    stiffness: float
    lowest_pressure: float
    pressure_scale: float
    viscosity_scale: float
    gravity: wp.vec3


@wp.func
def tait_pressure(fluid: Fluid, density: float) -> float:
    ratio = density / fluid.reference_density
    ratio_3 = ratio * ratio * ratio
    return fluid.stiffness * (ratio_3 * ratio_3 * ratio - 1.0)  # Vijaykumar (1.5), gamma = 7


@wp.func
def is_fluid(role: int) -> bool:
    return role == Role.FREE or role == Role.INFLOW or role == Role.OUTFLOW


@wp.kernel
def _sum_density(
    first: int,
    fluid: Fluid,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    fluid_mass: wp.array[float],
    role: wp.array[int],
    density: wp.array[float],
    pressure: wp.array[float],
    volume: wp.array[float],
):
    i = wp.tid() + first
    if is_fluid(role[i]):
        x_i = position[i]
        total = fluid_mass[i] * poly6_value(0.0, fluid.support)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = x_i - position[j]
            total += fluid_mass[j] * poly6_value(wp.dot(d, d), fluid.support)
        rho = fluid.density_scale * total  # Vijaykumar (2.1)
        density[i] = rho
        pressure[i] = wp.max(tait_pressure(fluid, rho), fluid.lowest_pressure)
        volume[i] = fluid_mass[i] / rho


def sum_density(launch, fluid, neighbours, position, fluid_mass, role, density, pressure, volume) -> None:
    """Write density [kg/m^3], pressure [Pa] and volume (m^3, or m^2 in 2D) of every fluid particle, each (n,).

    Vijaykumar (2012), equations (2.1) and (1.5). ``fluid_mass`` [kg] is the mass with which a particle counts here:
    walls count like the fluid that they hold back (section 6.5), spray does not count.
    """
    launch(
        _sum_density,
        position.shape[0],
        [fluid, neighbours, position, fluid_mass, role, density, pressure, volume],
    )
