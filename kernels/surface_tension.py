"""Surface tension as the derivative of an energy: sigma times the area of the surface, read off the colour field.

The colour field is 1 inside the fluid and falls to 0 across its surface. Its steepness, summed over the particles, is
an area times a constant of the lattice chi, so the energy of the surface is

    S = sigma / chi * sum_k V_k sqrt(|g_k|^2 + epsilon^2),    g_k = sum_j V_j grad W(x_k - x_j),

over all liquid particles k, with the volumes V = m / rho_0, which do not change. The force on a particle is minus the
derivative of S by its place,

    F_i = -sigma / chi * V_i sum_j V_j Hess W(x_i - x_j) (t_i - t_j),    t_k = g_k / sqrt(|g_k|^2 + epsilon^2),

equal and opposite in each pair of liquid particles.
"""

import warp as wp

from warpsph.kernels.labels import Phase, Role
from warpsph.kernels.pairs import NeighbourList, entry_of, index_of
from warpsph.kernels.smoothing import poly6_slope

wp.set_module_options({"enable_backward": False})


@wp.struct
class Surface:
    """Constants of the surface.

    ``support`` H [m]; ``scale`` normalisation of the poly6 kernel over rho_0, which makes volumes of masses;
    ``strength`` sigma / (chi rho_0) [m^3/s^2]; ``threshold`` epsilon [1/m], the steepness of the colour field well
    above which there is a surface.
    """

    support: float
    scale: float
    strength: float
    threshold: float


@wp.func
def poly6_hessian_times(d: wp.vec3, t: wp.vec3, H: float):
    """Hess W t of the poly6 kernel at the separation d [m], without its normalisation [m^4]."""
    b = wp.max(H * H - wp.dot(d, d), 0.0)
    return d * (24.0 * b * wp.dot(d, t)) - t * (6.0 * b * b)


@wp.kernel
def _find_surface_normal(
    first: int,
    surface: Surface,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    fluid_mass: wp.array[float],
    role: wp.array[int],
    phase: wp.array[int],
    normal: wp.array[wp.vec3],
):
    i = wp.tid() + first
    t = wp.vec3()
    if role[i] == Role.FREE and phase[i] != Phase.SOLID:
        x_i = position[i]
        gradient = wp.vec3()
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = x_i - position[j]
            gradient += d * (fluid_mass[j] * poly6_slope(wp.dot(d, d), surface.support))
        g = gradient * surface.scale
        t = g / wp.sqrt(wp.dot(g, g) + surface.threshold * surface.threshold)
    normal[i] = t


@wp.kernel
def _add_surface_tension(
    first: int,
    surface: Surface,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    fluid_mass: wp.array[float],
    role: wp.array[int],
    phase: wp.array[int],
    normal: wp.array[wp.vec3],
    acceleration: wp.array[wp.vec3],
):
    i = wp.tid() + first
    if role[i] == Role.FREE and phase[i] != Phase.SOLID:
        x_i = position[i]
        t_i = normal[i]
        total = wp.vec3()
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            total += fluid_mass[j] * poly6_hessian_times(x_i - position[j], t_i - normal[j], surface.support)
        acceleration[i] -= total * (surface.strength * surface.scale)


def find_surface_normal(launch, surface, neighbours, position, fluid_mass, role, phase, normal) -> None:
    """Write t (n,): into the liquid and of length 1 at its surface, near 0 inside, 0 for all that is not liquid.

    All neighbours with a ``fluid_mass`` (n,) [kg] count for the colour field, so that a surface is where there is
    nothing beyond: not at a wall, and not where melt touches its shell.
    """
    launch(
        _find_surface_normal,
        position.shape[0],
        [surface, neighbours, position, fluid_mass, role, phase, normal],
    )


def add_surface_tension(launch, surface, neighbours, position, fluid_mass, role, phase, normal, acceleration) -> None:
    """Add the acceleration (n,) [m/s^2] of free liquid particles by surface tension; ``normal`` as found above."""
    launch(
        _add_surface_tension,
        position.shape[0],
        [surface, neighbours, position, fluid_mass, role, phase, normal, acceleration],
    )
