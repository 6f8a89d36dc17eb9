"""The colours of all pictures: roles, phases and materials, and the colour maps."""

from collections.abc import Mapping
from functools import cache

from matplotlib import colormaps
from matplotlib.colors import Colormap, LinearSegmentedColormap

from warpsph.core.labels import Phase, Role

ROLE_COLOURS: Mapping[int, str] = {
    Role.FREE: "#f28e2b",
    Role.WALL: "#35b8a9",
    Role.DUMMY: "#e4dfce",
    Role.SPRAY: "#1f49c4",
    Role.RESERVOIR: "#c9c9c9",
    Role.INFLOW: "#fbd34d",
    Role.OUTFLOW: "#b5532a",
}
# by role and place among the materials of this role
SHADES: Mapping[tuple[int, int], str] = {
    (Role.WALL, 1): "#7d8f3c",
    (Role.DUMMY, 1): "#b9a27c",
    (Role.DUMMY, 2): "#6f6a60",
}
PHASE_COLOURS: Mapping[int, str] = {Phase.LIQUID: "#ee7412", Phase.MUSHY: "#f6c667", Phase.SOLID: "#34567d"}
UNKNOWN = "#999999"
MATERIAL_COLOURS = ("#ee7412", "#35b8a9", "#34567d", "#b279a2", "#bab0ac", "#9d755d")

DIVERGING = ("RdBu_r",)  # maps whose middle is zero

SHELL = ("#0a1a33", "#17365f", "#2c5f8f", "#5b93bd", "#a3c8de")
MELT = ("#a81f08", "#d24a0c", "#ef7c18", "#fbab35", "#fed766", "#fff3b8")


def colour_map(name: str) -> Colormap:
    """The colour map of that name; viridis for a name that matplotlib does not know."""
    return colormaps.get(name, colormaps["viridis"])


@cache
def shell_and_melt() -> Colormap:
    """Lower half: the solid phase, navy where it is cold; upper half: the melt, from dark red to pale yellow."""
    shell = LinearSegmentedColormap.from_list("shell", SHELL)
    melt = LinearSegmentedColormap.from_list("melt", MELT)
    half = [i / 127 for i in range(128)]
    return LinearSegmentedColormap.from_list("shell and melt", [*map(shell, half), *map(melt, half)], N=256)
