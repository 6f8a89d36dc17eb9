"""Classic delta-SPH: continuity, pressure and viscosity in one sweep over the neighbours, and its leapfrog steps."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.roles import is_fluid
from warpsph.kernels.flow.corrected.scheme import WALL, FlowConstants, slope_of
from warpsph.kernels.neighbours.pairs import NeighbourList, difference, entry_of, index_of

wp.set_module_options({"enable_backward": False})


@wp.func
def compression_pressure(compression: float, bulk_modulus: float, exponent: float) -> float:
    """Pressure [Pa] of a compression: of Tait's equation, or for an exponent of 1 a line."""
    pressure = bulk_modulus * compression  # not by the power: it would lose the digits that 1 + s has not
    if exponent != 1.0:
        pressure = bulk_modulus / exponent * (wp.pow(1.0 + compression, exponent) - 1.0)
    return pressure


@wp.kernel
def predict(
    first: int,
    dt: float,
    flow: FlowConstants,
    exponent: float,
    background_pressure: float,
    mass: wp.array[float],
    role: wp.array[int],
    acceleration: wp.array[wp.vec3],
    compression_rate: wp.array[float],
    last_acceleration: wp.array[wp.vec3],
    last_rate: wp.array[float],
    velocity: wp.array[wp.vec3],
    compression: wp.array[float],
    density: wp.array[float],
    pressure: wp.array[float],
):
    """Carry ``velocity`` (n,) [m/s], in the middle of a step, and ``compression`` (n,), at its begin, on to its end.

    With the rates of the begin, which are kept as ``last_acceleration`` and ``last_rate``. Write the density [kg/m^3]
    and the pressure [Pa] that follow.
    """
    i = wp.tid() + first
    if is_fluid(role[i]):
        if role[i] == Role.FREE:
            velocity[i] += acceleration[i] * (0.5 * dt)
        last_acceleration[i] = acceleration[i]
        last_rate[i] = compression_rate[i]
        s = compression[i] + compression_rate[i] * dt
        compression[i] = s
        density[i] = mass[i] / flow.volume * (1.0 + s)
        pressure[i] = background_pressure + compression_pressure(s, flow.bulk_modulus, exponent)


@wp.kernel
def sum_delta_rates(
    first: int,
    flow: FlowConstants,
    gravity: wp.vec3,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    velocity: wp.array[wp.vec3],
    ghost_velocity: wp.array[wp.vec3],
    pressure: wp.array[float],
    compression: wp.array[float],
    viscosity: wp.array[float],
    mass: wp.array[float],
    role: wp.array[int],
    part: wp.array[int],
    acceleration: wp.array[wp.vec3],
    compression_rate: wp.array[float],
):
    """Add the acceleration (n,) [m/s^2] of fluid by pressure and viscosity; write its ``compression_rate`` (n,) [1/s].

    Continuity with density diffusion (Molteni & Colagrossi 2009) of what is not hydrostatic (Fourtakas et al. 2019),
    pressure as p_i + p_j, artificial viscosity (Monaghan & Gingold 1983) without a switch between fluid particles and
    laminar viscosity after Morris, Fox & Zhu (1997), each antisymmetric in the pair.
    """
    i = wp.tid() + first
    if is_fluid(role[i]):
        x_i = position[i]
        u_i = velocity[i]
        p_i = pressure[i]
        s_i = compression[i]
        mu_i = viscosity[i]
        c_squared = flow.bulk_modulus * flow.volume / mass[i]
        artificial = flow.artificial * wp.sqrt(c_squared) * mass[i] / flow.volume
        force = wp.vec3()
        opening = float(0.0)
        smoothing = float(0.0)
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = difference(neighbours, x_i, position[j])
            r_squared = wp.dot(d, d)
            if r_squared < flow.support * flow.support:
                s_j = compression[j]
                F = slope_of(flow, r_squared) / (1.0 + s_j)
                u_ij = u_i - velocity[j]
                mu_j = viscosity[j]
                mu = 2.0 * mu_i * mu_j / (mu_i + mu_j + 1.0e-30)
                along = -p_i - pressure[j]
                if part[j] == WALL:
                    u_ij = u_i - ghost_velocity[j]
                else:
                    smoothing -= (s_j - s_i + wp.dot(gravity, d) / c_squared) * F
                    along += artificial * wp.dot(u_ij, d) / wp.max(r_squared, 1.0e-6 * flow.spacing * flow.spacing)
                force += (d * along + u_ij * (2.0 * mu)) * F
                opening += wp.dot(u_ij, d) * F
        compression_rate[i] = (1.0 + s_i) * opening + flow.diffusion * wp.sqrt(c_squared) * smoothing
        if role[i] == Role.FREE:
            acceleration[i] += force * (flow.volume / (mass[i] * (1.0 + s_i)))


@wp.kernel
def correct(
    first: int,
    dt: float,
    role: wp.array[int],
    compression_rate: wp.array[float],
    last_acceleration: wp.array[wp.vec3],
    last_rate: wp.array[float],
    velocity: wp.array[wp.vec3],
    compression: wp.array[float],
):
    """Put the mean of the rates of begin and end in the place of those of the begin; half the kick is done already."""
    i = wp.tid() + first
    if is_fluid(role[i]):
        compression[i] += (compression_rate[i] - last_rate[i]) * (0.5 * dt)
        if role[i] == Role.FREE:
            velocity[i] -= last_acceleration[i] * (0.5 * dt)
