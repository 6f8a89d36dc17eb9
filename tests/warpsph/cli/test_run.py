"""``warpsph run``: which values win, what is written, how it ends."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from warpsph.files.results import ResultFile


def test_default_preset_and_default_output(warpsph_command):
    """If it failed, the shortest command would run another case or hide its result."""
    outcome = warpsph_command("run", "ingot")
    assert outcome.code == 0
    result = ResultFile("results/ingot-small.vtkhdf")
    assert result.parameters["scenario"] == "ingot"
    assert (result.parameters["count"], result.parameters["duration"]) == (2, 0.5)
    assert "level" in outcome.output
    assert re.search(r"computed on +cpu, 2 threads", outcome.output)
    assert re.search(r"at 0\.5 s +the last drop froze", outcome.output)
    assert "warpsph render results/ingot-small.vtkhdf" in outcome.output


def test_precedence(warpsph_command, tmp_path: Path):
    """If it failed, a setting would lose against a weaker one: defaults < preset < case file < --set."""
    (tmp_path / "mine.toml").write_text("count = 5\nspacing = 0.02\n")
    words = ["run", "ingot", "mine.toml", "--preset", "small", "--set", "spacing=0.03", "wall=steel"]
    assert warpsph_command(*words).code == 0
    parameters = ResultFile("results/ingot-mine.vtkhdf").parameters
    assert parameters["wall"] == "steel"
    assert parameters["spacing"] == 0.03
    assert parameters["count"] == 5
    assert parameters["duration"] == 0.5
    assert parameters["output_interval"] == 0.1


def test_a_case_file_alone_starts_from_the_defaults(warpsph_command, tmp_path: Path):
    """If it failed, a case file would silently inherit values of the default preset."""
    (tmp_path / "mine.toml").write_text("spacing = 0.02\n")
    assert warpsph_command("run", "ingot", "mine.toml").code == 0
    parameters = ResultFile("results/ingot-mine.vtkhdf").parameters
    assert parameters["count"] == 3
    assert parameters["duration"] == 1.0


def test_a_case_file_may_begin_with_a_byte_order_mark(warpsph_command, tmp_path: Path):
    """If it failed, a case file that Windows' editors wrote would be refused for a letter that nobody sees."""
    (tmp_path / "mine.toml").write_bytes(b"\xef\xbb\xbfspacing = 0.02\n")
    assert warpsph_command("run", "ingot", "mine.toml").code == 0
    assert ResultFile("results/ingot-mine.vtkhdf").parameters["spacing"] == 0.02


@pytest.mark.parametrize(
    ("setting", "key", "value"),
    [
        ("zones=[0.5, 1]", "zones", [0.5, 1.0]),
        ("oscillates=false", "oscillates", False),
        ("wall=steel", "wall", "steel"),
        ("wall='steel'", "wall", "steel"),
        (" count = 7 ", "count", 7),
        ("spacing=.5", "spacing", 0.5),
        ("spacing=1e-3", "spacing", 1e-3),
    ],
)
def test_settings_are_toml_values_or_bare_words(warpsph_command, setting: str, key: str, value):
    """If it failed, a value would have to be quoted twice, or would arrive as text."""
    assert warpsph_command("run", "ingot", "--set", setting, "--output", "out.vtkhdf").code == 0
    assert ResultFile("out.vtkhdf").parameters[key] == value


def test_until_and_every_win(warpsph_command):
    """If it failed, --until and --every would be ignored where a preset sets the same parameters."""
    words = ["run", "ingot", "--until", "0.2", "--every", "0.05", "--set", "duration=3", "--output", "out.vtkhdf"]
    assert warpsph_command(*words).code == 0
    assert ResultFile("out.vtkhdf").times == pytest.approx([0.0, 0.05, 0.1, 0.15, 0.2])


def test_overwrite(warpsph_command, tmp_path: Path):
    """If it failed, --overwrite would not replace the file."""
    (tmp_path / "out.vtkhdf").write_bytes(b"old")
    assert warpsph_command("run", "ingot", "--output", "out.vtkhdf", "--overwrite").code == 0
    assert len(ResultFile("out.vtkhdf").times) == 6


def test_progress_on_a_pipe_is_plain_lines(warpsph_command):
    """If it failed, a log file would fill with control characters, or tell nothing."""
    error = warpsph_command("run", "ingot").error
    assert "\x1b" not in error
    assert error.splitlines()[-1].startswith("ingot 100%  0.500/0.5 s  100 steps/s")
    assert "level 0.400 m" in error


