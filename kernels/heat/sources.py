"""Point sources and sinks of heat, smoothed over the particles around them."""

from collections.abc import Callable

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.specialised import for_each_smoothing_kernel
from warpsph.kernels.heat.conduction import CONDUCTING
from warpsph.kernels.neighbours.pairs import NeighbourList, difference

wp.set_module_options({"enable_backward": False, "fast_math": False})

PARTS = 256  # pieces of the particles that are summed side by side: the sum hangs on no order of threads


def _weigh_parts(value: wp.Function) -> Callable[..., None]:
    def weigh_parts(
        first: int,
        support: float,
        source_position: wp.array[wp.vec3],
        neighbours: NeighbourList,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        thermal_volume: wp.array[float],
        source_parts: wp.array[float],
    ):
        """Write the sum of V W around each source over each piece of the particles (sources * PARTS,)."""
        me = wp.tid() + first
        x = source_position[me / wp.static(PARTS)]
        part = me % wp.static(PARTS)
        length = (position.shape[0] + wp.static(PARTS) - 1) / wp.static(PARTS)
        total = float(0.0)
        for i in range(part * length, wp.min((part + 1) * length, position.shape[0])):
            d = difference(neighbours, position[i], x)
            if role[i] != Role.RESERVOIR:
                total += thermal_volume[i] * value(wp.dot(d, d), support)
        source_parts[me] = total

    return weigh_parts


def _add_heat_of_sources(value: wp.Function) -> Callable[..., None]:
    def add_heat_of_sources(
        first: int,
        support: float,
        source_position: wp.array[wp.vec3],
        strength: wp.array[float],
        source_weight: wp.array[float],
        neighbours: NeighbourList,
        position: wp.array[wp.vec3],
        role: wp.array[int],
        thermal_volume: wp.array[float],
        heat_rate: wp.array[float],
    ):
        """Add to ``heat_rate`` (n,) [W] the share that each particle has in the ``strength`` (sources,) [W].

        Monaghan, Huppert & Worster (2005), equation (2.10) times the mass; the shares add up to one.
        """
        i = wp.tid() + first
        if role[i] != Role.RESERVOIR:
            for s in range(strength.shape[0]):
                d = difference(neighbours, position[i], source_position[s])
                W = value(wp.dot(d, d), support)
                if W > 0.0 and source_weight[s] > 0.0:
                    heat_rate[i] += strength[s] * thermal_volume[i] * W / source_weight[s]  # Monaghan (2.10)

    return add_heat_of_sources


WEIGH_PARTS = for_each_smoothing_kernel(_weigh_parts, "value", CONDUCTING, __name__)
ADD_HEAT_OF_SOURCES = for_each_smoothing_kernel(_add_heat_of_sources, "value", CONDUCTING, __name__)


@wp.kernel
def add_parts(first: int, source_parts: wp.array[float], source_weight: wp.array[float]):
    """Write 1 / zeta (sources,) without the normalisation of W, which cancels: Monaghan (2.11)."""
    s = wp.tid() + first
    total = float(0.0)
    for part in range(wp.static(PARTS)):
        total += source_parts[s * wp.static(PARTS) + part]
    source_weight[s] = total


@wp.kernel
def count_heat_of_sources(
    first: int,
    interval: float,
    strength: wp.array[float],
    source_weight: wp.array[float],
    heat_given: wp.array[wp.float64],
):
    """Add what sources give in ``interval`` [s] to ``heat_given`` (sources,) [J]; none where there are no particles."""
    s = wp.tid() + first
    if source_weight[s] > 0.0:
        heat_given[s] += wp.float64(strength[s]) * wp.float64(interval)  # Monaghan (2.12)
