"""The report of ``warpsph verify``: measured beside reference, as a table and as JSON."""

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rich.table import Table
from rich.text import Text

from warpsph.cases.check import Check
from warpsph.errors import InputError
from warpsph.files.beside import hidden_until_whole


def check_table(title: str, checks: Sequence[Check]) -> Table:
    """The checks of one case, a row each."""
    table = Table(title=title, title_justify="left", header_style="bold")
    table.add_column("quantity")
    for heading in ("measured", "reference", "unit", "error", "tolerance"):
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("source")
    table.add_column("passed", no_wrap=True)
    for check in checks:
        table.add_row(*(Text(cell) for cell in _cells(check)), _verdict(check))
    return table


def check_writable(path: Path) -> None:
    """Raise InputError where the JSON report could not be written, before hours are spent on its content."""
    if path.is_dir():
        raise InputError(f"--json '{path}': is a folder; give the name of a file")
    if not path.parent.is_dir():
        raise InputError(f"--json '{path}': there is no folder '{path.parent}'; make it first")


def write_json(checks: Sequence[Check], path: Path) -> None:
    """Write the rows as a JSON list; a number that is not finite becomes null.

    Raises:
        InputError: the file may not be written.
        WarpsphError: the disk is full or broken.
    """
    rows = [{key: _plain(value) for key, value in check.as_dict().items()} for check in checks]
    with hidden_until_whole(path) as hidden:
        hidden.write_text(json.dumps(rows, indent=2, allow_nan=False) + "\n")


def _cells(check: Check) -> list[str]:
    reference = "" if check.reference is None else f"{check.reference:.5g}"
    relative = check.relative and check.reference is not None
    error, tolerance = (f"{value:.2%}" if relative else f"{value:.2g}" for value in (check.error, check.tolerance))
    return [check.quantity, f"{check.measured:.5g}", reference, check.unit, error, tolerance, check.source]


def _verdict(check: Check) -> Text:
    return Text("yes", style="green") if check.passed else Text("NO", style="bold red")


def _plain(value: Any) -> Any:
    value = value.item() if hasattr(value, "item") else value
    return None if isinstance(value, float) and not math.isfinite(value) else value
