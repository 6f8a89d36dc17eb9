"""A source that drives particles away from itself, the more the nearer they are."""

import warp as wp

from warpsph.kernels.neighbours.pairs import NeighbourList, difference_of_doubles

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.func
def strength_at(time: wp.float64, until: wp.array[wp.float64], strength: wp.array[wp.float64]) -> wp.float64:
    """The strength that holds at a time [s]: entry k before ``until[k]``, and nothing after the last."""
    for k in range(until.shape[0]):
        if time < until[k]:
            return strength[k]
    return wp.float64(0.0)


@wp.func
def drive(d: wp.vec3d, reach: wp.float64) -> wp.vec3d:
    """Direction away from the source over the square of the distance [1/m^2] at ``d`` [m], zero from the reach on."""
    distance = wp.length(d)
    if distance >= reach or distance == wp.float64(0.0):
        return wp.vec3d()
    return d / (distance * distance * distance)


@wp.kernel
def drive_away(
    first: int,
    dt: wp.float64,
    time: wp.array[wp.float64],
    source: wp.vec3d,
    source_reach: wp.float64,
    until: wp.array[wp.float64],
    strength: wp.array[wp.float64],
    neighbours: NeighbourList,
    precise_position: wp.array[wp.vec3d],
    precise_velocity: wp.array[wp.vec3d],
):
    """Add to the velocity (n,) [m/s] what the source at ``source`` [m] gives in ``dt`` [s].

    ``until`` (k,) [s] and ``strength`` (k,) [m^3/s^2] are its schedule.
    """
    i = wp.tid() + first
    now = time[0] + wp.float64(0.5) * dt  # a change falls between two steps, however time is rounded
    S = strength_at(now, until, strength)
    d = difference_of_doubles(neighbours, precise_position[i], source)
    precise_velocity[i] += dt * S * drive(d, source_reach)  # Greenspan (4.1)
