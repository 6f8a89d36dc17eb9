"""Kernels that exist once for each smoothing kernel, so that no loop over neighbours asks which one it is."""

from collections.abc import Callable, Iterable

import warp as wp

from warpsph.kernels.basics import smoothing


def for_each_smoothing_kernel(
    make: Callable[[wp.Function], Callable[..., None]],
    form: str,
    names: Iterable[str],
    module: str,
    variant: str = "",
) -> dict[str, wp.Kernel]:
    """Kernels by name of the smoothing kernel.

    Args:
        make: defines the function for one shape of a smoothing kernel, called with ``(r_squared, H)``.
        form: which shape, "value" or "slope".
        names: some of :data:`warpsph.kernels.basics.smoothing.SMOOTHING_KERNELS`.
        module: name of the module of the kernels.
        variant: tells kernels of the same function apart.
    """
    kernels = {}
    for name in names:
        function = make(getattr(smoothing, f"{name}_{form}"))
        kernels[name] = wp.Kernel(function, key=f"{function.__name__}_{name}{variant}", module=wp.get_module(module))
    return kernels
