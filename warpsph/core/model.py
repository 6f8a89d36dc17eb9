"""What does not change in a run: dimension, spacing, materials, and the terms."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeVar

import numpy as np

from warpsph.core.lattice import Lattice
from warpsph.core.materials import Material
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError, number, numbers, require
from warpsph.nearest import did_you_mean

GRAVITY = 9.81  # [m/s^2]

Kind = TypeVar("Kind")


@dataclass(frozen=True)
class Model:
    """All that stays the same.

    Args:
        dimension: 2 or 3.
        spacing: particle spacing dx [m].
        materials: the materials, each with a name of its own.
        terms: physics and parts of the machine, instances of :class:`warpsph.core.term.Term`, in any order.
        support_ratio: support radius of the smoothing kernels over the spacing, H / dx.
        gravity: (3,) [m/s^2], on all that moves freely. Along a periodic axis it is a push: it drives a flow between
            walls (Poiseuille), and lets everything fall for ever where there is none. The pressure at walls follows it.
        periodic: the box that is periodic, if there is one.

    Raises:
        InputError: an argument is out of bounds, or two materials have the same name.
    """

    dimension: int
    spacing: float
    materials: tuple[Material, ...]
    terms: tuple[Any, ...] = ()
    support_ratio: float = 2.6
    gravity: tuple[float, float, float] = (0.0, -GRAVITY, 0.0)
    periodic: PeriodicBox | None = None

    def __post_init__(self) -> None:
        require(self, "dimension", self.dimension in (2, 3), "2 or 3")
        require(self, "spacing", 0.0 < number(self.spacing) < np.inf, "positive [m]")
        require(
            self, "support_ratio", 1.2 <= number(self.support_ratio) <= 10.0, "from 1.2 to 10 spacings, for neighbours"
        )
        require(self, "gravity", bool(np.all(np.isfinite(numbers(self.gravity, 3)))), "three numbers")
        require(self, "terms", isinstance(self.terms, tuple | list), "a tuple of terms")
        planar = self.dimension == 2 and self.gravity[2] != 0.0
        require(self, "gravity", not planar, "in the plane: its third number is 0 in two dimensions")
        box = self.periodic
        require(self, "periodic", box is None or isinstance(box, PeriodicBox), "a PeriodicBox, or None")
        deep = box is not None and self.dimension == 2 and 2 in box.axes
        require(self, "periodic", not deep, "a box in the plane: the third of its lengths is 0 in two dimensions")
        several = isinstance(self.materials, tuple | list) and len(self.materials) > 0
        whole = several and all(isinstance(material, Material) for material in self.materials)
        require(self, "materials", whole, "a tuple of one material or more")
        names = [material.name for material in self.materials]
        for name in names:
            if names.count(name) > 1:
                raise InputError(f"materials: two are called '{name}'; each needs a name of its own")

    @property
    def support(self) -> float:
        """Support radius H [m]."""
        return self.support_ratio * self.spacing

    @property
    def cell_volume(self) -> float:
        """Volume of one particle of the lattice [m^3], or area [m^2] in 2D."""
        return self.spacing**self.dimension

    @cached_property
    def lattice(self) -> Lattice:
        """The lattice of particles, with the support of the smoothing kernels."""
        return Lattice(self.dimension, self.spacing, self.support_ratio)

    def find(self, kind: type[Kind]) -> Kind | None:
        """The first term of a kind, or None."""
        return next((term for term in self.terms if isinstance(term, kind)), None)

    def the(self, kind: type[Kind]) -> Kind:
        """The first term of a kind that must be there."""
        term = self.find(kind)
        if term is None:
            raise InputError(f"this case has no {kind.__name__}; add one to its terms")
        return term

    def index_of(self, material: str | None) -> int:
        """Index of a material by its name; None is the only one that there is.

        Raises:
            InputError: there is no such material, or there are several and none was named.
        """
        names = [known.name for known in self.materials]
        if material is None and len(names) == 1:
            return 0
        if material not in names:
            what = "no material was named" if material is None else f"unknown material '{material}'"
            raise InputError(f"{what}{did_you_mean(material or '', names)}")
        return names.index(material)
