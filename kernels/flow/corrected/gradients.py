"""First sweep of the corrected flow: moment matrix, gradients, and the rate of compression."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.dimensions import Space, for_each_dimension
from warpsph.kernels.flow.corrected.scheme import (
    FLUID,
    INTERIOR,
    NEAR,
    NOTHING,
    SPRAY_BELOW,
    SURFACE,
    SURFACE_BELOW,
    WALL,
    FlowConstants,
    all_eigenvalues_above,
    correction_of,
    share_of_difference,
    slope_of,
)
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


def _find_gradients(space: Space) -> Callable[..., None]:
    vector, matrix, narrow = space.vector, space.matrix, space.narrow
    widen, widen_matrix = space.widen, space.widen_matrix

    def find_gradients(
        first: int,
        flow: FlowConstants,
        neighbours: NeighbourList,
        position: wp.array[wp.vec3],
        velocity: wp.array[wp.vec3],
        ghost_velocity: wp.array[wp.vec3],
        compression: wp.array[float],
        compression_slope: wp.array[wp.vec3],
        mass: wp.array[float],
        part: wp.array[int],
        material: wp.array[int],
        is_near: wp.array[int],
        surface: wp.array[int],
        moment: wp.array[wp.mat33],
        velocity_gradient: wp.array[wp.mat33],
        divergence: wp.array[float],
        compression_rate: wp.array[float],
        next_slope: wp.array[wp.vec3],
    ):
        """Write what each fluid particle's surroundings say, each (n,): where it is in the fluid (``surface``), its
        ``moment`` matrix, ``velocity_gradient`` and its trace, ``divergence`` [1/s], ``compression_rate`` [1/s] and
        ``next_slope``, the gradient of the compression [1/m].

        Continuity with the diffusion of delta-SPH (Antuono et al. 2010), gradients corrected by the inverse of the
        moment matrix M = -sum V x_ij x_ij W'/r (Bonet & Lok 1999). ``compression`` (n,) is rho / rho_0 - 1, and
        ``compression_slope`` (n,) its gradient one step ago.
        """
        i = wp.tid() + first
        if part[i] == FLUID:
            x_i = position[i]
            u_i = narrow(velocity[i])
            s_i = compression[i]
            slope_i = narrow(compression_slope[i])
            sum_of_moments = matrix()
            grad_u = matrix()
            grad_s = vector()
            smoothing = float(0.0)
            for k in range(neighbours.count[i]):
                j = index_of(entry_of(neighbours, i, k))
                d = narrow(difference(neighbours, x_i, position[j]))
                r_squared = wp.dot(d, d)
                what = part[j]
                if r_squared < flow.support * flow.support and what != NOTHING:
                    F = slope_of(flow, r_squared)
                    V_grad_W = d * F
                    share = float(1.0)
                    u_j = narrow(velocity[j])
                    if what == WALL:
                        u_j = narrow(ghost_velocity[j])
                    if what != FLUID:
                        smoothing -= (compression[j] - s_i + wp.dot(slope_i, d)) * F
                    elif material[j] != material[i]:
                        share = share_of_difference(mass[i], mass[j])
                    else:
                        slopes = slope_i + narrow(compression_slope[j])
                        smoothing -= (compression[j] - s_i + 0.5 * wp.dot(slopes, d)) * F
                    sum_of_moments -= wp.outer(d, V_grad_W)
                    grad_u += wp.outer(u_j - u_i, V_grad_W)
                    grad_s += V_grad_W * (share * (compression[j] - s_i))
            M = widen_matrix(sum_of_moments)
            if flow.dimension == 2:
                M[2, 2] = 1.0
            place = INTERIOR
            if flow.free_surface != 0:
                if not all_eigenvalues_above(M, SURFACE_BELOW):
                    place = SURFACE
                elif is_near[i] != 0:
                    place = NEAR
            L = correction_of(M)
            corrected = widen_matrix(grad_u) * L
            corrected_div_u = wp.trace(corrected)
            div_u = corrected_div_u
            if place != INTERIOR:
                div_u = wp.trace(grad_u)
            sound_speed = wp.sqrt(flow.bulk_modulus * flow.volume / mass[i])
            surface[i] = place
            moment[i] = M
            velocity_gradient[i] = corrected
            divergence[i] = corrected_div_u
            compression_rate[i] = flow.diffusion * sound_speed * smoothing - div_u
            next_slope[i] = L * widen(grad_s)

    return find_gradients


FIND_GRADIENTS = for_each_dimension(_find_gradients, __name__)


@wp.kernel
def compress(
    first: int,
    dt: float,
    flow: FlowConstants,
    part: wp.array[int],
    mass: wp.array[float],
    surface: wp.array[int],
    moment: wp.array[wp.mat33],
    divergence: wp.array[float],
    compression_rate: wp.array[float],
    next_slope: wp.array[wp.vec3],
    compression: wp.array[float],
    compression_slope: wp.array[wp.vec3],
    density: wp.array[float],
    pressure: wp.array[float],
):
    """Advance the ``compression`` (n,) of fluid particles by ``dt`` [s]; write its slope, the density [kg/m^3] and the
    pressure [Pa], each (n,).

    The pressure leads the compression by ``bulk_delay``, which damps sound. What flies alone or lies at a free surface
    bears no tension.
    """
    i = wp.tid() + first
    if part[i] == FLUID:
        s = compression[i] + dt * compression_rate[i]
        if flow.free_surface != 0 and (surface[i] == SURFACE or not all_eigenvalues_above(moment[i], SPRAY_BELOW)):
            s = wp.max(s, 0.0)
        compression[i] = s
        pressure[i] = flow.bulk_modulus * (s - flow.bulk_delay * divergence[i])
        compression_slope[i] = next_slope[i]
        density[i] = mass[i] / flow.volume * (1.0 + s)
