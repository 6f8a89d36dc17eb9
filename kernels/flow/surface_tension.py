"""Surface tension as a force along the normal of the surface, by the curvature of its normals.

The colour field is 1 inside the liquid and falls to 0 across its surface. Its gradient points into the liquid; its
steepness, summed over the particles under a unit of surface, is a constant chi of the lattice, close to 1/2, however
the rows are turned. So sigma kappa / (chi rho_0) times the gradient is an acceleration that makes, on a unit of
surface, the force sigma kappa.
"""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role
from warpsph.kernels.basics.smoothing import poly6_slope, poly6_value
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})

SPRAY = wp.constant(0.3)  # colour below which a few particles fly by themselves and have no surface


@wp.struct
class SurfaceConstants:
    """Constants of the surface.

    ``support`` H [m]; ``scale`` normalisation of the poly6 kernel over rho_0, which makes volumes of masses;
    ``strength`` (d - 1) sigma / (chi rho_0) [m^3/s^2]; ``threshold`` steepness of the colour field above which there is
    a surface [1/m]; ``depth`` mean depth below the surface at which the force acts [m].
    """

    support: float
    scale: float
    strength: float
    threshold: float
    depth: float


@wp.kernel
def find_surface_normal(
    first: int,
    surface: SurfaceConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    fluid_mass: wp.array[float],
    role: wp.array[int],
    phase: wp.array[int],
    surface_normal: wp.array[wp.vec3],
):
    """Write the gradient (n,) [1/m] of the colour field less the threshold; 0 for all that is not liquid at a surface.

    All neighbours with a ``fluid_mass`` (n,) [kg] count for the colour field, so that a surface is where there is
    nothing beyond: not at a wall, and not where melt touches its shell.
    """
    i = wp.tid() + first
    n_i = wp.vec3()
    if role[i] == Role.FREE and phase[i] != Phase.SOLID:
        x_i = position[i]
        gradient = wp.vec3()
        colour = fluid_mass[i] * poly6_value(0.0, surface.support)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = difference(neighbours, x_i, position[j])
            r_squared = wp.dot(d, d)
            gradient += d * (fluid_mass[j] * poly6_slope(r_squared, surface.support))
            colour += fluid_mass[j] * poly6_value(r_squared, surface.support)
        steepness = wp.length(gradient) * surface.scale
        if steepness > surface.threshold and colour * surface.scale > SPRAY:
            n_i = gradient * (surface.scale * (1.0 - surface.threshold / steepness))
    surface_normal[i] = n_i


@wp.kernel
def add_surface_tension(
    first: int,
    surface: SurfaceConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    fluid_mass: wp.array[float],
    surface_normal: wp.array[wp.vec3],
    acceleration: wp.array[wp.vec3],
):
    """Add the acceleration (n,) [m/s^2] of liquid particles at a surface, with ``surface_normal`` as found above.

    The curvature is the turn of the unit normals t_j - t_i along the surface over the way along it, both weighted with
    the steepness of the neighbour: on a sphere whose normals are exact it is exact.
    """
    i = wp.tid() + first
    n_i = surface_normal[i]
    if wp.dot(n_i, n_i) > 0.0:
        x_i = position[i]
        t_i = wp.normalize(n_i)
        turn = float(0.0)
        spread = float(0.0)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            n_j = surface_normal[j]
            steepness = wp.length(n_j)
            if steepness > 0.0:
                d = difference(neighbours, x_i, position[j])
                t_j = n_j / steepness
                weight = -fluid_mass[j] * steepness * poly6_slope(wp.dot(d, d), surface.support)
                across = wp.dot(d, wp.normalize(t_i + t_j))
                turn += weight * wp.dot(t_j - t_i, d)
                spread += weight * (wp.dot(d, d) - across * across)
        if spread > 0.0:
            # a few particles by themselves have no curvature to speak of
            sharpest = 0.5 / surface.support
            inside = wp.clamp(turn / spread, -sharpest, sharpest)
            # normals at this depth converge on the same centre over a smaller radius
            acceleration[i] += n_i * (surface.strength * inside / (1.0 + inside * surface.depth))
