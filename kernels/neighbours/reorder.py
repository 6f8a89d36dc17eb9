"""Moving per-particle data to the places that the sort has given the particles."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.typed import for_each_type

wp.set_module_options({"enable_backward": False})


def _gather(dtype: type) -> Callable[..., None]:
    def gather(first: int, order: wp.array[int], source: wp.array[dtype], target: wp.array[dtype]):
        """Entry i of ``target`` (n,) becomes entry ``order[i]`` of ``source``."""
        i = wp.tid() + first
        target[i] = source[order[i]]

    return gather


def _copy(dtype: type) -> Callable[..., None]:
    def copy(first: int, source: wp.array[dtype], target: wp.array[dtype]):
        """Copy an array (n,)."""
        i = wp.tid() + first
        target[i] = source[i]

    return copy


GATHER = for_each_type(_gather, __name__)
COPY = for_each_type(_copy, __name__)


@wp.kernel
def invert(first: int, order: wp.array[int], place: wp.array[int]):
    """``place[j]`` becomes the new index of the particle that stood at j."""
    i = wp.tid() + first
    place[order[i]] = i
