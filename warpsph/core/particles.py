"""Placing particles on the host, before they become the state of a simulation."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from warpsph.core.capacity import refuse_too_many
from warpsph.core.labels import Phase, Role
from warpsph.errors import InputError, number, numbers, shown


@dataclass
class Block:
    """Particles that were added together: places (n, 3) [m], roles, names of materials (n,), and values by field."""

    position: np.ndarray
    role: np.ndarray
    material: np.ndarray
    volume: np.ndarray
    flows: np.ndarray
    values: dict[str, np.ndarray]


@dataclass
class Particles:
    """Particles under construction; they grow by :meth:`add`."""

    blocks: list[Block] = field(default_factory=list)

    def __len__(self) -> int:
        return sum(len(block.position) for block in self.blocks)

    def add(
        self,
        /,
        position: np.ndarray,
        role: Role | np.ndarray,
        material: str | Sequence[str] | np.ndarray | None = None,
        *,
        velocity: tuple[float, float, float] | np.ndarray = (0.0, 0.0, 0.0),
        phase: Phase | np.ndarray = Phase.LIQUID,
        volume: float | np.ndarray = 0.0,
        flows: bool | np.ndarray = True,
        **fields: float | np.ndarray,
    ) -> None:
        """Append particles at ``position`` (n, 3) [m]; the other values are one for all or one each.

        Args:
            position: places (n, 3) [m].
            role: who moves them.
            material: name of one of the model's materials, or one name each; None is the only one that the model has.
            velocity: (3,) or (n, 3) [m/s].
            phase: those whose phase is solid are bonded as they stand where the model is elastic; a phase change may
                melt them later. At the melting point of a pure substance it says whether the latent heat is there;
                elsewhere the temperature decides.
            volume: [m^3], or [m^2] in 2D; 0 for a cell of the lattice.
            flows: whether they count in the sums of the fluid.
            fields: values of any field that a term of the model declares, by its name: ``temperature`` [K]; ``held``,
                whether the temperature stays and the heat they take is counted; ``body``, to which they belong.

        Raises:
            InputError: places are not (n, 3), or not finite; roles, materials, volumes or flows are not what they must
                be.
        """
        position = _array("position", position)
        if position.dtype.kind not in "iuf":
            raise InputError("particles: position is no array of numbers; give (n, 3)")
        position = position.astype(float)
        if position.size == 0:
            position = position.reshape(0, 3)
        if position.ndim != 2 or position.shape[1] != 3:
            raise InputError(
                f"particles: position has the shape {position.shape}; give (n, 3), in the plane with z = 0"
            )
        if bad := int(np.sum(~np.all(np.isfinite(position), axis=1))):
            raise InputError(f"particles: position: {bad} of {len(position)} are not finite numbers")
        n = len(position)
        refuse_too_many("particles: a block", n)
        given = {"velocity": velocity, "phase": phase} | fields
        self.blocks.append(
            Block(
                position,
                _one_each("role", role, n, "one of Role", list(Role)).astype(np.int32),
                _names("material", material, n),
                _one_each("volume", volume, n, "zero or positive [m^3 or m^2]").astype(float),
                _one_each("flows", flows, n, "true or false", [False, True]).astype(bool),
                {name: _array(name, value) for name, value in given.items()},
            )
        )

    def add_table(self, table: Mapping[str, Any], /, role: Role | np.ndarray | None = None, **given: Any) -> None:
        """Append the particles of a table: a column for each argument of :meth:`add`, (n, 3) or (n,) values each.

        :func:`warpsph.files.particles.read_particles` makes such a table of a file. What is ``given`` here, by the
        names of the arguments of :meth:`add`, takes the place of the table's column.

        Raises:
            InputError: it has no column "position", no role is known, or a column is not what it must be.
        """
        columns: dict[str, Any] = {**table, **given} | ({} if role is None else {"role": role})
        for name, remedy in (("position", "a column of that name is needed"), ("role", "give one, such as Role.FREE")):
            if name not in columns:
                raise InputError(f"particles: the table has no {name}: {remedy}")
        self.add(**columns)

    @property
    def position(self) -> np.ndarray:
        """Places (n, 3) [m]."""
        return np.concatenate([block.position for block in self.blocks] or [np.zeros((0, 3))])

    @property
    def role(self) -> np.ndarray:
        """Roles (n,)."""
        return np.concatenate([block.role for block in self.blocks] or [np.zeros(0, np.int32)])

    @property
    def material(self) -> np.ndarray:
        """Names of materials (n,), None for the only one that there is."""
        return np.concatenate([block.material for block in self.blocks] or [np.zeros(0, object)])

    @property
    def volume(self) -> np.ndarray:
        """Volumes (n,) [m^3 or m^2], 0 for a cell of the lattice."""
        return np.concatenate([block.volume for block in self.blocks] or [np.zeros(0)])

    @property
    def flows(self) -> np.ndarray:
        """Which particles (n,) count in the sums of the fluid."""
        return np.concatenate([block.flows for block in self.blocks] or [np.zeros(0, bool)])

    def was_given(self, name: str) -> np.ndarray:
        """Which particles (n,) have been given a value of a field."""
        return np.concatenate([np.full(len(block.position), name in block.values) for block in self.blocks])

    @property
    def given(self) -> list[str]:
        """Names of the fields of which some particles have been given values."""
        return list(dict.fromkeys(name for block in self.blocks for name in block.values))

    def column(self, name: str, shape: tuple[int, ...], start: float) -> np.ndarray:
        """Values (n, *shape) of a field, ``start`` where none were given.

        Raises:
            InputError: the values do not fit the particles that they were given to.
        """
        columns = [np.zeros((0, *shape))]
        for block in self.blocks:
            values, n = block.values.get(name, np.asarray(start)), len(block.position)
            try:
                columns.append(np.broadcast_to(values, (n, *shape)))
            except ValueError:
                raise InputError(
                    f"particles: '{name}' was given values of shape {values.shape}; {n} particles take one for all "
                    f"{shape} or one each {(n, *shape)}"
                ) from None
        return np.concatenate(columns)


def _array(name: str, value: Any) -> np.ndarray:
    """A copy as an array."""
    try:
        return np.array(value)
    except (TypeError, ValueError):
        raise InputError(f"particles: {name} is no array of numbers; give one for all or one for each") from None


def _names(name: str, value: Any, n: int) -> np.ndarray:
    """Names (n,), one for all or one each; None stands for the only one that there is."""
    values = np.empty(n, object)
    one_each = isinstance(value, np.ndarray | Sequence) and not isinstance(value, str) and np.shape(value) == (n,)
    values[:] = [str(v) if isinstance(v, str) else v for v in value] if one_each else [value] * n
    if not all(v is None or isinstance(v, str) for v in values):
        raise InputError(f"particles: {name} = {shown(value)}: must be a name, one for all or one for each of {n}")
    return values


def _one_each(name: str, value: Any, n: int, allowed: str, of: Sequence[Any] | None = None) -> np.ndarray:
    """One value for each of n particles (n,), of those that are allowed, or else zero or positive."""
    values = _array(name, value)
    right = values.shape in ((), (n,)) and values.dtype.kind in "biuf"
    if not right or not np.all(np.isin(values, of) if of is not None else (values >= 0.0) & np.isfinite(values)):
        raise InputError(f"particles: {name} = {shown(value)}: must be {allowed}, one for all or one for each of {n}")
    return np.broadcast_to(values, n)


def lattice(lower: Sequence[float], upper: Sequence[float], spacing: float) -> np.ndarray:
    """Centres (n, 3) of the square (or cubic) cells of edge ``spacing`` that fill a box, z = 0 for a box in the plane.

    Each edge holds the nearest whole number of cells; the lattice starts at ``lower``.

    Raises:
        InputError: the corners are not two of two or three numbers each, or ``spacing`` is not positive.
    """
    _refuse_no_box("lattice", lower, upper, spacing)
    edges = [max((high - low) / spacing, 0.0) for low, high in zip(lower, upper, strict=True)]
    refuse_too_many("lattice", float(np.prod(edges)))
    counts = [round(edge) for edge in edges]
    axes = [low + (np.arange(n) + 0.5) * spacing for low, n in zip(lower, counts, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(axes))
    return points if points.shape[1] == 3 else np.column_stack([points, np.zeros(len(points))])


def parked(place: Sequence[float], count: float) -> np.ndarray:
    """Positions (n, 3) [m] of ``count`` particles at one place, where a reservoir waits.

    Raises:
        InputError: there are more than the memory holds.
    """
    refuse_too_many("reservoir", count)
    return np.tile([np.asarray(place, float)], (int(count), 1))


def tank(
    lower: Sequence[float], upper: Sequence[float], spacing: float, layers: int = 3, lid: bool = False
) -> np.ndarray:
    """Lattice points (n, 3) of a box: floor and side walls of ``layers`` particles, and on top (+y) nothing or a lid.

    Raises:
        InputError: as :func:`lattice` does; or there is no layer.
    """
    _refuse_no_box("tank", lower, upper, spacing)
    if not number(layers) >= 1:
        raise InputError(f"tank: layers = {shown(layers)}: must be 1 or more")
    thickness = layers * spacing
    outer_lower = [low - thickness for low in lower]
    outer_upper = [high + thickness for high in upper]
    if not lid:
        outer_upper[1] = upper[1]
    points = lattice(tuple(outer_lower), tuple(outer_upper), spacing)
    inside = np.ones(len(points), bool)
    for axis, (low, high) in enumerate(zip(lower, upper, strict=True)):
        inside &= (points[:, axis] > low) & (points[:, axis] < high)
    return points[~inside]


def _refuse_no_box(what: str, lower: Sequence[float], upper: Sequence[float], spacing: float) -> None:
    """Corners are two or three numbers each; a spacing is positive."""
    same = any(np.all(np.isfinite([numbers(lower, n), numbers(upper, n)])) for n in (2, 3))
    if not same:
        raise InputError(
            f"{what}: lower, upper = {shown(lower)}, {shown(upper)}: must be two corners of two or three numbers [m]"
        )
    if not 0.0 < number(spacing) < np.inf:
        raise InputError(f"{what}: spacing = {shown(spacing)}: must be positive [m]")
