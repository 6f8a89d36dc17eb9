"""The memory of a simulation, reckoned before it is taken."""

import numpy as np
import warp as wp

from warpsph.core.capacity import free_memory, in_bytes, refuse_more_than_fits
from warpsph.core.field import Field, declared
from warpsph.core.model import Model
from warpsph.errors import InputError

SKIN = 0.4  # of the neighbour list, in spacings
SORTING = 28  # bytes a particle: cell, rank, order, place, and where it stood when the list was made
CIRCLE_OR_SPHERE = {2: np.pi, 3: 4.0 / 3.0 * np.pi}
MOST_ENTRIES = 2**31 - 1  # which an index of 32 bits can count


def farthest_reach(model: Model) -> float:
    """How far [m] the terms of a composed model see neighbours."""
    return max(model.support, *(term.reach(model) for term in model.terms))


def row_capacity(model: Model, radius: float) -> int:
    """Entries of a row of neighbours within ``radius`` [m]."""
    return int(1.6 * CIRCLE_OR_SPHERE[model.dimension] * (radius / model.spacing) ** model.dimension) + 8


def bytes_each(model: Model) -> tuple[float, float]:
    """Memory of a particle of a composed model [bytes]: on the device, and on the host while it starts."""
    fields: dict[str, Field] = {f.name: f for term in model.terms for f in declared(type(term), Field)}
    device = SORTING + 4.0 * (row_capacity(model, farthest_reach(model) + SKIN * model.spacing) + 1)
    device += sum(term.bytes_each(model) for term in model.terms)
    host = 0.0
    for field in fields.values():
        size = wp.types.type_size_in_bytes(field.dtype)
        device += size * (1 + field.compensated) * (1 + field.kept)  # what is kept has a place to be sorted to
        host += 8.0 * max(int(np.prod(field.shape)), 1)
    return device, host


def refuse_what_does_not_fit(model: Model, count: int, device: wp.Device) -> None:
    """Refuse a simulation of a composed model for which the device or the host has no room.

    Raises:
        InputError: how much is needed, and how much there is.
    """
    on_device, on_host = (count * size for size in bytes_each(model))
    entries = count * row_capacity(model, farthest_reach(model) + SKIN * model.spacing)
    what = f"{count} particles"
    if entries > MOST_ENTRIES:
        raise InputError(
            f"{what}: their lists of neighbours have {entries:.3g} entries, and {MOST_ENTRIES:.3g} are the most "
            f"({in_bytes(on_device)} of memory); a larger spacing, fewer rows or a smaller case has fewer"
        )
    if device.is_cuda:
        refuse_more_than_fits(f"{what} on {device.alias}", on_device, float(device.free_memory))
        on_device = 0.0
    refuse_more_than_fits(what, on_device + on_host, free_memory())
