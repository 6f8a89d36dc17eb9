"""``warpsph run --dry-run`` says what a run would take, and draws its start."""

from pathlib import Path

import pytest

from warpsph.cli import main

WORDS = ("run", "heat_gaussian", "--set", "spacing=0.05", "--threads", "1", "--output", "plate.vtkhdf", "--dry-run")


def test_a_dry_run_says_what_the_run_would_take_and_draws_its_start(tmp_path, monkeypatch, capsys):
    """If it failed, a night would be spent on a case that is wrong at its start, or that takes a week."""
    monkeypatch.chdir(tmp_path)
    assert main(WORDS) == 0
    said = capsys.readouterr().out
    for words in ("400 free", "memory", "time step", "10 for 5 s", "wall time", "11 frames", "plate-start.png"):
        assert words in said
    assert [path.name for path in tmp_path.iterdir()] == ["plate-start.png"]
    assert Path("plate-start.png").read_bytes().startswith(b"\x89PNG")
    assert main(WORDS) == 2
    assert "exists already" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("setting", "named"), [("edge=10", "MB of memory"), ("output_interval=1e-9", "output_interval (--every)")]
)
def test_what_cannot_be_run_is_refused_in_a_dry_run_too(tmp_path, monkeypatch, capsys, setting: str, named: str):
    """If it failed, a dry run would promise what the run refuses."""
    monkeypatch.setattr("warpsph.core.capacity.free_memory", lambda: 1.0e7)
    monkeypatch.chdir(tmp_path)
    assert main((*WORDS, "--set", setting)) == 2
    error = capsys.readouterr().err
    assert named in error
    assert error.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
