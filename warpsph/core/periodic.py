"""A box that is periodic: what leaves it on one side comes in on the other."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsph.errors import InputError, numbers, require

LEAST_CELLS = 3
LEVEL = 1.0e-6  # of a unit normal, along an axis along which its plane is taken to be level
ROUNDING = 1.0e-5  # of the radius: what single precision may lose where a particle is given its cell


@dataclass(frozen=True)
class PeriodicBox:
    """A box whose opposite faces are one, along some axes or all.

    Its numbers are rounded to single precision, in which the device knows them.

    Args:
        lower: lower corner (3,) [m]; where the box is cut along a periodic axis makes no difference.
        lengths: its edges (3,) [m]; 0 or None along axes that are not periodic.

    Raises:
        InputError: not three finite numbers each, or no positive length.
    """

    lower: Sequence[float]
    lengths: Sequence[float | None]

    def __post_init__(self) -> None:
        three = isinstance(self.lengths, Sequence | np.ndarray) and len(self.lengths) == 3
        lower = _single(self.lower)
        lengths = _single([length or 0.0 for length in self.lengths] if three else None)
        require(self, "lower", bool(np.all(np.isfinite(lower))), "three finite numbers [m]")
        positive = bool(np.all(np.isfinite(lengths))) and min(lengths) >= 0.0 and max(lengths) > 0.0
        lost = three and any(length and not single for length, single in zip(self.lengths, lengths, strict=True))
        allowed = "three numbers [m], positive along periodic axes and 0 along the others"
        require(self, "lengths", positive and not lost, allowed)
        object.__setattr__(self, "lower", lower)
        object.__setattr__(self, "lengths", lengths)

    @property
    def edges(self) -> np.ndarray:
        """The lengths (3,) [m], 0 along axes that are not periodic."""
        return np.asarray(self.lengths, float)

    @property
    def axes(self) -> tuple[int, ...]:
        """The axes that are periodic, of 0, 1, 2."""
        return tuple(int(axis) for axis in np.flatnonzero(self.edges))

    @property
    def inverse(self) -> np.ndarray:
        """1 over the lengths (3,) [1/m], 0 along axes that are not periodic."""
        return np.divide(1.0, self.edges, out=np.zeros(3), where=self.edges > 0.0)

    def wrapped(self, points: np.ndarray) -> np.ndarray:
        """The places (n, 3) [m] in the box of points anywhere."""
        points = np.asarray(points, float)
        periods = np.where(self.edges > 0.0, self.edges, np.inf)
        return points - self.edges * np.floor((points - np.asarray(self.lower)) / periods)

    def nearest(self, way: np.ndarray) -> np.ndarray:
        """Ways (n, 3) [m] from one place to another, to the nearest of the other's images."""
        return way - self.edges * np.rint(way * self.inverse)

    def cells(self, radius: float) -> np.ndarray:
        """How many cells (3,) at least as wide as ``radius`` [m] fill its edges.

        Raises:
            InputError: fewer than three, so that a particle could see an image of another one beside the other itself.
        """
        radius *= 1.0 + ROUNDING
        for axis in self.axes:
            if self.edges[axis] < LEAST_CELLS * radius:
                raise InputError(
                    f"PeriodicBox: a length of {self.edges[axis]:.6g} m along {'xyz'[axis]}: must be at least "
                    f"{LEAST_CELLS * radius * (1.0 + ROUNDING):.6g} m, three times as far as the neighbour list reaches"
                )
        return np.floor(self.edges / radius)

    def facts(self) -> dict[str, Any]:
        """What a result file keeps of it."""
        return {"periodic_lower": list(self.lower), "periodic_lengths": self.edges.tolist()}

    @classmethod
    def of_facts(cls, facts: Mapping[str, Any]) -> "PeriodicBox | None":
        """The box of a result file, None where the run had none."""
        if "periodic_lengths" not in facts:
            return None
        return cls(facts.get("periodic_lower", (0.0, 0.0, 0.0)), facts["periodic_lengths"])


def box_constants(periodic: PeriodicBox | None) -> dict[str, object]:
    """The constant of the kernels that bring places into the box."""
    return {"box_lower": wp.vec3(*periodic.lower)} if periodic else {}


def axes_across(*normals: Sequence[float]) -> tuple[int, ...]:
    """The axes along which planes of these ``normals`` (3,) have one place in space."""
    return tuple(axis for axis in range(3) if any(abs(normal[axis]) > LEVEL for normal in normals))


def _single(values: Any) -> tuple[float, ...]:
    """Three numbers as single precision holds them, NaN where they are none."""
    with np.errstate(over="ignore"):
        return tuple(float(value) for value in np.asarray(numbers(values, 3)).astype(np.float32))
