"""Giving particles that come in from the reservoir the values that they start with."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.typed import for_each_type

wp.set_module_options({"enable_backward": False})


def _start_anew(dtype: type) -> Callable[..., None]:
    def start_anew(first: int, entered: wp.array[int], start: wp.array[dtype], field: wp.array[dtype]):
        """Give a field (n,) its ``start`` (1,) where ``entered`` (n,) is not zero."""
        i = wp.tid() + first
        if entered[i] != 0:
            field[i] = start[0]

    return start_anew


START_ANEW = for_each_type(_start_anew, __name__)


@wp.kernel
def forget_entries(first: int, entered: wp.array[int]):
    """Set ``entered`` (n,) to zero."""
    entered[wp.tid() + first] = 0
