"""The pages of the manual as a reader meets them."""

import re
from pathlib import Path

import pytest

from warpsph.cli.catalogue import all_scenarios

ROOT = Path(__file__).parents[2]
PAGES = sorted([*(ROOT / "docs").rglob("*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md"])


@pytest.fixture(params=PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def page(request) -> str:
    return request.param.read_text()


def test_every_column_has_a_head(page):
    """If it failed, a reader would have to guess what a column of a table holds."""
    heads = re.findall(r"^(\|.*\|)\n\|[-|: ]+\|$", page, re.MULTILINE)
    empty = [head for head in heads if any(not cell.strip() for cell in head.strip("|").split("|"))]
    assert not empty


def test_every_picture_has_a_caption(page):
    """If it failed, a reader would not learn what a picture shows."""
    pictures = re.findall(r"^!\[.*\n\n(.*)", page, re.MULTILINE)
    assert all(after.startswith("*") and not after.startswith("**") for after in pictures), pictures


def test_two_commands_do_not_write_the_same_file(page):
    """If it failed, the second of two commands would be refused, because the first has written its file."""
    commands = re.findall(r"^(?: {4}|)(warpsph (?:run|render|plot) .*)$", page, re.MULTILINE)
    targets = [target for command in commands if (target := written(command.partition("#")[0].split()))]
    assert len(targets) == len(set(targets)), targets


def written(words: list[str]) -> tuple[str, ...]:
    """What decides on the name of the file that a command writes; empty where the command is continued elsewhere."""
    if "--output" in words:
        return ("to", words[words.index("--output") + 1])
    if words[-1] == "\\":
        return ()
    if words[1] == "run":
        preset = words[words.index("--preset") + 1] if "--preset" in words else "default"
        case = next((word for word in words[3:] if word.endswith(".toml")), preset)
        return ("run", words[2], case)
    return tuple(words)


def test_every_scenario_is_linked():
    """If it failed, a page about a scenario could be found by those only who know that it is there."""
    index, readme = (ROOT / "docs" / "index.md").read_text(), (ROOT / "README.md").read_text()
    pages = [path.name for path in (ROOT / "docs" / "scenarios").glob("*.md")]
    assert [name for name in pages if f"](scenarios/{name})" not in index] == []
    assert [name for name in all_scenarios() if f"| [`{name}`](docs/scenarios/{name}.md) |" not in readme] == []
