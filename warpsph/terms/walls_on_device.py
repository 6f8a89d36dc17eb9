"""Walls of heat as the kernels of conduction see them."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.state import State
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.terms.heat_wall import NUMBERS, SLACK, HeatWall
from warpsph.terms.profile import Profile


def profiles_of(walls: Sequence[HeatWall]) -> list[Profile]:
    """The profiles of all walls, one after the other."""
    return [wall.profiles[name] for wall in walls for name in NUMBERS if name in wall.profiles]


def hold_walls(walls: Sequence[HeatWall], state: State) -> dict[str, wp.array]:
    """Make the arrays of one wall or more that are not the same in all of a run, by name; the state holds them."""
    arrays: dict[str, wp.array] = {}

    def hold(name: str, array: wp.array, scratch: bool = False) -> None:
        arrays[name] = state.hold(f"conduction.{name}", array, scratch)

    each = (len(walls), state.count)
    for name in NUMBERS:
        given = [getattr(wall, name) for wall in walls]
        hold(f"wall_{name}", wp.array(given, dtype=float, device=state.device))
        if profiles_of(walls):
            hold(f"wall_{name}_at", wp.zeros(each, dtype=float, device=state.device), scratch=True)
    hold("wall_heat", wp.zeros(each, dtype=wp.float64, device=state.device))
    hold("wall_rate", wp.zeros(each, dtype=float, device=state.device), scratch=True)
    for name in ("near_walls", "behind_walls"):
        hold(name, wp.zeros(state.count, dtype=int, device=state.device), scratch=True)
    return arrays


def walls_on_device(
    walls: Sequence[HeatWall], arrays: dict[str, wp.array], spacing: float, count: int, device: wp.Device
) -> HeatWalls:
    """Walls of given numbers with the ``arrays`` of :func:`hold_walls`, none of them without walls.

    Args:
        spacing: of the particles [m].
        count: number of particles.
    """
    planes: Any = HeatWalls()
    if walls:
        planes.normal = wp.array([wall.normal for wall in walls], dtype=wp.vec3d, device=device)
        planes.offset = wp.array([wall.offset for wall in walls], dtype=wp.float64, device=device)
        planes.slack = SLACK * spacing
        planes.rate, planes.taken = arrays["wall_rate"], arrays["wall_heat"]
        planes.near, planes.behind = arrays["near_walls"], arrays["behind_walls"]
        for name in NUMBERS:
            one_each = arrays[f"wall_{name}"]
            setattr(planes, name, one_each)
            setattr(
                planes, f"{name}_at", arrays[f"wall_{name}_at"] if profiles_of(walls) else _repeated(one_each, count)
            )
        planes.profile = _tables(walls, device)
    return planes


def _tables(walls: Sequence[HeatWall], device: wp.Device) -> wp.array:
    """Which profile each number of each wall has, (walls, 3), -1 where it has none; of no length without any."""
    has = np.array([[name in wall.profiles for name in NUMBERS] for wall in walls])
    tables = np.where(has, np.cumsum(has).reshape(has.shape) - 1, -1)
    return wp.array(tables if has.any() else np.zeros((0, 3)), dtype=int, device=device)


def _repeated(numbers: wp.array, count: int) -> wp.array:
    """The same memory as a row (numbers, count), each number ``count`` times."""
    return wp.array(
        ptr=numbers.ptr,
        shape=(len(numbers), count),
        strides=(numbers.strides[0], 0),
        dtype=numbers.dtype,
        device=numbers.device,
    )
