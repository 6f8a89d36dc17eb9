"""A number that changes along a direction and with time."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
import warp as wp

from warpsph.errors import InputError, require
from warpsph.kernels.heat.profiles import Profiles

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


@dataclass(frozen=True, eq=False)
class Profile:
    """A number that is piecewise linear along a direction, in time, or in both; constant beyond its ends.

    Args:
        values: (times, places), or one of both where only places or only times are given; in the unit of what they are
            values of.
        places: rising distances along the direction [m], ``x . along``.
        along: the direction: "x", "y", "z" or a unit vector (3,); needed where places are given.
        times: rising times [s].
    """

    values: Sequence[float] | Sequence[Sequence[float]] | np.ndarray
    places: Sequence[float] | np.ndarray = ()
    along: str | Sequence[float] | None = None
    times: Sequence[float] | np.ndarray = ()

    def __post_init__(self) -> None:
        for name in ("places", "times"):
            require(self, name, _rises(getattr(self, name)), "numbers that rise")
        require(self, "places", len(self.places) + len(self.times) > 0, "given, or else times, or both")
        named = self.along is None or (isinstance(self.along, str) and self.along in AXES)
        vector = _array(self.along)
        unit = vector is not None and vector.shape == (3,) and abs(float(np.linalg.norm(vector)) - 1.0) < 1e-6
        require(self, "along", named or unit, "'x', 'y', 'z' or a unit vector of three numbers")
        require(self, "along", (self.along is not None) == (len(self.places) > 0), "given with places, and only then")
        shape = tuple(len(nodes) for nodes in (self.times, self.places) if len(nodes))
        finite = _array(self.values)
        fits = finite is not None and finite.shape == shape
        require(
            self, "values", fits, f"finite numbers, {' x '.join(map(str, shape))}, one for each time and each place"
        )

    @classmethod
    def of(
        cls,
        function: Callable[..., float],
        places: Sequence[float] | np.ndarray = (),
        along: str | Sequence[float] | None = None,
        times: Sequence[float] | np.ndarray = (),
    ) -> "Profile":
        """The values of ``function(place)``, of ``function(time)``, or of ``function(place, time)`` where both are."""
        shape = tuple(nodes for nodes in (places, times) if len(nodes))
        try:
            values = np.array([function(*point) for point in product(*shape)], float)
        except (TypeError, ValueError) as error:
            asked = " and the ".join(name for name, nodes in (("place", places), ("time", times)) if len(nodes))
            raise InputError(
                f"Profile: function = {function!r}: must be a function that gives a number for the {asked} ({error})"
            ) from None
        return cls(values.reshape([len(nodes) for nodes in shape]).T, places, along, times)

    @property
    def direction(self) -> tuple[float, ...]:
        """The direction (3,) of the places; zero where there are none."""
        if self.along is None:
            return (0.0, 0.0, 0.0)
        return AXES[self.along] if isinstance(self.along, str) else tuple(float(n) for n in self.along)

    @property
    def table(self) -> np.ndarray:
        """The values (times, places), with one time or one place where none are given."""
        return np.asarray(self.values, float).reshape(len(self.times) or 1, len(self.places) or 1)

    def at(self, points: np.ndarray, time: float) -> np.ndarray:
        """The values (n,) at ``points`` (n, 3) [m] and at a ``time`` [s]."""
        places = self.places if len(self.places) else [0.0]
        times = self.times if len(self.times) else [0.0]
        now = [float(np.interp(time, times, column)) for column in self.table.T]
        return np.interp(np.asarray(points, float) @ self.direction, places, now)


def on_device(given: Sequence[Profile], device: wp.Device) -> Profiles:
    """Tables for the kernels, one after the other."""

    def firsts(lengths: list[int]) -> wp.array:
        return wp.array(np.cumsum([0, *lengths]), dtype=int, device=device)

    places = [list(profile.places) or [0.0] for profile in given]
    times = [list(profile.times) or [0.0] for profile in given]
    values = [profile.table.ravel() for profile in given]
    tables: Any = Profiles()
    along = np.array([profile.direction for profile in given]).reshape(-1, 3)
    tables.along = wp.array(along, dtype=wp.vec3d, device=device)
    tables.first_place, tables.first_time = firsts([*map(len, places)]), firsts([*map(len, times)])
    tables.first_value = firsts([*map(len, values)])
    tables.places = wp.array(np.concatenate([[], *places]), dtype=wp.float64, device=device)
    tables.times = wp.array(np.concatenate([[], *times]), dtype=wp.float64, device=device)
    tables.values = wp.array(np.concatenate([[], *values]), dtype=float, device=device)
    return tables


def _array(values: Any) -> np.ndarray | None:
    """Finite numbers as an array; None where they are something else."""
    try:
        array = np.asarray(values)
    except ValueError:  # rows of different lengths
        return None
    return array if array.dtype.kind in "iuf" and np.all(np.isfinite(array)) else None


def _rises(nodes: Any) -> bool:
    """Whether these are no numbers at all, or finite ones that rise."""
    array = _array(nodes)
    return array is not None and array.ndim == 1 and bool(np.all(np.diff(array) > 0.0))
