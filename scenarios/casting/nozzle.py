"""The submerged nozzle of the casting machine: where its melt enters, where it is free, and its walls."""

from dataclasses import dataclass

import numpy as np

from warpsph.core.particles import lattice
from warpsph.scenarios.casting.parameters import WALL_LAYERS, CastingParameters

Box = tuple[tuple[float, float, float], tuple[float, float, float]]  # two corners [m]


@dataclass(frozen=True)
class Nozzle:
    """Places of one nozzle.

    Attributes:
        direction: unit vector of the flow.
        row: places (k, 3) at which a row of melt enters [m].
        length: distance from there to the mouth [m].
        area_ratio: cross-section of the strand over that of the nozzle.
        walls: boxes that hold its walls.
        bore: box that holds its melt.
    """

    direction: tuple[float, float, float]
    row: np.ndarray
    length: float
    area_ratio: float
    walls: tuple[Box, ...]
    bore: Box

    def filling(self, spacing: float) -> np.ndarray:
        """Melt (n, 3) [m] in the nozzle at the start."""
        along = np.arange(0.0, self.length, spacing)[:, None, None] * np.asarray(self.direction)
        return (self.row + along).reshape(-1, 3)

    def wall_points(self, spacing: float, dimension: int) -> np.ndarray:
        """Walls (n, 3) [m]."""
        boxes = [lattice(low[:dimension], high[:dimension], spacing) for low, high in self.walls]
        return np.concatenate(boxes)

    def keeps_out(self, points: np.ndarray) -> np.ndarray:
        """Which of the ``points`` (n, 3) [m] lie where the nozzle is."""
        inside = np.zeros(len(points), bool)
        for low, high in (*self.walls, self.bore):
            inside |= np.all((points >= low) & (points <= high), axis=1)
        return inside


def straight_tube(case: CastingParameters, heights: np.ndarray, rim: float) -> Nozzle:
    """A tube along the axis, round ones as squares, that opens downwards.

    Its rows of melt continue those of the strand at ``heights`` [m]; two rows too near each other would be a shock.
    """
    dx, bore = case.spacing, case.bore
    mouth = float(np.max(heights[heights < case.nozzle_mouth])) + 0.5 * dx
    top = mouth + (np.ceil((case.level - mouth) / dx) + 5.5) * dx
    outside = bore + WALL_LAYERS * dx
    flat = case.dimension == 2
    depth = (-1.0, 1.0) if flat else (0.0, bore)
    row = lattice((0.0, 0.0), (bore, dx), dx) if flat else lattice((0.0, 0.0, 0.0), (bore, dx, bore), dx)
    row[:, 1] = top
    walls: list[Box] = [((bore, mouth, depth[0]), (outside, rim, depth[1] if flat else outside))]
    if not flat:
        walls.append(((0.0, mouth, bore), (bore, rim, outside)))
    return Nozzle(
        direction=(0.0, -1.0, 0.0),
        row=row,
        length=top - mouth,
        area_ratio=(case.half_width / bore) ** (case.dimension - 1),
        walls=tuple(walls),
        bore=((0.0, mouth, depth[0]), (bore, rim, depth[1])),
    )


def side_port(case: CastingParameters, rim: float) -> Nozzle:
    """A tube closed at its end, with a port on either side that leads the melt towards the shell; in the plane."""
    dx, reach, half_height = case.spacing, case.nozzle_reach, case.bore
    low, high, wall = case.nozzle_mouth - half_height, case.nozzle_mouth + half_height, WALL_LAYERS * dx
    row = lattice((0.0, low), (dx, high), dx)
    row[:, 0] = 0.0
    return Nozzle(
        direction=(1.0, 0.0, 0.0),
        row=row,
        length=reach,
        area_ratio=case.half_width / (2.0 * half_height),
        walls=(
            ((0.0, low - wall, -1.0), (reach, low, 1.0)),
            ((0.0, high, -1.0), (reach, high + wall, 1.0)),
            ((half_height, high + wall, -1.0), (half_height + wall, rim, 1.0)),
            ((0.0, high + wall, -1.0), (half_height, rim, 1.0)),
        ),
        bore=((0.0, low, -1.0), (reach, high, 1.0)),
    )
