"""What a plot shows together: diagnostics that were declared for one panel, in the order of their declaration."""

from dataclasses import dataclass, field

from warpsph.files.results import ResultFile
from warpsph.pictures.units import printed, title_of


@dataclass
class Panel:
    """A title and the names of what stands under it: numbers over time, or one array."""

    title: str
    names: list[str] = field(default_factory=list)


def panels_of(result: ResultFile) -> list[Panel]:
    """First the panels of numbers, then those of arrays; what others are given over has none of its own."""
    axes = {"time", *(quantity.over for quantity in result.quantities.values())}
    curves: dict[tuple[str, ...], Panel] = {}
    maps = []
    for name, quantity in result.quantities.items():
        series = result.diagnostics[name]
        if name in axes or series.size == 0:
            continue
        if series.ndim == 1 and quantity.panel:
            shared = Panel(printed(quantity.panel, quantity.unit))
            curves.setdefault((quantity.panel, quantity.unit), shared).names.append(name)
        elif series.ndim == 1:
            curves[(name,)] = Panel(title_of(quantity), [name])
        elif series.ndim == 2:
            maps.append(Panel(title_of(quantity), [name]))
    return [*curves.values(), *maps]
