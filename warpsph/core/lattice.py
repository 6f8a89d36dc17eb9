"""Sums over the infinite lattice of particles, by which smoothing kernels are made exact on it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from warpsph.kernels.basics import smoothing
from warpsph.kernels.basics.host import on_host
from warpsph.kernels.basics.smoothing import normalisation


@dataclass(frozen=True)
class Lattice:
    """A square or cubic lattice, seen by smoothing kernels of one support.

    Smoothing kernels are named as in :data:`warpsph.kernels.basics.smoothing.SMOOTHING_KERNELS`.

    Args:
        dimension: 2 or 3.
        spacing: dx [m].
        support_ratio: H / dx.
    """

    dimension: int
    spacing: float
    support_ratio: float

    @property
    def support(self) -> float:
        """H [m]."""
        return self.support_ratio * self.spacing

    @property
    def cell_volume(self) -> float:
        """Volume of one particle [m^3], or area [m^2] in 2D."""
        return self.spacing**self.dimension

    @cached_property
    def offsets(self) -> np.ndarray:
        """Neighbours (n, 3) [m] of a particle, inside the support."""
        reach = int(np.ceil(self.support_ratio))
        steps = np.arange(-reach, reach + 1)
        depth = steps if self.dimension == 3 else np.zeros(1)
        points = np.stack(np.meshgrid(steps, steps, depth, indexing="ij"), -1).reshape(-1, 3) * self.spacing
        distance = np.linalg.norm(points, axis=1)
        return points[(distance > 0.0) & (distance < self.support)]

    def density(self, name: str = "poly6") -> float:
        """Number density times cell volume that a sum of W finds; 1 for a perfect smoothing kernel."""
        return self._sum(name, "value", 1.0) + self._sum(name, "value", 1.0, np.zeros((1, 3)))

    def slope(self, name: str) -> float:
        """Gradient that a sum of V (f_j - f_i) grad W finds for a field of gradient 1; also, for the sum of
        2 V (f_i - f_j) W'/r that conducts, the diffusivity over the true one."""
        return -self._sum(name, "slope", self.offsets[:, 0] ** 2)

    def slopes(self, name: str) -> np.ndarray:
        """V W'/r [1/m^2] of each neighbour (n,)."""
        return self._scale(name) * self._shape(name, "slope", self.offsets)

    def curvature(self, name: str) -> float:
        """Laplacian that a sum of V (f_j - f_i) laplacian W finds for a field of second derivative 1."""
        return self._sum(name, "laplacian", 0.5 * self.offsets[:, 0] ** 2)

    def coupling(self, name: str) -> tuple[float, float]:
        """Sum of 2 V (-W'/r) over the neighbours [1/m^2], and the same at no distance, both over the slope.

        Times a diffusivity: how fast a particle follows all its neighbours, and one that stands where it stands.
        """
        neighbours, here = (self._sum(name, "slope", -2.0, places) for places in (self.offsets, np.zeros((1, 3))))
        return neighbours / self.slope(name), here / self.slope(name)

    def surface(self, name: str, threshold: float) -> tuple[float, float]:
        """Sum of V (|grad c| - threshold), where positive, over the particles under a unit of a face of the lattice.

        And their mean depth [m], so weighted. ``threshold`` [1/m]; without one the sum is half the slope, close to 1/2.
        """
        d = self.offsets
        total = moment = 0.0
        for layer in range(int(np.ceil(self.support_ratio))):
            missing = d[:, 0] > (layer + 0.5) * self.spacing
            steepness = -self._sum(name, "slope", d[missing, 0], d[missing])
            weight = self.spacing * max(steepness - threshold, 0.0)
            total += weight
            moment += weight * (layer + 0.5) * self.spacing
        return float(total), float(moment / total)

    def detour(self, name: str) -> float:
        """Sum of V (-W'/r) over the neighbours on one side, each times its distance and its distance across; about 1/2.

        With the distance across in the place of the distance it would be half the slope.
        """
        beyond = self.offsets[self.offsets[:, 0] > 0.0]
        return -self._sum(name, "slope", beyond[:, 0] * np.linalg.norm(beyond, axis=1), beyond)

    def _sum(self, name: str, form: str, weights: np.ndarray | float, offsets: np.ndarray | None = None) -> float:
        """Sum of V times weight times a form of W ("value", "slope" or "laplacian") over the neighbours."""
        values = self._shape(name, form, self.offsets if offsets is None else offsets)
        return float(self._scale(name) * np.sum(weights * values))

    def _scale(self, name: str) -> float:
        return normalisation(name, self.dimension, self.support) * self.cell_volume

    def _shape(self, name: str, form: str, offsets: np.ndarray) -> np.ndarray:
        """A form of W (n,), without the normalisation, at offsets (n, 3) [m]."""
        shape = on_host(getattr(smoothing, f"{name}_{form}"))
        takes_dimension = "dimension" in shape.__code__.co_varnames[: shape.__code__.co_argcount]
        return shape(np.sum(offsets**2, axis=1), self.support, *((self.dimension,) if takes_dimension else ()))
