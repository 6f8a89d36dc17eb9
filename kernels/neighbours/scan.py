"""Running sums, in parts of fixed length: no atomics, no memory of their own, so that they can be recorded."""

import warp as wp

wp.set_module_options({"enable_backward": False})

PARTS = 256


@wp.kernel
def sum_parts(first: int, values: wp.array[int], parts: wp.array[int]):
    """Write the sum of each of ``PARTS`` pieces of ``values`` (n,)."""
    part = wp.tid() + first
    length = (values.shape[0] + wp.static(PARTS) - 1) / wp.static(PARTS)
    total = int(0)
    for i in range(part * length, wp.min((part + 1) * length, values.shape[0])):
        total += values[i]
    parts[part] = total


@wp.kernel
def sum_before_parts(first: int, parts: wp.array[int]):
    """Replace each sum by the sum of all parts before it; one thread."""
    total = first
    for part in range(wp.static(PARTS)):
        own = parts[part]
        parts[part] = total
        total += own


@wp.kernel
def sum_within_parts(first: int, parts: wp.array[int], values: wp.array[int]):
    """Replace each value by the sum of all values up to it and itself."""
    part = wp.tid() + first
    length = (values.shape[0] + wp.static(PARTS) - 1) / wp.static(PARTS)
    total = parts[part]
    for i in range(part * length, wp.min((part + 1) * length, values.shape[0])):
        total += values[i]
        values[i] = total
