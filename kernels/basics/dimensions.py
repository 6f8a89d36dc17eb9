"""Kernels that exist once for each dimension, so that sums over pairs in the plane carry no zeros along.

Arrays hold three components in both. A loop over neighbours narrows what it reads to those that its dimension has, sums
by these, and widens what it writes.
"""

from collections.abc import Callable
from typing import NamedTuple

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.func
def narrow_to_plane(v: wp.vec3) -> wp.vec2:
    return wp.vec2(v[0], v[1])


@wp.func
def widen_from_plane(v: wp.vec2) -> wp.vec3:
    return wp.vec3(v[0], v[1], 0.0)


@wp.func
def widen_matrix_from_plane(m: wp.mat22) -> wp.mat33:
    return wp.mat33(m[0, 0], m[0, 1], 0.0, m[1, 0], m[1, 1], 0.0, 0.0, 0.0, 0.0)


@wp.func
def times_in_plane(m: wp.mat33, v: wp.vec2) -> wp.vec2:
    return wp.vec2(m[0, 0] * v[0] + m[0, 1] * v[1], m[1, 0] * v[0] + m[1, 1] * v[1])


@wp.func
def same_vector(v: wp.vec3) -> wp.vec3:
    return v


@wp.func
def same_matrix(m: wp.mat33) -> wp.mat33:
    return m


@wp.func
def times_in_space(m: wp.mat33, v: wp.vec3) -> wp.vec3:
    return m * v


class Space(NamedTuple):
    """What a kernel for one dimension computes with.

    ``vector`` and ``matrix`` are its types; ``narrow`` makes a vector of three components one of its own, ``widen`` and
    ``widen_matrix`` lead back, with zeros across the plane; ``times`` is the product of a 3 by 3 matrix, as arrays hold
    it, and a vector: in the plane the processor is slower by half with matrices of 2 by 2 that were read from arrays.
    """

    vector: type
    matrix: type
    narrow: wp.Function
    widen: wp.Function
    widen_matrix: wp.Function
    times: wp.Function


SPACES = {
    2: Space(wp.vec2, wp.mat22, narrow_to_plane, widen_from_plane, widen_matrix_from_plane, times_in_plane),
    3: Space(wp.vec3, wp.mat33, same_vector, same_vector, same_matrix, times_in_space),
}


def for_each_dimension(make: Callable[[Space], Callable[..., None]], module: str) -> dict[int, wp.Kernel]:
    """Kernels by dimension: ``make`` defines the function for one space; ``module`` is the name of its module."""
    kernels = {}
    for dimension, space in SPACES.items():
        function = make(space)
        kernels[dimension] = wp.Kernel(function, key=f"{function.__name__}_{dimension}d", module=wp.get_module(module))
    return kernels
