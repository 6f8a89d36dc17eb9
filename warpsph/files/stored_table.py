"""A table that stands in a result file as JSON: parameters, provenance."""

import json
from typing import Any

from warpsph.errors import cut, printable
from warpsph.files.guarded import GuardedFile

DEEPEST = 20  # tables and lists in one another
LONGEST_VALUE = 2000  # letters


def read_table(file: GuardedFile, path: str) -> dict[str, Any]:
    """The table, with texts as they may be printed.

    Raises:
        ValueError: it is no table, or lists stand in lists without an end.
    """
    values = json.loads(file.text(path), parse_int=_whole_number)
    if not isinstance(values, dict):
        raise ValueError(f"{path} holds no table")
    return _printable(values, path, DEEPEST)


def _printable(value: Any, path: str, depth: int) -> Any:
    if depth == 0:
        raise ValueError(f"{path} holds lists in lists, more than {DEEPEST} deep")
    if isinstance(value, dict):
        return {_printable(key, path, depth): _printable(item, path, depth - 1) for key, item in value.items()}
    if isinstance(value, list):
        return [_printable(item, path, depth - 1) for item in value]
    return cut(printable(value), LONGEST_VALUE) if isinstance(value, str) else value


def _whole_number(digits: str) -> int | float:
    """An integer, or the nearest number where it has more than 64 bits."""
    return int(digits) if len(digits) < 19 else float(digits)
