"""Attraction and repulsion of pairs by powers of their distance, in double precision."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.neighbours.pairs import NeighbourList, difference_of_doubles, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.struct
class PairConstants:
    """``attraction`` G and ``repulsion`` H of two masses of 1 kg [N m^exponent / kg^2], the exponents, and the cutoff.

    Beyond ``cutoff_squared`` [m^2] there is no force.
    """

    attraction: wp.float64
    repulsion: wp.float64
    attraction_exponent: int
    repulsion_exponent: int
    cutoff_squared: wp.float64


@wp.func
def power(x: wp.float64, n: int) -> wp.float64:
    """x^n of a whole n >= 0, by multiplication alone: the same on every device."""
    result = wp.float64(1.0)
    for _ in range(n):
        result *= x
    return result


@wp.func
def pull(pair: PairConstants, d: wp.vec3d) -> wp.vec3d:
    """Force [N] of a particle of 1 kg on another one at ``d`` [m] from it; away from it where it repels."""
    squared = wp.dot(d, d)
    if squared > pair.cutoff_squared:
        return wp.vec3d()
    inverse = wp.float64(1.0) / wp.sqrt(squared)
    attracts = power(inverse, pair.attraction_exponent)
    repels = attracts * power(inverse, pair.repulsion_exponent - pair.attraction_exponent)
    return d * (inverse * (pair.repulsion * repels - pair.attraction * attracts))  # Greenspan (2.5), (2.6)


@wp.kernel
def add_pair_forces(
    first: int,
    pair: PairConstants,
    neighbours: NeighbourList,
    precise_position: wp.array[wp.vec3d],
    role: wp.array[int],
    mass: wp.array[float],
    precise_acceleration: wp.array[wp.vec3d],
):
    """Add what all others within the cutoff do to ``precise_acceleration`` (n,) [m/s^2] of free particles."""
    i = wp.tid() + first
    if role[i] == Role.FREE:
        x_i = precise_position[i]
        total = wp.vec3d()
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            d = difference_of_doubles(neighbours, x_i, precise_position[j])
            total += wp.float64(mass[j]) * pull(pair, d)  # Greenspan (2.7), over m_i
        precise_acceleration[i] += total
