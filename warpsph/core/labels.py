"""The labels of a particle, for everybody above the kernels."""

from warpsph.kernels.basics.labels import Phase, Role

__all__ = ["Phase", "Role"]
