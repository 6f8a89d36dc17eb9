"""Kernels that exist once for each type that a field can have.

Generic kernels would be simpler, but a graph recorded on a CPU (Warp 1.19) replays one of their overloads for all.
"""

from collections.abc import Callable
from typing import Any

import warp as wp

FIELD_TYPES = {
    "int": int,
    "float": float,
    "double": wp.float64,
    "vec3": wp.vec3,
    "vec3_double": wp.vec3d,
    "mat33": wp.mat33,
}


def for_each_type(make: Callable[[type], Callable[..., None]], module: str) -> dict[Any, wp.Kernel]:
    """Kernels by type of field: ``make`` defines the function for one type; ``module`` is the name of its module."""
    kernels = {}
    for name, dtype in FIELD_TYPES.items():
        function = make(dtype)
        kernels[dtype] = wp.Kernel(function, key=f"{function.__name__}_{name}", module=wp.get_module(module))
    return kernels
