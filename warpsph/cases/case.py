"""A case: the parameters of a scenario, gathered from its defaults, a preset, a case file and single settings."""

import re
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from sys import modules
from typing import Any, TypeVar

from warpsph.cases.scenario import Scenario
from warpsph.errors import InputError, shown
from warpsph.nearest import did_you_mean

LONGEST_FILE = 100_000  # bytes; the longest preset has a hundredth
MOST_DOTS = 500  # in a line; keys of many dots would take minutes to read
BARE_NUMBER = re.compile(r"[+-]?(\d+\.|\.\d+)([eE][+-]?\d+)?", re.ASCII)  # 1. and .5, which TOML does not know

Kind = TypeVar("Kind", bound=Scenario)


@dataclass(frozen=True)
class Layer:
    """Parameter values and where they come from; a later layer overrides an earlier one."""

    origin: str
    values: dict[str, Any]


def preset_layer(scenario: type[Scenario], preset: str) -> Layer:
    """The values of a preset: ``presets/<scenario>/<preset>.toml`` in the package that defines the scenario."""
    if preset not in scenario.presets:
        allowed = did_you_mean(preset, scenario.presets) if scenario.presets else "; it has no presets"
        raise InputError(f"{scenario.name}: unknown preset '{preset}'{allowed}")
    package = modules[scenario.__module__].__package__
    resource = files(str(package)) / "presets" / scenario.name / f"{preset}.toml"
    return Layer(f"preset {preset}", _parse_toml(resource.read_bytes(), f"preset {preset}"))


def file_layer(path: Path) -> Layer:
    """The values of a case file."""
    try:
        reason = "is a directory" if path.is_dir() else "not a regular file"
        if path.exists() and not path.is_file():  # a pipe may never end, and a device has no end
            raise ValueError(reason)
        with path.open("rb") as file:
            content = file.read(LONGEST_FILE + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"case file '{path}' cannot be read: {reason}; give a TOML file of parameters") from None
    if len(content) > LONGEST_FILE:
        raise InputError(f"{path}: is larger than {LONGEST_FILE // 1000} kB; give a TOML file of parameters")
    return Layer(str(path), _parse_toml(content, str(path)))


def settings_layer(settings: Iterable[str], origin: str = "--set") -> Layer:
    """The values of ``KEY=VALUE`` settings; a value is TOML, and a bare word stands for itself."""
    values = {}
    for setting in settings:
        key, equals, value = setting.partition("=")
        if not (equals and key.strip()):
            raise InputError(f"{origin} {shown(setting)}: expected KEY=VALUE, for example duration=2.5")
        if not _is_text(setting):
            raise InputError(f"{origin} {shown(setting)}: is not text in UTF-8")
        values[key.strip()] = _parse_value(value.strip())
    return Layer(origin, values)


def resolve(scenario: type[Kind], layers: Sequence[Layer]) -> Kind:
    """The scenario with the values of all layers, the last layer first in rank.

    Raises:
        InputError: a key is unknown or a value is out of bounds; the text begins with the layer that brought it in.
    """
    values: dict[str, Any] = {}
    for layer in layers:
        values |= layer.values
    try:
        return scenario(**values)
    except InputError as error:
        raise InputError(f"{_culprit(scenario, layers, str(error))}{error}") from None


def _culprit(scenario: type[Scenario], layers: Sequence[Layer], message: str) -> str:
    values: dict[str, Any] = {}
    for layer in layers:
        values |= layer.values
        try:
            scenario(**values)
        except InputError as error:
            if str(error) == message:
                return f"{layer.origin}: "
    return ""


def _parse_toml(content: bytes, origin: str) -> dict[str, Any]:
    try:
        return _load_toml(content.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise InputError(f"{origin}: not a text file in UTF-8; give a TOML file of parameters") from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"{origin}: not valid TOML: {error}") from None


def _parse_value(text: str) -> Any:
    if BARE_NUMBER.fullmatch(text):
        return float(text)
    try:
        document = _load_toml(f"value = {text}")
    except (ValueError, RecursionError):
        return text
    return document["value"] if document.keys() == {"value"} else text


def _load_toml(text: str) -> dict[str, Any]:
    if any(line.count(".") > MOST_DOTS for line in text.split("\n")):
        raise ValueError(f"a line has more than {MOST_DOTS} dots")
    document = tomllib.loads(text)
    if _has_large_integer(document):
        raise ValueError("an integer has more than 64 bits")
    return document


def _is_text(text: str) -> bool:
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def _has_large_integer(value: Any) -> bool:
    """TOML integers have 64 bits; Python reads longer ones, but cannot always print them."""
    if isinstance(value, dict | list):
        return any(_has_large_integer(item) for item in (value.values() if isinstance(value, dict) else value))
    return isinstance(value, int) and not -(2**63) <= value < 2**63
