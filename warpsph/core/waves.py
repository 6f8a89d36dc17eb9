"""What sums over the lattice make of its shortest waves, by which their longest stable time steps go."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from warpsph.core.lattice import Lattice

DIRECTIONS = 9  # wave numbers along each axis, from none to the shortest wave that a row can hold


@dataclass(frozen=True)
class WaveRates:
    """The largest answers of sums over neighbours to a wave of unit amplitude, over all waves.

    Attributes:
        spread: of the sum of V (f_i - f_j) (-W'/r) [1/m^2], by which something diffuses.
        along: of the same sum with only the part of a vector that points along the pair [1/m^2].
        slope: of the sum of V f_j grad W [1/m], the gradient.
    """

    spread: float
    along: float
    slope: float


@lru_cache
def wave_rates(lattice: Lattice, name: str) -> WaveRates:
    """The answers of a lattice seen by a smoothing kernel, whose gradients are exact on it."""
    d = lattice.offsets
    r = np.linalg.norm(d, axis=1)
    F = lattice.slopes(name) / lattice.slope(name)
    numbers = np.linspace(0.0, np.pi, DIRECTIONS) / lattice.spacing
    waves = np.stack(np.meshgrid(*[numbers] * lattice.dimension, indexing="ij"), -1).reshape(-1, lattice.dimension)
    phase = waves @ d[:, : lattice.dimension].T
    kept = (1.0 - np.cos(phase)) * -F
    along = np.einsum("wj,ja,jb->wab", kept, d / r[:, None], d / r[:, None])
    return WaveRates(
        spread=float(kept.sum(axis=1).max()),
        along=float(np.linalg.eigvalsh(along).max()),
        slope=float(np.linalg.norm((np.sin(phase) * F) @ d, axis=1).max()),
    )
