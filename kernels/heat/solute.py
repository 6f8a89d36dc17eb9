"""Diffusion of a solute between particles of liquid."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import cubic_spline_slope
from warpsph.kernels.heat.mirrors import image_slopes, mirrors_of
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def sum_solute(
    first: int,
    solute_walls: HeatWalls,
    solute_diffusivity: wp.array[float],
    solute_support: float,
    solute_scale: float,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    role: wp.array[int],
    material: wp.array[int],
    thermal_volume: wp.array[float],
    liquid_fraction: wp.array[float],
    solute: wp.array[float],
    solute_rate: wp.array[float],
):
    """Write the solute that flows into each particle, ``solute_rate`` (n,) [kg/s] (per metre of depth in 2D).

    Monaghan et al. (2005), equation (2.14), times the mass; antisymmetric in each pair, so that no solute is lost.
    Where the liquid fills a part of its place only, D is multiplied by that part and the density is that of the place,
    as they say under (4.3). ``solute_diffusivity`` (materials,) [kg/(m s)]; walls let nothing pass.
    """
    i = wp.tid() + first
    x_i = position[i]
    C_i = solute[i]
    D_i = liquid_fraction[i] * solute_diffusivity[material[i]]
    mirrors = mirrors_of(solute_walls, solute_support, x_i)
    total = float(0.0)
    for k in range(neighbours.count[i]):
        j = index_of(entry_of(neighbours, i, k))
        D_j = liquid_fraction[j] * solute_diffusivity[material[j]]
        if role[j] != Role.RESERVOIR and D_j > 0.0:
            d = difference(neighbours, x_i, position[j])
            slope = cubic_spline_slope(wp.dot(d, d), solute_support)
            slope += image_slopes(neighbours, solute_walls, mirrors, solute_support, x_i, position[j])
            total += 2.0 * D_i * D_j / (D_i + D_j) * thermal_volume[j] * (C_i - solute[j]) * slope
    solute_rate[i] = 2.0 * solute_scale * thermal_volume[i] * total  # Monaghan et al. (2.14), times the mass


@wp.kernel
def add_solute(
    first: int,
    interval: float,
    role: wp.array[int],
    solute_rate: wp.array[float],
    solute_mass: wp.array[wp.float64],
):
    """Add what has flowed in ``interval`` [s] to the mass of the solute (n,) [kg] (float64)."""
    i = wp.tid() + first
    if role[i] != Role.RESERVOIR:
        solute_mass[i] += wp.float64(solute_rate[i]) * wp.float64(interval)


@wp.kernel
def find_solute(
    first: int,
    solute_mass: wp.array[wp.float64],
    liquid_mass: wp.array[wp.float64],
    solute: wp.array[float],
):
    """Write the mass fraction of the solute in the liquid (n,), ``solute``; 0 where there is no liquid."""
    i = wp.tid() + first
    solute[i] = 0.0
    if liquid_mass[i] > wp.float64(0.0):
        solute[i] = float(solute_mass[i] / liquid_mass[i])
