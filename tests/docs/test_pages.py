"""The pages of the manual as a reader meets them."""

import re
import shlex
from itertools import pairwise
from pathlib import Path

import pytest

from warpsph.cases.case import preset_layer, resolve, settings_layer
from warpsph.cli.catalogue import all_scenarios, find_scenario
from warpsph.cli.run import RESULTS, default_path

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


def commands(page: str, kind: str) -> list[list[str]]:
    """The words of the commands of a kind on a page, those that go on in the next line as one."""
    lines = re.findall(rf"^(?: {{4}}|)(warpsph (?:{kind}) .*)$", page.replace("\\\n", " "), re.MULTILINE)
    return [shlex.split(line, comments=True) for line in lines]


def options(words: list[str], name: str) -> list[str]:
    """What a command gives for an option."""
    return [value for option, value in pairwise(words) if option == name]


def result_of(words: list[str]) -> Path:
    """The file that ``warpsph run`` writes."""
    if output := options(words, "--output"):
        return Path(output[0])
    case = next((Path(word) for word in words[3:] if word.endswith(".toml")), None)
    return default_path(find_scenario(words[2]), next(iter(options(words, "--preset")), None), case)


def test_two_commands_do_not_write_the_same_file(page):
    """If it failed, the second of two commands would be refused, because the first has written its file."""
    results = [str(result_of(words)) for words in commands(page, "run")]
    pictures = [" ".join(options(words, "--output") or words) for words in commands(page, "render|plot")]
    assert len(results + pictures) == len({*results, *pictures}), results + pictures


def test_what_is_read_has_been_written(page):
    """If it failed, a command that a reader copies would look for a file of another name than the one that is there."""
    here = {result_of(words) for words in commands(page, "run")}
    elsewhere = {result_of(words) for path in PAGES for words in commands(path.read_text(), "run")}
    known = here | {path for path in elsewhere if path.parent == RESULTS}
    assert [words for words in commands(page, "render|plot|info") if Path(words[2]) not in known] == []


def test_what_is_run_can_be_run(page):
    """If it failed, a command that a reader copies would name a preset or a parameter that there is not."""
    for words in commands(page, "run"):
        kind = find_scenario(words[2])
        layers = [preset_layer(kind, preset) for preset in options(words, "--preset")]
        assert resolve(kind, [*layers, settings_layer(options(words, "--set"))])


def test_every_scenario_is_linked():
    """If it failed, a page about a scenario could be found by those only who know that it is there."""
    index, readme = (ROOT / "docs" / "index.md").read_text(), (ROOT / "README.md").read_text()
    pages = [path.name for path in (ROOT / "docs" / "scenarios").glob("*.md")]
    assert [name for name in pages if f"](scenarios/{name})" not in index] == []
    assert [name for name in all_scenarios() if f"| [`{name}`](docs/scenarios/{name}.md) |" not in readme] == []
