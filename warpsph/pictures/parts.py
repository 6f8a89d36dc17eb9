"""What stands beside the simulated material: moulds, rolls, nozzles, water, each with a name and a colour."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.colors import to_rgb

from warpsph.core.labels import Role
from warpsph.pictures.palette import ROLE_COLOURS, SHADES

Fields = dict[str, np.ndarray]
Frames = list[tuple[np.ndarray, Fields]]

BESIDE_THE_FLUID = (Role.WALL, Role.DUMMY, Role.SPRAY)
ROLE_NAMES: Mapping[int, str] = {
    Role.FREE: "free",
    Role.WALL: "wall",
    Role.DUMMY: "dummy",
    Role.SPRAY: "spray",
    Role.RESERVOIR: "reservoir",
    Role.INFLOW: "inflow",
    Role.OUTFLOW: "outflow",
}


class Parts:
    """The particles of some roles; those of one role and one material are a part.

    A part has the name of its material, or that of its role where others are made of this material too.

    Args:
        frames: of the run.
        roles: which particles are parts.
        materials: names of the materials, by index; may be empty.
    """

    def __init__(self, frames: Frames, roles: Sequence[Role], materials: Sequence[str]) -> None:
        self.roles = roles
        roles_of: dict[int, set[int]] = {}
        for role, material in _pairs(frames):
            roles_of.setdefault(material, set()).add(role)
        self._named: dict[tuple[int, int], tuple[str, str]] = {}
        for role in roles:
            for shade, material in enumerate(sorted(m for m, users in roles_of.items() if role in users)):
                alone = roles_of[material] <= {role, Role.RESERVOIR} and material < len(materials)
                name = materials[material] if alone else ROLE_NAMES[role]
                self._named[role, material] = name, SHADES.get((role, shade), ROLE_COLOURS[role])

    @property
    def patches(self) -> list[tuple[str, str]]:
        """(name, colour) of each."""
        return list(dict.fromkeys(self._named.values()))

    def among(self, fields: Fields) -> np.ndarray:
        """Which particles (n,) are parts."""
        return np.isin(fields["role"], self.roles)

    def paint(self, colours: np.ndarray, fields: Fields) -> np.ndarray:
        """The ``colours`` (n, 3) of all particles, with those of the parts in their places."""
        material = _material(fields)
        for (role, of), (_, colour) in self._named.items():
            colours[(fields["role"] == role) & (material == of)] = to_rgb(colour)
        return colours


def _pairs(frames: Frames) -> set[tuple[int, int]]:
    """All pairs of role and material in some frames."""
    found: set[tuple[int, int]] = set()
    for _, fields in frames:
        pairs = np.unique(np.column_stack([fields["role"], _material(fields)]), axis=0)
        found |= {(role, material) for role, material in pairs.tolist()}
    return found


def _material(fields: Fields) -> np.ndarray:
    return fields.get("material", np.zeros_like(fields["role"]))
