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


def test_pictures_are_called_after_what_they_show(ingot, tmp_path: Path):
    """If it failed, the picture of one field or time would take the place of that of another."""
    for words in ([], ["--time", "0"], ["--field", "dye", "--time", "0"], ["--cut", "x=0.05"]):
        assert ingot("render", "ingot.vtkhdf", *words).code == 0
    drawn = {path.name for path in tmp_path.glob("*.png")}
    assert drawn == {"ingot.png", "ingot-0s.png", "ingot-dye-0s.png", "ingot-x=0.05.png"}


@pytest.mark.parametrize("words", [["render", "ingot.vtkhdf"], ["plot", "ingot.vtkhdf", "--output", "ingot.png"]])
def test_a_picture_is_replaced_only_when_asked(ingot, tmp_path: Path, words):
    """If it failed, a picture that somebody wanted to keep would be gone without a word."""
    (tmp_path / "ingot.png").write_text("dear to me")
    outcome = ingot(*words)
    assert outcome.code == 2
    assert "ingot.png: exists already; choose another name with --output, or give --overwrite" in outcome.error
    assert (tmp_path / "ingot.png").read_text() == "dear to me"
    assert ingot(*words, "--overwrite").code == 0
    assert imread(tmp_path / "ingot.png").min() < 0.5


def test_a_plane_has_no_depth_to_cut(ingot):
    """If it failed, a cut that changes nothing would be passed over in silence."""
    outcome = ingot("render", "ingot.vtkhdf", "--cut", "z=0.03")
    assert outcome.code == 2
    assert "two-dimensional" in outcome.error


def test_only_the_file_and_the_scenario_bound_times(ingot):
    """If it failed, frames of a run of weeks could not be drawn, nor its duration be given by an option."""
    outcome = ingot("render", "ingot.vtkhdf", "--time", "2e7")
    assert outcome.code == 2
    assert "--time 2e+07: ingot.vtkhdf holds 0 to " in outcome.error
    outcome = ingot("run", "ingot", "--until", "2e7")
    assert outcome.code == 2
    assert "ingot: duration = 20000000.0" in outcome.error
