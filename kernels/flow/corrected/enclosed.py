"""The mean compression of a fluid that fills a closed box, which nothing in the box can change."""

import warp as wp

from warpsph.kernels.basics.roles import is_fluid

wp.set_module_options({"enable_backward": False})

PARTS = 128  # partial sums; their order of summation does not depend on the number of threads


@wp.kernel
def sum_compression(
    first: int, role: wp.array[int], compression: wp.array[float], compression_parts: wp.array[wp.float64]
):
    """Sum the compression of the fluid in ``PARTS`` partial sums ``compression_parts`` (PARTS,)."""
    part = wp.tid() + first
    n = role.shape[0]
    length = (n + wp.static(PARTS) - 1) / wp.static(PARTS)
    total = wp.float64(0.0)
    for i in range(part * length, wp.min((part + 1) * length, n)):
        if is_fluid(role[i]):
            total += wp.float64(compression[i])
    compression_parts[part] = total


@wp.kernel
def find_excess(
    first: int,
    fluid_count: int,
    mean_at_start: wp.float64,
    compression_parts: wp.array[wp.float64],
    excess: wp.array[float],
):
    """Write by how much the mean compression is above that of the start, ``excess`` (1,); one thread."""
    total = wp.float64(0.0)
    for part in range(wp.static(PARTS)):
        total += compression_parts[part]
    excess[0] = float(total / wp.float64(fluid_count) - mean_at_start)


@wp.kernel
def take_excess(
    first: int,
    bulk_modulus: float,
    role: wp.array[int],
    excess: wp.array[float],
    compression: wp.array[float],
    pressure: wp.array[float],
):
    """Take the ``excess`` (1,) from the ``compression`` (n,) of the fluid, and from its pressure (n,) [Pa]."""
    i = wp.tid() + first
    if is_fluid(role[i]):
        compression[i] -= excess[0]
        pressure[i] -= bulk_modulus * excess[0]
