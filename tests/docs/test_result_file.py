"""The page "What is in the file" beside the declarations of what is written."""

import re
from pathlib import Path

import pytest

import warpsph.terms
from warpsph.core.field import Field
from warpsph.core.labels import Phase, Role
from warpsph.core.motion import Motion
from warpsph.core.term import Term
from warpsph.files.results import ResultFile
from warpsph.scenarios.casting.casting import Casting
from warpsph.terms import PhaseChange

PAGE = (Path(__file__).parents[2] / "docs" / "result-file.md").read_text()


def table(heading: str) -> list[list[str]]:
    """The cells, without backticks, of the rows of all tables that begin with ``| heading |``."""
    places = [match.start() for match in re.finditer(rf"(?<=\n\n)\| {re.escape(heading)} \|", PAGE)]
    rows = [row for place in places for row in PAGE[place:].partition("\n\n")[0].splitlines()[2:]]
    return [[cell.strip().replace("`", "") for cell in row.strip("|").split("|")] for row in rows]


@pytest.fixture(scope="module")
def cast(tmp_path_factory) -> ResultFile:
    """The first moment of a casting."""
    path = tmp_path_factory.mktemp("cast") / "cast.vtkhdf"
    Casting(duration=1e-4, output_interval=1e-4).run(device="cpu", output=path)
    return ResultFile(path)


def test_fields(cast):
    """If it failed, somebody would look in vain for a field or its unit, or not learn that there is one."""
    terms = [kind for kind in vars(warpsph.terms).values() if isinstance(kind, type) and issubclass(kind, Term)]
    fields = [field for kind in (Motion, *terms) for field in vars(kind).values() if isinstance(field, Field)]
    declared = {(field.name, field.unit, field.label) for field in fields if field.written}
    assert {tuple(row[:3]) for row in table("field")} == declared
    in_cast = [row[0] for row in table("field") if row[0] in cast.field_quantities]
    assert in_cast == list(cast.field_quantities)


def test_codes():
    """If it failed, a mask by role or phase that follows the manual would choose other particles."""
    for kind in (Role, Phase):
        rows = table(f"`{kind.__name__.lower()}`")
        assert [(int(code), name) for code, name, _ in rows] == [(label, label.name.lower()) for label in kind]
    assert f"above a solid fraction of {PhaseChange().freeze_above:g}" in PAGE
    assert f"melts below {PhaseChange().melt_below:g}" in PAGE


def test_materials(cast):
    """If it failed, somebody who picks the rolls by number would get the nozzle."""
    assert [name for _, name, _ in table("`material`")] == cast.provenance["materials"]


def test_diagnostics(cast):
    """If it failed, a diagnostic would be missing from the manual, or stand there with a wrong unit or meaning."""
    found = {name: (unit, meaning.partition(", over")[0]) for name, unit, meaning in table("diagnostic")}
    expected = {
        name: (
            quantity.unit.removesuffix("/m") if quantity.unit in ("J/m", "kg/m") else quantity.unit,
            f"{quantity.panel}: {quantity.label}" if quantity.panel else quantity.label,
        )
        for name, quantity in cast.quantities.items()
    }
    assert found == expected


def test_provenance(cast):
    """If it failed, what made a file would be kept there, but nobody would know under which name."""
    missing = [name for name in cast.provenance if f"`{name}`" not in PAGE]
    assert not missing
