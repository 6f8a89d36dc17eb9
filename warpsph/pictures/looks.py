"""How particles are coloured, and the key that says so: by category, by one quantity, or as a freezing strand."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, TwoSlopeNorm, to_rgb

from warpsph.core.labels import Phase, Role
from warpsph.core.quantity import Quantity
from warpsph.files.results import ResultFile
from warpsph.pictures.palette import (
    DIVERGING,
    MATERIAL_COLOURS,
    PHASE_COLOURS,
    ROLE_COLOURS,
    UNKNOWN,
    colour_map,
    shell_and_melt,
)
from warpsph.pictures.parts import BESIDE_THE_FLUID, ROLE_NAMES, Fields, Frames, Parts
from warpsph.pictures.scales import colour_range, ticks_around, usable
from warpsph.pictures.shown_field import quantity_of, values_of
from warpsph.pictures.units import title_of


@dataclass
class Bar:
    """A colour bar: its colours, which ends it cannot show, its ticks and the names of its halves."""

    mappable: ScalarMappable
    extend: str = "neither"
    ticks: list[float] | None = None
    halves: tuple[str, ...] = ()


class CategoryLook:
    """One colour a category: role, phase or material.

    Args:
        name: the field.
        names, colours: of its categories.
        frames: of the run.
        parts: what has no category.
    """

    bar = None
    edge = False

    def __init__(
        self, name: str, names: Mapping[int, str], colours: Mapping[int, str], frames: Frames, parts: Parts
    ) -> None:
        self.name, self.title, self.colour_of, self.parts = name, name, colours, parts
        present = np.unique(np.concatenate([fields[name][~parts.among(fields)] for _, fields in frames])).tolist()
        self._patches = [(names.get(label, str(label)), colours.get(label, UNKNOWN)) for label in present]

    def colours(self, fields: Fields) -> np.ndarray:
        """(n, 3) from 0 to 1."""
        return self.parts.paint(_by_label(fields[self.name], self.colour_of), fields)

    def patches(self) -> list[tuple[str, str]]:
        """(name, colour) of what the key shows beside the bar."""
        return self._patches + self.parts.patches


class QuantityLook:
    """One quantity in one colour map, with the colours for the simulated material alone.

    Attributes:
        edge: whether a line shows where what has frozen ends.
    """

    def __init__(self, name: str, quantity: Quantity, frames: Frames, parts: Parts, edge: bool = False) -> None:
        self.name, self.parts, self.edge = name, parts, edge
        values = [values_of(fields, name)[~parts.among(fields)] for _, fields in frames]
        low, high, extend = colour_range(np.concatenate(values), whole=name == "temperature")
        colours = quantity.colours
        if colours in DIVERGING:
            low, high, colours = (-max(-low, high), max(-low, high), colours) if low < 0.0 else (low, high, "viridis")
        self.mappable = ScalarMappable(Normalize(low, high), colour_map(colours))
        self.title = title_of(quantity)
        self.bar = Bar(self.mappable, extend)

    def colours(self, fields: Fields) -> np.ndarray:
        """(n, 3) from 0 to 1."""
        return self.parts.paint(self.mappable.to_rgba(values_of(fields, self.name))[:, :3], fields)

    def patches(self) -> list[tuple[str, str]]:
        """(name, colour) of what the key shows beside the bar."""
        return self.parts.patches


class StrandLook:
    """Melt and shell by temperature in the two halves of one map, beside the parts: a strand as the caster sees it.

    The phase decides on the half, so that the shell stands out even where both have the temperature of freezing.
    """

    edge = False

    def __init__(self, temperature: Quantity, frames: Frames, parts: Parts) -> None:
        self.parts = parts
        shell, melt = (np.concatenate([_temperature(fields, solid) for _, fields in frames]) for solid in (True, False))
        freezing = np.quantile(shell, 0.995)
        least = min(1.0, 0.1 * abs(melt.max() - shell.min())) or 1.0  # of each half, where the other takes all
        least = max(least, 1e-6 * abs(freezing))
        low, high = min(shell.min(), freezing - least), max(melt.max(), freezing + least)
        self.mappable = ScalarMappable(TwoSlopeNorm(freezing, low, high), shell_and_melt())
        ticks = ticks_around(low, freezing, high)
        self.title = title_of(temperature)
        self.bar = Bar(self.mappable, ticks=ticks, halves=("shell", "melt"))

    def colours(self, fields: Fields) -> np.ndarray:
        """(n, 3) from 0 to 1."""
        position = self.mappable.norm(fields["temperature"])
        solid = fields["phase"] == Phase.SOLID
        position = np.where(solid, np.clip(position, 0.0, 0.499), np.clip(position, 0.501, 1.0))
        return self.parts.paint(self.mappable.cmap(position)[:, :3], fields)

    def patches(self) -> list[tuple[str, str]]:
        """(name, colour) of what the key shows beside the bar."""
        return self.parts.patches


Look = CategoryLook | QuantityLook | StrandLook


def choose_look(result: ResultFile, field: str | None, frames: Frames) -> Look:
    """The look for ``field``; without one a strand where something has frozen, else temperature or speed.

    Raises:
        InputError: the file holds no field of this name.
    """
    stored = result.provenance.get("materials")
    materials = [str(name) for name in stored] if isinstance(stored, list) else []

    def parts(*roles: Role) -> Parts:
        return Parts(frames, roles, materials)

    freezes = _freezes(frames)
    if field is None and freezes:
        return StrandLook(result.field_quantities["temperature"], frames, parts(*BESIDE_THE_FLUID))
    bonded = "bond" in result.provenance and "phase" in frames[0][1]
    field = field or ("phase" if bonded else _most_telling(frames))
    values_of(frames[0][1], field)
    if field == "role":
        return CategoryLook("role", ROLE_NAMES, ROLE_COLOURS, frames, parts())
    if field == "phase":
        names: Mapping[int, str] = {phase: phase.name.lower() for phase in Phase}
        return CategoryLook("phase", names, PHASE_COLOURS, frames, parts(*BESIDE_THE_FLUID))
    if field == "material":
        names, colours = dict(enumerate(materials)), dict(enumerate(MATERIAL_COLOURS))
        return CategoryLook("material", names, colours, frames, parts())
    # a mould is far colder than all steel, and would take the colours for itself
    beside = BESIDE_THE_FLUID if field == "temperature" and freezes else (Role.DUMMY, Role.SPRAY)
    return QuantityLook(field, quantity_of(result.field_quantities, field), frames, parts(*beside), edge=freezes)


def _most_telling(frames: Frames) -> str:
    """What is shown of a run without freezing where nothing is asked for."""
    fields = frames[0][1]
    if "temperature" in fields:
        temperatures = usable(np.concatenate([fields["temperature"] for _, fields in frames]))
        if len(temperatures) and np.ptp(temperatures) > 0.1:
            return "temperature"
    return "speed" if "velocity" in fields else "role"


def _freezes(frames: Frames) -> bool:
    """Whether there are both melt and solid."""
    if not {"temperature", "phase"} <= set(frames[0][1]):
        return False
    return all(any(len(_temperature(fields, solid)) for _, fields in frames) for solid in (True, False))


def _temperature(fields: Fields, solid: bool) -> np.ndarray:
    """Temperatures of the solid, or of the other, particles of the simulated material [K]."""
    chosen = (fields["phase"] == Phase.SOLID) == solid
    return usable(fields["temperature"][chosen & ~np.isin(fields["role"], BESIDE_THE_FLUID)])


def _by_label(labels: np.ndarray, colour_of: Mapping[int, str]) -> np.ndarray:
    present, places = np.unique(labels, return_inverse=True)
    table = np.array([to_rgb(colour_of.get(label, UNKNOWN)) for label in present.tolist()])
    return table.reshape(-1, 3)[places]
