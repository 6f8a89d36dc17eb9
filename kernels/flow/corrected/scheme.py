"""The constants of the corrected flow, and small functions that several of its sweeps share."""

import warp as wp

from warpsph.kernels.basics.labels import Phase, Role
from warpsph.kernels.basics.roles import is_fluid
from warpsph.kernels.basics.smoothing import wendland_c2_slope

wp.set_module_options({"enable_backward": False})

# What a particle is to the flow
NOTHING = wp.constant(0)  # spray, rolls, what is in the reservoir
FLUID = wp.constant(1)
SOLID = wp.constant(2)  # what froze, and melt that inlet and outflow lead: walls that move
WALL = wp.constant(3)

# Where a particle is in the fluid, by the smallest eigenvalue of its moment matrix, which is 1 inside
INTERIOR = wp.constant(0)
NEAR = wp.constant(1)  # has a neighbour at the surface
SURFACE = wp.constant(2)
SURFACE_BELOW = wp.constant(0.75)
SPRAY_BELOW = wp.constant(0.4)
SMALLEST_DETERMINANT = wp.constant(0.3)  # of a moment matrix that is inverted


@wp.struct
class FlowConstants:
    """Constants of the corrected flow.

    ``support`` H, ``spacing`` dx and ``beside``, how far aside a particle is at most of the nearest one in a layer of a
    wall [m]; ``volume`` of a particle [m^3, or m^2 in 2D]; ``scale`` volume times the
    normalisation of W, ``slope_scale`` the same of W', such that the moment matrix of the lattice is the identity;
    ``bulk_modulus`` rho_0 c^2 [Pa]; ``bulk_delay`` tau [s] by which pressure resists compression; ``diffusion``
    2 delta h and ``artificial`` alpha h [m], ``artificial_at_surface`` at and near a free surface; ``quadratic`` 2 h^2
    [m^2]; ``shifting`` 8 h [m]; ``highest_shift_speed`` [m/s]; ``inverse_nearest`` 1 / (V W(dx)); ``anisotropy`` k of
    the weight of viscosity; ``dimension``; ``free_surface`` 1 where pressure at walls does not fall below zero.
    """

    support: float
    spacing: float
    beside: float
    volume: float
    scale: float
    slope_scale: float
    bulk_modulus: float
    bulk_delay: float
    diffusion: float
    artificial: float
    artificial_at_surface: float
    quadratic: float
    shifting: float
    highest_shift_speed: float
    inverse_nearest: float
    anisotropy: float
    dimension: int
    free_surface: int


@wp.func
def slope_of(flow: FlowConstants, r_squared: float) -> float:
    """V W'(r) / r, so that V grad W = slope * x_ij; Wendland C2."""
    return flow.slope_scale * wendland_c2_slope(r_squared, flow.support)


@wp.func
def slope_and_weight(flow: FlowConstants, r_squared: float):
    """V W'(r) / r and V W(r), by one root."""
    r = wp.sqrt(r_squared)
    gap = flow.support - r
    cubed = gap * gap * gap
    return -20.0 * flow.slope_scale * cubed, flow.scale * cubed * gap * (flow.support + 4.0 * r)


@wp.func
def all_eigenvalues_above(matrix: wp.mat33, bound: float) -> bool:
    """Whether a symmetric matrix minus ``bound`` times the identity is positive definite (Sylvester's criterion)."""
    a = matrix - bound * wp.identity(n=3, dtype=float)
    return a[0, 0] > 0.0 and a[0, 0] * a[1, 1] > a[0, 1] * a[0, 1] and wp.determinant(a) > 0.0


@wp.func
def correction_of(moment: wp.mat33) -> wp.mat33:
    """The inverse of a moment matrix, the identity where too little surrounds the particle."""
    correction = wp.identity(n=3, dtype=float)
    if wp.determinant(moment) > SMALLEST_DETERMINANT:
        correction = wp.inverse(moment)
    return correction


@wp.func
def share_of_difference(mass: float, other: float) -> float:
    """By what a difference of pressure is multiplied, so that its gradient is that on the particle's own side.

    Between fluids of two densities the slope of the pressure at rest has a bend; half of the way, and of the
    difference, lies on each side (Hu & Adams 2007).
    """
    return 2.0 * mass / (mass + other)


@wp.kernel
def tell_parts(first: int, role: wp.array[int], phase: wp.array[int], fluid_mass: wp.array[float], part: wp.array[int]):
    """Write what each particle is to the flow; nothing where it has no ``fluid_mass`` (n,) [kg]."""
    i = wp.tid() + first
    what = NOTHING
    if fluid_mass[i] > 0.0:
        if role[i] == Role.WALL or role[i] == Role.DUMMY:
            what = WALL
        elif role[i] == Role.FREE and phase[i] != Phase.SOLID:
            what = FLUID
        elif is_fluid(role[i]):
            what = SOLID
    part[i] = what
