"""``warpsph render`` and ``warpsph plot``: what they draw and where they put it."""

from pathlib import Path

import pytest
from matplotlib.image import imread

from warpsph.pictures import graphics


@pytest.fixture
def ingot(warpsph_command, monkeypatch: pytest.MonkeyPatch):
    """The command line beside a result file, ``ingot.vtkhdf``; pictures are drawn in the simpler way."""
    monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    assert warpsph_command("run", "ingot", "--output", "ingot.vtkhdf").code == 0
    return warpsph_command


def test_a_field_of_the_scenario_can_be_drawn(ingot, tmp_path: Path):
    """If it failed, what a scenario adds to its frames could not be looked at from the command line."""
    outcome = ingot("render", "ingot.vtkhdf", "--field", "dye")
    assert (outcome.code, outcome.output) == (0, "written: ingot-dye.png\n")
    assert imread(tmp_path / "ingot-dye.png").min() < 0.5


def test_wrong_field_names_those_of_the_file(ingot):
    """If it failed, nobody would learn which fields there are to draw."""
    outcome = ingot("render", "ingot.vtkhdf", "--field", "die")
    assert outcome.code == 2
    assert "did you mean 'dye'" in outcome.error


def test_diagnostics_are_drawn_beside_the_file(ingot, tmp_path: Path):
    """If it failed, the diagnostics of a run could not be seen from the command line."""
    outcome = ingot("plot", "ingot.vtkhdf")
    assert (outcome.code, outcome.output) == (0, "written: ingot-diagnostics.png\n")
    assert imread(tmp_path / "ingot-diagnostics.png").min() < 0.5
