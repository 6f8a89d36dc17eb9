"""The command line in one process, with a miniature scenario package and an empty working folder."""

import importlib.util
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

import warpsph.cases.scenario
import warpsph.scenarios  # so that the real scenarios stay in the registry that the tests put aside
from warpsph.cli import main


@dataclass
class Outcome:
    """What one call of the command line left."""

    code: int
    output: str
    error: str


@pytest.fixture
def shop(monkeypatch: pytest.MonkeyPatch) -> None:
    """The miniature scenarios, and they alone, in the registry."""
    monkeypatch.setattr(warpsph.cases.scenario, "_registry", {})
    location = Path(__file__).parent / "shop" / "__init__.py"
    spec = importlib.util.spec_from_file_location("shop", location)
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, "shop", module)
    spec.loader.exec_module(module)


@pytest.fixture
def warpsph_command(
    shop: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[..., Outcome]:
    """Call the command line in an empty folder; takes its words and gives exit code, output and errors."""
    monkeypatch.chdir(tmp_path)

    def call(*words: str) -> Outcome:
        capsys.readouterr()
        code = main(list(words))
        captured = capsys.readouterr()
        return Outcome(code, captured.out, captured.err)

    return call
