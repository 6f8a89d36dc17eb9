"""The two integer labels of a particle: who moves it (role) and in which state of matter it is (phase)."""

from enum import IntEnum


class Role(IntEnum):
    """Who moves a particle."""

    FREE = 0  # the forces
    WALL = 1  # a moving or fixed conducting wall
    DUMMY = 2  # nobody: fixed, counts for density and pressure only
    SPRAY = 3  # the spray device: flies to the shell, rides on it until it has boiled away
    RESERVOIR = 4  # out of the simulation until a device brings it (back) in
    INFLOW = 5  # the inlet device
    OUTFLOW = 6  # the outflow device


class Phase(IntEnum):
    """State of matter of a particle."""

    LIQUID = 0
    MUSHY = 1
    SOLID = 2
