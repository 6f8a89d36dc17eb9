"""Placing particles on the host, before they become the state of a simulation."""

from dataclasses import dataclass, field

import numpy as np

from warpsph.core.labels import Phase, Role


@dataclass
class Particles:
    """Particles under construction: NumPy arrays that grow by :meth:`add`.

    Fields: position (n, 3) [m], velocity (n, 3) [m/s], role (n,), material (n,), phase (n,), body (n,), temperature
    (n,) [K]; ``held`` (n,), whether the temperature stays; ``flows`` (n,), whether the particle counts in the sums of
    the fluid; ``volume`` (n,) [m^3, or m^2 in 2D], or 0 for a cell of the lattice.
    """

    position: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    velocity: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    role: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int32))
    material: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int32))
    phase: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int32))
    body: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int32))
    temperature: np.ndarray = field(default_factory=lambda: np.zeros(0))
    held: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int32))
    flows: np.ndarray = field(default_factory=lambda: np.zeros(0, bool))
    volume: np.ndarray = field(default_factory=lambda: np.zeros(0))

    def __len__(self) -> int:
        return len(self.position)

    def add(
        self,
        position: np.ndarray,
        role: Role,
        material: int = 0,
        temperature: float | np.ndarray = 293.15,
        velocity: tuple[float, float, float] | np.ndarray = (0.0, 0.0, 0.0),
        held: bool | np.ndarray = False,
        flows: bool = True,
        volume: float | np.ndarray = 0.0,
        phase: Phase = Phase.LIQUID,
        body: int = 0,
    ) -> None:
        """Append particles at ``position`` (n, 3); the other values are one for all or one each.

        ``held`` particles keep their temperature and account for the heat they take. Particles whose ``phase`` is solid
        are bonded as they stand where the model is elastic; a phase change may melt them later. Solids of different
        ``body`` press on each other where the model has contact.
        """
        n = len(position)
        self.position = np.concatenate([self.position, position])
        self.velocity = np.concatenate([self.velocity, np.broadcast_to(velocity, (n, 3))])
        self.role = np.concatenate([self.role, np.full(n, int(role), np.int32)])
        self.material = np.concatenate([self.material, np.full(n, material, np.int32)])
        self.phase = np.concatenate([self.phase, np.full(n, int(phase), np.int32)])
        self.body = np.concatenate([self.body, np.full(n, body, np.int32)])
        self.temperature = np.concatenate([self.temperature, np.broadcast_to(temperature, n)])
        self.held = np.concatenate([self.held, np.broadcast_to(held, n).astype(np.int32)])
        self.flows = np.concatenate([self.flows, np.full(n, flows)])
        self.volume = np.concatenate([self.volume, np.broadcast_to(volume, n)])


def lattice(lower: tuple[float, ...], upper: tuple[float, ...], spacing: float) -> np.ndarray:
    """Centres (n, 3) of the square (or cubic) cells of edge ``spacing`` that fill a box, z = 0 for a box in the plane.

    Each edge holds the nearest whole number of cells; the lattice starts at ``lower``.
    """
    counts = [max(round((high - low) / spacing), 0) for low, high in zip(lower, upper, strict=True)]
    axes = [low + (np.arange(n) + 0.5) * spacing for low, n in zip(lower, counts, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(axes))
    return points if points.shape[1] == 3 else np.column_stack([points, np.zeros(len(points))])


def tank(lower: tuple[float, ...], upper: tuple[float, ...], spacing: float, layers: int = 3) -> np.ndarray:
    """Lattice points (n, 3) of an open box: floor and side walls of ``layers`` particles, nothing on top (+y)."""
    thickness = layers * spacing
    outer_lower = [low - thickness for low in lower]
    outer_upper = [high + thickness for high in upper]
    outer_upper[1] = upper[1]
    points = lattice(tuple(outer_lower), tuple(outer_upper), spacing)
    inside = np.ones(len(points), bool)
    for axis, (low, high) in enumerate(zip(lower, upper, strict=True)):
        inside &= (points[:, axis] > low) & (points[:, axis] < high)
    return points[~inside]
