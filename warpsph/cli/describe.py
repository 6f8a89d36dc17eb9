"""``warpsph describe``."""

from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo
from rich.table import Table
from rich.text import Text

from warpsph.cases.case import preset_layer
from warpsph.cases.scenario import Scenario, unit_of
from warpsph.cli.catalogue import find_scenario
from warpsph.cli.consoles import output_console

_BOUNDS = {"gt": ">", "ge": ">=", "lt": "<", "le": "<="}


def describe(name: str, /) -> None:
    """Describe a scenario: its parameters with unit, default, bounds and meaning, its presets and its source.

    Parameters
    ----------
    name
        A scenario of `warpsph list`.
    """
    scenario = find_scenario(name)
    console = output_console()
    console.print(Text(f"{scenario.name}: {scenario.summary}", style="bold"))
    console.print(Text(f"Source: {scenario.source}"))
    console.print(_parameters(scenario))
    if scenario.presets:
        console.print(_presets(scenario))
    console.print(Text(f"Run it with: warpsph run {scenario.name}" + _preset_hint(scenario), style="dim"))


def _parameters(scenario: type[Scenario]) -> Table:
    table = Table(title="Parameters", title_justify="left", header_style="bold")
    table.add_column("parameter", style="cyan", no_wrap=True)
    table.add_column("unit", no_wrap=True)
    for heading in ("default", "bounds", "meaning"):
        table.add_column(heading)
    changeable = scenario.changeable()
    for key, field in scenario.model_fields.items():
        meaning = f"{field.description}{' (may change when a run is resumed)' if key in changeable else ''}"
        cells = (key, unit_of(field), show_value(field.default), _bounds(field), meaning)
        table.add_row(*(Text(cell) for cell in cells))
    return table


def _presets(scenario: type[Scenario]) -> Table:
    table = Table(title="Presets", title_justify="left", header_style="bold")
    table.add_column("preset", style="cyan", no_wrap=True)
    table.add_column("sets")
    for preset in scenario.presets:
        values = preset_layer(scenario, preset).values
        label = f"{preset} (default)" if preset == scenario.default_preset else preset
        table.add_row(label, Text(", ".join(f"{key} = {show_value(value)}" for key, value in values.items())))
    return table


def _preset_hint(scenario: type[Scenario]) -> str:
    return f" --preset {scenario.presets[0]}" if scenario.presets else ""


def show_value(value: Any) -> str:
    """A parameter's value as it is written after ``--set``."""
    if value is None or isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(show_value(item) for item in value)}]"
    return str(value)


def _bounds(field: FieldInfo) -> str:
    if get_origin(field.annotation) is Literal:
        return " | ".join(str(choice) for choice in get_args(field.annotation))
    if field.annotation is bool:
        return "true | false"
    found = [(sign, getattr(item, name, None)) for item in field.metadata for name, sign in _BOUNDS.items()]
    return ", ".join(f"{sign} {show_value(bound)}" for sign, bound in found if bound is not None)
