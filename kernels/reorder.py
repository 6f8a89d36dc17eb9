"""Moving per-particle data to the places that the sort has given the particles."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.kernel
def _gather(first: int, order: wp.array[int], source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    for word in range(source.shape[1]):
        target[i, word] = source[order[i], word]


@wp.kernel
def _copy(first: int, source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    for word in range(target.shape[1]):
        target[i, word] = source[i, word]


@wp.kernel
def _invert(first: int, order: wp.array[int], place: wp.array[int]):
    i = wp.tid() + first
    place[order[i]] = i


def words(array: wp.array) -> wp.array:
    """The memory of an array (n,) of any type as 32-bit words (n, words)."""
    return wp.array(
        ptr=array.ptr,
        dtype=int,
        shape=(array.shape[0], wp.types.type_size_in_bytes(array.dtype) // 4),
        device=array.device,
    )


def reorder(launch, order, arrays, scratch) -> None:
    """Permute every array (n, words) in place: row i becomes the former row ``order[i]``.

    ``scratch`` is a spare array (n, w) with at least as many words as the widest of them.
    """
    for array in arrays:
        launch(_gather, order.shape[0], [order, array, scratch])
        launch(_copy, order.shape[0], [scratch, array])


def invert(launch, order, place) -> None:
    """``place[j]`` becomes the new index of the particle that stood at j."""
    launch(_invert, order.shape[0], [order, place])


def copy(launch, source, target) -> None:
    """Copy an array (n, words)."""
    launch(_copy, source.shape[0], [source, target])
