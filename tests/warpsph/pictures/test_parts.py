"""What the parts of a machine are called and how they are coloured."""

import numpy as np
import pytest

from warpsph.core.labels import Role
from warpsph.pictures.parts import BESIDE_THE_FLUID, Parts

MATERIALS = ["steel", "mould", "nozzle", "rolls", "water"]


def frame(*pairs):
    """A frame with one particle of each pair of role and material."""
    role, material = np.array(pairs).T
    return np.zeros((len(pairs), 3)), {"role": role, "material": material}


CAST = frame((Role.FREE, 0), (Role.WALL, 1), (Role.DUMMY, 2), (Role.DUMMY, 3), (Role.SPRAY, 4), (Role.RESERVOIR, 4))


def test_parts_are_called_after_their_materials():
    """If it failed, rolls and nozzle would both be called dummies."""
    parts = Parts([CAST], BESIDE_THE_FLUID, MATERIALS)
    assert [name for name, _ in parts.patches] == ["mould", "nozzle", "rolls", "water"]
    assert len({colour for _, colour in parts.patches}) == 4


def test_what_is_made_of_the_melt_is_called_after_its_role():
    """If it failed, the wall of a tank of steel would be called steel."""
    parts = Parts([frame((Role.FREE, 0), (Role.DUMMY, 0), (Role.WALL, 1))], BESIDE_THE_FLUID, MATERIALS)
    assert [name for name, _ in parts.patches] == ["mould", "dummy"]


@pytest.mark.parametrize("materials", [[], ["steel"]])
def test_files_without_names_or_materials(materials):
    """If it failed, the files of others could not be drawn."""
    assert [name for name, _ in Parts([CAST], BESIDE_THE_FLUID, materials).patches] == [
        "wall",
        "dummy",
        "dummy",
        "spray",
    ]
    bare = np.zeros((2, 3)), {"role": np.array([Role.FREE, Role.DUMMY])}
    assert [name for name, _ in Parts([bare], BESIDE_THE_FLUID, materials).patches] == ["dummy"]


def test_only_the_parts_are_painted_over():
    """If it failed, the steel would lose its colours, or a part would show the quantity of the steel."""
    colours = Parts([CAST], BESIDE_THE_FLUID, MATERIALS).paint(np.zeros((6, 3)), CAST[1])
    assert np.all(np.any(colours > 0.0, axis=1) == [False, True, True, True, True, False])
    assert len(np.unique(colours[1:5], axis=0)) == 4
