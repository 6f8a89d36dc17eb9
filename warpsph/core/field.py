"""Declarations of arrays: fields with an entry for each particle, and values that a term owns alone."""

from collections.abc import Callable, Sequence
from dataclasses import KW_ONLY, dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.quantity import Quantity

Start = float | Callable[[Any], float]  # a number, or what finds it from the model

Starts = Sequence[float] | np.ndarray

SHAPES: dict[Any, tuple[int, ...]] = {wp.vec3: (3,), wp.vec3d: (3,), wp.mat33: (3, 3)}
DTYPES = (int, float, wp.float64, wp.vec3, wp.vec3d, wp.mat33)
WRITABLE = (int, float, wp.float64, wp.vec3)


@dataclass(frozen=True, eq=False)
class Field:
    """One array with an entry for each particle: declared as a class attribute of the term that needs it.

    The attribute's name is the name of the array, of the kernels' argument, and in files. Terms that share an array
    share the declaration: ``froze = PhaseChange.froze``.

    Args:
        dtype: int, float, wp.float64, wp.vec3, wp.vec3d or wp.mat33.
        unit: SI unit, "" where it has none.
        label: a few words, for people and pictures.
        start: value at the start where neither the particles nor a term's ``start`` give one.
        least: the smallest value that particles may be given.
        compensated: whether a second array, ``<name>_carry``, holds what single precision loses of its sum.
        kept: whether it belongs to its particle from step to step: moved when particles are sorted, in snapshots and
            checkpoints. Otherwise it is written anew before it is read, and nobody else sees it.
        written: whether it goes to the frames of a result file.
        renewed: whether a particle that comes in from the reservoir has the start value again.
        colours: name of its colour map.
    """

    dtype: type
    unit: str
    label: str
    _: KW_ONLY
    start: Start = 0.0
    least: float = -np.inf
    compensated: bool = False
    kept: bool = True
    written: bool = False
    renewed: bool = False
    colours: str = "viridis"

    name = ""

    def __post_init__(self) -> None:
        if self.dtype not in DTYPES:
            allowed = "int, float, wp.float64, wp.vec3, wp.vec3d or wp.mat33"
            raise TypeError(f"field '{self.label}': dtype {self.dtype} is not one of {allowed}")
        if self.written and not (self.dtype in WRITABLE and self.kept):
            raise TypeError(f"field '{self.label}': only kept numbers and vectors can be written to frames")
        if self.renewed and isinstance(self.start, float | int) and self.dtype in SHAPES and self.start != 0.0:
            raise TypeError(f"field '{self.label}': a vector can be renewed to zero only")

    def __set_name__(self, owner: type, name: str) -> None:
        if self.name not in ("", name):
            raise TypeError(f"{owner.__name__}: the field '{self.name}' cannot be called '{name}' as well")
        object.__setattr__(self, "name", name)

    @property
    def carry_name(self) -> str:
        """Name of the array of a compensated field that holds what its sum has lost."""
        return f"{self.name}_carry"

    @property
    def quantity(self) -> Quantity:
        """What pictures need to know."""
        return Quantity(self.label, self.unit, self.colours)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of one entry."""
        return SHAPES.get(self.dtype, ())

    def start_value(self, model: Any) -> float:
        """The start value in a model."""
        return self.start(model) if callable(self.start) else self.start

    def array(self, values: np.ndarray, device: wp.Device) -> wp.array:
        """A device array of this field that holds ``values`` (n, ...)."""
        return wp.array(np.ascontiguousarray(values), dtype=self.dtype, device=device)


class Value:
    """A small array that one term owns, not one entry a particle: a counter, a sum, what is due.

    Declared as a class attribute; on an instance that belongs to a simulation the attribute is the device array.

    Args:
        dtype: of the entries.
        unit: SI unit, "" where it has none.
        label: a few words.
        start: numbers at the start, or what finds them from the term.
        scratch: whether it is written anew before it is read.
    """

    def __init__(
        self,
        dtype: type,
        unit: str,
        label: str,
        *,
        start: Starts | Callable[[Any], Starts] = (0,),
        scratch: bool = False,
    ):
        self.dtype, self.unit, self.label, self.start, self.scratch = dtype, unit, label, start, scratch
        self.name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, term: Any, owner: type) -> Any:
        if term is None:
            return self
        try:
            return term.arrays[self.name]
        except KeyError:
            raise RuntimeError(f"{owner.__name__}.{self.name}: the term belongs to no simulation yet") from None

    def array(self, term: Any, device: wp.Device) -> wp.array:
        """A device array with the start values."""
        start = self.start(term) if callable(self.start) else self.start
        return wp.array(np.asarray(start), dtype=self.dtype, device=device)


def declared(kind: type, sort: type) -> list[Any]:
    """The declarations of one sort that a class has and inherits, those of its bases first."""
    found = {name: value for base in reversed(kind.__mro__) for name, value in vars(base).items()}
    return [value for value in found.values() if isinstance(value, sort)]