def test_device_and_threads_are_named_before_the_run(warpsph_command):
    """If it failed, nobody would know that hours are spent on the wrong device, or on one core of many."""
    error = warpsph_command("run", "ingot", "--device", "cpu", "--threads", "1").error
    assert error.splitlines()[0] == "ingot: computing on cpu, 1 thread"
    assert error.count("computing on") == 1


def test_quiet_says_nothing(warpsph_command):
    """If it failed, a script could not run the program silently."""
    outcome = warpsph_command("run", "ingot", "--quiet")
    assert (outcome.code, outcome.output, outcome.error) == (0, "", "")


def test_divergence_exits_3_and_keeps_the_frames(warpsph_command):
    """If it failed, a run that blew up would look like a wrong input, or lose what came before."""
    outcome = warpsph_command("run", "ingot", "--set", "ending=diverge", "--output", "out.vtkhdf", "--quiet")
    assert outcome.code == 3
    assert outcome.error == (
        "warpsph: particle 7 at (0.1, 0.2, 0) m: speed 1e9 m/s at 0.5 s\n"
        "  last good frame  the last one of out.vtkhdf\n"
    )
    assert len(ResultFile("out.vtkhdf").times) == 6


def test_interruption_exits_130_and_keeps_the_frames(warpsph_command):
    """If it failed, a script could not tell an interrupted run from a finished one."""
    outcome = warpsph_command("run", "ingot", "--set", "ending=interrupt", "--output", "out.vtkhdf")
    assert outcome.code == 130
    assert "interrupted" in outcome.output
    assert ResultFile("out.vtkhdf").provenance["status"] == "interrupted"


def test_the_command_to_go_on_names_a_result_whose_ending_is_in_capitals(warpsph_command):
    """If it failed, the command that is printed would look for a file that is not there."""
    outcome = warpsph_command("run", "ingot", "--set", "ending=interrupt", "--output", "OUT.VTKHDF")
    assert "--resume OUT.checkpoint --output OUT.VTKHDF\n" in outcome.output


def test_the_results_folder_is_made_when_it_is_named_too(warpsph_command):
    """If it failed, ``make run``, the first command that anybody tries, would fail in a fresh checkout."""
    assert warpsph_command("run", "ingot", "--output", "results/mine.vtkhdf").code == 0
    assert Path("results/mine.vtkhdf").is_file()


def test_a_name_that_no_file_system_takes_is_refused(warpsph_command):
    """If it failed, a long name would end in a traceback."""
    outcome = warpsph_command("run", "ingot", "--output", f"{'x' * 300}.vtkhdf")
    assert outcome.code == 2
    assert "too long" in outcome.error


@pytest.mark.parametrize("file", [".", "", "results"])
def test_a_folder_is_not_rendered(warpsph_command, file):
    """If it failed, a folder in place of a file would end in a traceback."""
    Path("results").mkdir()
    assert warpsph_command("render", file).code == 2


def test_the_name_of_a_field_may_not_be_a_path(warpsph_command):
    """If it failed, a slash in the name of a field would end in a traceback."""
    assert warpsph_command("run", "ingot").code == 0
    written = next(Path("results").glob("*.vtkhdf"))
    outcome = warpsph_command("render", str(written), "--field", "a/b")
    assert outcome.code == 2
    assert "no such field" in outcome.error


def test_divergence_is_told_in_one_plain_screen(tmp_path: Path):
    """If it failed, nobody would see in a log what broke, where to look, or what usually causes it."""
    words = ["run", "hydrostatic", "--set", "rows=10", "columns=6", "viscosity=0", "step_factor=10", "--threads", "1"]
    command = [sys.executable, "-m", "warpsph", *words, "--until", "2", "--output", "out.vtkhdf", "--quiet"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 3
    first, *facts = done.stderr.splitlines()
    assert re.match(r"warpsph: diverged at t = \S+ s: particle \d+ \(free, melt\) at \(.*\) m has .*, must be ", first)
    for name in ("when", "particle", "time step", "usual cause", "last good frame"):
        assert any(line.startswith(f"  {name}  ") for line in facts), done.stderr
    assert "\x1b" not in done.stderr
    assert re.search(r"by its limits, sound and viscosity \(7.6\): [5-9]\.\d+ of ", done.stderr)
    assert "frame 2 of out.vtkhdf, at t = 0.1 s\n" in done.stderr
