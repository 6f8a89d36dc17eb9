"""Moving per-particle data to the places that the sort has given the particles."""

import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.kernel
def _gather(first: int, order: wp.array[int], source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    for word in range(source.shape[1]):
        target[i, word] = source[order[i], word]


@wp.kernel
def _gather_one_word(first: int, order: wp.array[int], source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    target[i, 0] = source[order[i], 0]


@wp.kernel
def _gather_three_words(first: int, order: wp.array[int], source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    j = order[i]
    target[i, 0] = source[j, 0]
    target[i, 1] = source[j, 1]
    target[i, 2] = source[j, 2]


@wp.kernel
def _copy(first: int, source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    for word in range(target.shape[1]):
        target[i, word] = source[i, word]


@wp.kernel
def _copy_one_word(first: int, source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    target[i, 0] = source[i, 0]


@wp.kernel
def _copy_three_words(first: int, source: wp.array2d[int], target: wp.array2d[int]):
    i = wp.tid() + first
    target[i, 0] = source[i, 0]
    target[i, 1] = source[i, 1]
    target[i, 2] = source[i, 2]


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


def reorder(launch, order, arrays, spares) -> None:
    """Permute every array (n, words) in place: row i becomes the former row ``order[i]``.

    ``spares`` are as many arrays of the same shapes to work in.
    """
    kernels = {1: _gather_one_word, 3: _gather_three_words}
    with launch.section():
        for array, spare in zip(arrays, spares, strict=True):
            launch(kernels.get(array.shape[1], _gather), order.shape[0], [order, array, spare])
    with launch.section():
        for array, spare in zip(arrays, spares, strict=True):
            copy(launch, spare, array)


def invert(launch, order, place) -> None:
    """``place[j]`` becomes the new index of the particle that stood at j."""
    launch(_invert, order.shape[0], [order, place])


def copy(launch, source, target) -> None:
    """Copy an array (n, words)."""
    kernels = {1: _copy_one_word, 3: _copy_three_words}
    launch(kernels.get(source.shape[1], _copy), source.shape[0], [source, target])
