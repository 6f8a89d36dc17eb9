"""How particles are coloured, and the key that says so: by category, by one quantity, or as a freezing strand."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, TwoSlopeNorm, to_rgb

from warpsph.core.labels import Phase, Role
from warpsph.core.quantity import Quantity
from warpsph.files.results import ResultFile
from warpsph.pictures.palette import MATERIAL_COLOURS, PHASE_COLOURS, ROLE_COLOURS, UNKNOWN, colour_map, shell_and_melt
from warpsph.pictures.scales import colour_range, ticks_around
from warpsph.pictures.shown_field import quantity_of, values_of
from warpsph.pictures.units import title_of

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

Fields = dict[str, np.ndarray]
Frames = list[tuple[np.ndarray, Fields]]


@dataclass
class Bar:
    """A colour bar: its colours, which ends it cannot show, its ticks and the names of its halves."""

    mappable: ScalarMappable
    extend: str = "neither"
    ticks: list[float] | None = None
    halves: tuple[str, ...] = ()


class CategoryLook:
    """One colour a category: role, phase or material."""

    bar = None

    def __init__(
        self,
        name: str,
        names: Mapping[int, str],
        colours: Mapping[int, str],
        frames: Frames,
        aside: Sequence[Role] = (),
    ) -> None:
        self.name, self.title, self.colour_of, self.aside = name, name, colours, aside
        shown = [fields[name][~np.isin(fields["role"], aside)] for _, fields in frames]
        present = np.unique(np.concatenate(shown)).tolist()
        self._patches = [(names.get(label, str(label)), colours.get(label, UNKNOWN)) for label in present]
        self._patches += [(ROLE_NAMES[role], ROLE_COLOURS[role]) for role in _roles_present(frames, aside)]

    def colours(self, fields: Fields) -> np.ndarray:
        """(n, 3) from 0 to 1."""
        return _paint_roles(_by_label(fields[self.name], self.colour_of), fields["role"], self.aside)

    def patches(self) -> list[tuple[str, str]]:
        """(name, colour) of what the key shows beside the bar."""
        return self._patches


class QuantityLook:
    """One quantity in one colour map; dummies stay pale, and sprays blue, for most quantities mean nothing there."""

    aside = (Role.DUMMY, Role.SPRAY)

    def __init__(self, name: str, quantity: Quantity, frames: Frames) -> None:
        self.name = name
        values = [self._shown(fields) for _, fields in frames]
        low, high, extend = colour_range(np.concatenate(values), whole=name == "temperature")
        self.mappable = ScalarMappable(Normalize(low, high), colour_map(quantity.colours))
        self.title = title_of(quantity)
        self.bar = Bar(self.mappable, extend)
        self.present = _roles_present(frames, self.aside)

    def _shown(self, fields: Fields) -> np.ndarray:
        return values_of(fields, self.name)[~np.isin(fields["role"], self.aside)]

    def colours(self, fields: Fields) -> np.ndarray:
        """(n, 3) from 0 to 1."""
        colours = self.mappable.to_rgba(values_of(fields, self.name))[:, :3]
        return _paint_roles(colours, fields["role"], self.aside)

    def patches(self) -> list[tuple[str, str]]:
        """(name, colour) of what the key shows beside the bar."""
        return [(ROLE_NAMES[role], ROLE_COLOURS[role]) for role in self.present]


class StrandLook:
    """Melt and shell by temperature in the two halves of one map, the rest by role: a strand as the caster sees it.

    The phase decides on the half, so that the shell stands out even where both have the temperature of freezing.
    """

    def __init__(self, temperature: Quantity, frames: Frames) -> None:
        shell, melt = (np.concatenate([_temperature(fields, solid) for _, fields in frames]) for solid in (True, False))
        freezing = np.quantile(shell, 0.995)
        low, high = min(shell.min(), freezing - 1.0), max(melt.max(), freezing + 1.0)
        self.mappable = ScalarMappable(TwoSlopeNorm(freezing, low, high), shell_and_melt())
        ticks = ticks_around(low, freezing, high)
        self.title = title_of(temperature)
        self.bar = Bar(self.mappable, ticks=ticks, halves=("shell", "melt"))
        self.present = _roles_present(frames, BESIDE_THE_FLUID)

    def colours(self, fields: Fields) -> np.ndarray:
        """(n, 3) from 0 to 1."""
        position = self.mappable.norm(fields["temperature"])
        solid = fields["phase"] == Phase.SOLID
        position = np.where(solid, np.clip(position, 0.0, 0.499), np.clip(position, 0.501, 1.0))
        return _paint_roles(self.mappable.cmap(position)[:, :3], fields["role"], BESIDE_THE_FLUID)

    def patches(self) -> list[tuple[str, str]]:
        """(name, colour) of what the key shows beside the bar."""
        return [("mould" if role == Role.WALL else ROLE_NAMES[role], ROLE_COLOURS[role]) for role in self.present]


Look = CategoryLook | QuantityLook | StrandLook


def choose_look(result: ResultFile, field: str | None, frames: Frames) -> Look:
    """The look for ``field``; without one a strand where something has frozen, else temperature or speed.

    Raises:
        InputError: the file holds no field of this name.
    """
    if field is None:
        return _default_look(result.field_quantities, frames)
    values_of(frames[0][1], field)
    if field == "role":
        return CategoryLook("role", ROLE_NAMES, ROLE_COLOURS, frames)
    if field == "phase":
        names: Mapping[int, str] = {phase: phase.name.lower() for phase in Phase}
        return CategoryLook("phase", names, PHASE_COLOURS, frames, aside=BESIDE_THE_FLUID)
    if field == "material":
        materials = dict(enumerate(result.provenance.get("materials", ())))
        return CategoryLook("material", materials, dict(enumerate(MATERIAL_COLOURS)), frames)
    return QuantityLook(field, quantity_of(result.field_quantities, field), frames)


def _default_look(known: dict[str, Quantity], frames: Frames) -> Look:
    fields = frames[0][1]
    if "temperature" in fields:
        if all(any(len(_temperature(fields, solid)) for _, fields in frames) for solid in (True, False)):
            return StrandLook(known["temperature"], frames)
        temperatures = np.concatenate([fields["temperature"] for _, fields in frames])
        if len(temperatures) and np.ptp(temperatures) > 0.1:
            return QuantityLook("temperature", known["temperature"], frames)
    if "velocity" in fields:
        return QuantityLook("speed", quantity_of(known, "speed"), frames)
    return CategoryLook("role", ROLE_NAMES, ROLE_COLOURS, frames)


def _temperature(fields: Fields, solid: bool) -> np.ndarray:
    """Temperatures of the solid, or of the other, particles of the simulated material [K]."""
    chosen = (fields["phase"] == Phase.SOLID) == solid
    return fields["temperature"][chosen & ~np.isin(fields["role"], BESIDE_THE_FLUID)]


def _roles_present(frames: Frames, roles: Sequence[Role]) -> list[Role]:
    return [role for role in roles if any(np.any(fields["role"] == role) for _, fields in frames)]


def _by_label(labels: np.ndarray, colour_of: Mapping[int, str]) -> np.ndarray:
    present, places = np.unique(labels, return_inverse=True)
    table = np.array([to_rgb(colour_of.get(label, UNKNOWN)) for label in present.tolist()])
    return table.reshape(-1, 3)[places]


def _paint_roles(colours: np.ndarray, role: np.ndarray, roles: Sequence[Role]) -> np.ndarray:
    """Give the particles of ``roles`` the colour of their role."""
    beside = np.isin(role, roles)
    colours[beside] = _by_label(role[beside], ROLE_COLOURS)
    return colours
