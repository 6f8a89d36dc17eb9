"""Surface tension as published: a force density on each particle by the curvature of the colour field."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role
from warpsph.kernels.basics.smoothing import poly6_laplacian, poly6_slope
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.struct
class ColourFieldConstants:
    """Constants of the published form.

    ``support`` H [m]; ``scale`` normalisation of the poly6 kernel; ``dimension`` 2 or 3; ``tension`` sigma [N/m];
    ``threshold`` smallest gradient of the colour field that counts as a surface [1/m].
    """

    support: float
    scale: float
    dimension: int
    tension: float
    threshold: float


@wp.kernel
def add_colour_field_tension(
    first: int,
    colour_field: ColourFieldConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    density: wp.array[float],
    volume: wp.array[float],
    role: wp.array[int],
    phase: wp.array[int],
    acceleration: wp.array[wp.vec3],
):
    """Add the acceleration (n,) [m/s^2] of free liquid particles by surface tension.

    Vijaykumar (2012), equations (2.7)-(2.10), after Mueller et al. (2003). All neighbours with a ``volume`` (n,)
    [m^3, or m^2 in 2D] count for the colour field, so that a surface is where there is nothing beyond: not at a wall.
    It pulls on a flat surface too, and does not keep momentum (docs/errata.md).
    """
    i = wp.tid() + first
    if role[i] == Role.FREE and phase[i] != Phase.SOLID:
        x_i = position[i]
        gradient = wp.vec3()
        laplacian = volume[i] * poly6_laplacian(0.0, colour_field.support, colour_field.dimension)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = difference(neighbours, x_i, position[j])
            r_squared = wp.dot(d, d)
            gradient += d * (volume[j] * poly6_slope(r_squared, colour_field.support))  # Vijaykumar (2.8)
            laplacian += volume[j] * poly6_laplacian(r_squared, colour_field.support, colour_field.dimension)
        steepness = wp.length(gradient)
        if steepness * colour_field.scale > colour_field.threshold:
            # Vijaykumar (2.10), which holds the curvature (2.9)
            force = gradient * (-colour_field.tension * colour_field.scale * laplacian / steepness)
            acceleration[i] += force / density[i]
