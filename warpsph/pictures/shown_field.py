"""The field that particles are coloured by: one number each, and what it is called."""

from dataclasses import replace

import numpy as np

from warpsph.core.quantity import Quantity
from warpsph.errors import InputError
from warpsph.nearest import did_you_mean
from warpsph.pictures import vorticity


def values_of(fields: dict[str, np.ndarray], name: str) -> np.ndarray:
    """One number a particle (n,): a stored field, the magnitude of a vector, or ``speed``, that of the velocity.

    Raises:
        InputError: there is no such field.
    """
    allowed = list(dict.fromkeys([*fields, "speed", vorticity.NAME] if "velocity" in fields else fields))
    if name not in allowed:
        raise InputError(f"field = '{name}': the file holds no such field{did_you_mean(name, allowed)}")
    values = fields[name if name in fields else "velocity"]
    return np.linalg.norm(values.astype(float), axis=1) if values.ndim == 2 else values


def quantity_of(known: dict[str, Quantity], name: str) -> Quantity:
    """What the numbers of :func:`values_of` are, from what is known of the stored fields."""
    if name == vorticity.NAME and name not in known:
        return vorticity.QUANTITY
    if name == "velocity" or name not in known:
        return replace(known["velocity"], label="speed")
    return known[name]
