"""Every wrong input is one line on standard error, exit code 2, and nothing is written."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

WRONG = [
    (["fly"], "fly"),
    (["runn", "ingot"], "run"),
    (["run"], "NAME"),
    (["run", "ingott"], "did you mean 'ingot'"),
    (["describe", "zzz"], "allowed: ingot"),
    (["verify", "ingott"], "did you mean 'ingot'"),
    (["run", "ingot", "--untill", "1"], "--until"),
    (["run", "ingot", "--resume", "x"], "x: no such checkpoint"),
    (["run", "ingot", "--until", "abc"], "--until"),
    (["run", "ingot", "--until", "0"], "> 0"),
    (["run", "ingot", "--until", "-1"], "> 0"),
    (["run", "ingot", "--until", "nan"], "nan"),
    (["run", "ingot", "--until", "inf"], "inf"),
    (["run", "ingot", "--every", "1e300"], "--every"),
    (["run", "ingot", "--threads", "0"], ">= 1"),
    (["run", "ingot", "--threads", "1.5"], "--threads"),
    (["run", "ingot", "--threads", "100000"], "100000"),
    (["run", "ingot", "--device", "cpuu"], "cpuu"),
    (["run", "ingot", "--device", "cuda:99"], "cuda:99"),
    (["run", "ingot", "--set"], "--set"),
    (["run", "ingot", "--set", "count"], "KEY=VALUE"),
    (["run", "ingot", "--set", "=3"], "KEY=VALUE"),
    (["run", "ingot", "--set", "cuont=3"], "did you mean 'count'"),
    (["run", "ingot", "--set", "count=-3"], "count = -3"),
    (["run", "ingot", "--set", "count=2.5"], "count = 2.5"),
    (["run", "ingot", "--set", "spacing=abc"], "spacing = 'abc'"),
    (["run", "ingot", "--set", "spacing=1000"], "less than or equal to 1 [m]"),
    (["run", "ingot", "--set", "spacing=nan"], "finite"),
    (["run", "ingot", "--set", "spacing="], "spacing = ''"),
    (["run", "ingot", "--set", "wall=wood"], "'copper' or 'steel'"),
    (["run", "ingot", "--set", "oscillates=perhaps"], "oscillates = 'perhaps'"),
    (["run", "ingot", "--set", "zones=[1, x]"], "zones"),
    (["run", "ingot", "--set", "a.b=1"], "a.b"),
    (["run", "ingot", "--set", "duration=true"], "duration = True"),
    (["run", "ingot", "--set", "count=true"], "count = True"),
    (["run", "ingot", "--set", 'duration="1"'], "duration = '1'"),
    (["run", "ingot", "--set", "oscillates=1"], "oscillates = 1"),
    (["run", "ingot", "--set", "zones=[0.1, true]"], "zones.1 = True"),
    (["run", "ingot", "--set", "wall=\x1b[31m"], "wall = '\\x1b[31m'"),
    (["run", "ingot", "--set", "wall=\udc80"], "UTF-8"),
    (["run", "ingot", "--set", "x" * 10_000 + "=1"], "unknown parameter"),
    (["run", "ingot", "--set", "wall=" + "x" * 10_000], "'copper' or 'steel'"),
    (["run", "ingot", "--preset", "smal"], "did you mean 'small'"),
    (["run", "crooked", "--preset", "small"], "has no presets"),
    (["run", "ingot", "--preset", "broken"], "preset broken: ingot: count = 1000"),
    (["run", "ingot", "absent.toml"], "absent.toml"),
    (["run", "ingot", "."], "directory"),
    (["run", "ingot", "--output", "picture.png"], ".vtkhdf"),
    (["run", "ingot", "--output", "absent/file.vtkhdf"], "absent"),
    (["run", "ingot", "one.toml", "two.toml"], "two.toml"),
    (["render", "absent.vtkhdf"], "absent.vtkhdf"),
    (["render", "absent.vtkhdf", "--movie", "--time", "1"], "--movie"),
    (["render", "absent.vtkhdf", "--levels", "-1,1"], "absent.vtkhdf"),  # a number, not an option
    (["render", "absent.vtkhdf", "--time", "-1"], "--time"),
    (["render", "absent.vtkhdf", "--output", "picture.xyz"], ".png"),
    (["render", "absent.vtkhdf", "--cut", "w=1"], "--cut 'w=1'"),
    (["render", "absent.vtkhdf", "--cut", "z=deep"], "--cut 'z=deep'"),
    (["render", "absent.vtkhdf", "--movie", "--cut", "z=0.1"], "--cut"),
    (["plot", "absent.vtkhdf"], "absent.vtkhdf"),
    (["plot", "."], "folder"),
    (["info", "absent.vtkhdf"], "absent.vtkhdf"),
    (["info"], "FILE"),
    (["verify", "ingot", "--json", "absent/rows.json"], "absent"),
    (["verify", "ingot", "--json", "."], "folder"),
]


@pytest.mark.parametrize(
    ("words", "named"), WRONG, ids=lambda value: " ".join(value) if isinstance(value, list) else ""
)
def test_wrong_input_is_one_line(warpsph_command, tmp_path: Path, words: list[str], named: str):
    """If it failed, a user's slip would end in a traceback, pass unseen or leave a half-made file."""
    outcome = warpsph_command(*words)
    assert outcome.code == 2
    assert outcome.output == ""
    assert outcome.error.startswith("warpsph: ")
    assert outcome.error.count("\n") == 1
    assert named in outcome.error
    assert len(outcome.error) < 700
    assert outcome.error.rstrip("\n").isprintable()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("content", "named"),
    [
        (b"count = \n", "line 1"),
        (b"count = 1\ncount = 2\n", "overwrite"),
        (b"\xff\xfe", "UTF-8"),
        (b"cuont = 2\n", "did you mean 'count'"),
        (b"count = 0\n", "count = 0"),
        (b"[count]\nx = 1\n", "count"),
        (b"wall = 1979-05-27\n", "wall"),
        (b"spacing = " + b"[" * 5000 + b"]" * 5000, "case.toml"),
        (b"count = " + b"9" * 5000, "case.toml"),
        (b"duration = true\n", "duration = True"),
        (b"duration = '1'\n", "duration = '1'"),
        (b"spacing = '" + b"x" * 10_000 + b"'\n", "valid number"),
        (b'wall = "\\u001b[31m"\n', "'copper' or 'steel'"),
        (b"count = 1\0\n", "line 1"),
        (b"".join(b"k%d = 1\n" % k for k in range(5000)), "unknown parameter 'k0'"),
        (b"".join(b"k%d = 1\n" % k for k in range(1_000_000)), "larger than 100 kB"),
        (b"a" + b".a" * 40_000 + b" = 1\n", "more than 500 dots"),
    ],
    ids=lambda value: f"{value[:20]}",
)
def test_wrong_case_file_is_one_line_that_names_the_file(warpsph_command, tmp_path: Path, content: bytes, named: str):
    """If it failed, a slip in a case file would not be found by its file and key."""
    (tmp_path / "case.toml").write_bytes(content)
    outcome = warpsph_command("run", "ingot", "case.toml")
    assert outcome.code == 2
    assert outcome.error.startswith("warpsph: case.toml: ")
    assert outcome.error.count("\n") == 1
    assert named in outcome.error
    assert len(outcome.error) < 700
    assert outcome.error.rstrip("\n").isprintable()
    assert [path.name for path in tmp_path.iterdir()] == ["case.toml"]


def test_pipes_and_devices_are_no_case_files(warpsph_command, tmp_path: Path):
    """If it failed, a pipe that nobody writes to, or a device without an end, would hang the program."""
    os.mkfifo(tmp_path / "pipe.toml")
    for name in ("pipe.toml", "/dev/zero"):
        outcome = warpsph_command("run", "ingot", name)
        assert outcome.code == 2
        assert outcome.error.count("\n") == 1
        assert "not a regular file" in outcome.error


def test_wrong_device_is_one_line_of_the_whole_process(tmp_path: Path):
    """If it failed, messages of the libraries underneath would drown the one line that matters."""
    command = [sys.executable, "-m", "warpsph", "run", "heat_gaussian", "--device", "cuda:99"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("warpsph: device 'cuda:99'")
    assert done.stderr.count("\n") == 1


def test_error_between_parameters_names_the_layer_that_caused_it(warpsph_command, tmp_path: Path):
    """If it failed, a contradiction between two parameters would be blamed on the wrong place."""
    (tmp_path / "case.toml").write_text("spacing = 0.9\n")
    outcome = warpsph_command("run", "ingot", "case.toml", "--set", "count=100", "--until", "1")
    assert outcome.error == "warpsph: --set: ingot: count = 100: the row must be shorter than 50 m\n"


def test_existing_result_is_kept(warpsph_command, tmp_path: Path):
    """If it failed, a second run would silently destroy the first one's result."""
    target = tmp_path / "kept.vtkhdf"
    target.write_bytes(b"precious")
    outcome = warpsph_command("run", "ingot", "--output", "kept.vtkhdf")
    assert outcome.code == 2
    assert outcome.error.count("\n") == 1
    assert "--overwrite" in outcome.error
    assert target.read_bytes() == b"precious"


@pytest.mark.parametrize(
    "words", [["run", "ingot", "--overwrite"], ["render", "absent.vtkhdf", "--movie"]], ids=lambda words: words[0]
)
def test_a_folder_is_no_output(warpsph_command, tmp_path: Path, words: list[str]):
    """If it failed, a folder with the name of a file would be noticed only after everything has been computed."""
    name = "out.vtkhdf" if words[0] == "run" else "out.mp4"
    (tmp_path / name).mkdir()
    outcome = warpsph_command(*words, "--output", name)
    assert outcome.code == 2
    assert outcome.error == f"warpsph: --output '{name}': is a folder; give the name of a file\n"


def test_results_folder_that_cannot_be_made(warpsph_command, tmp_path: Path):
    """If it failed, a file called results would end the first run in a traceback."""
    (tmp_path / "results").write_text("a file")
    outcome = warpsph_command("run", "ingot")
    assert outcome.code == 2
    assert outcome.error.count("\n") == 1
    assert "results" in outcome.error


def test_damaged_result_is_one_line(warpsph_command, tmp_path: Path):
    """If it failed, a cut or foreign file would end info, plot and render in a traceback."""
    (tmp_path / "bad.vtkhdf").write_bytes(b"not HDF5")
    for command in ("info", "plot", "render"):
        outcome = warpsph_command(command, "bad.vtkhdf")
        assert outcome.code == 2
        assert outcome.error.count("\n") == 1
        assert "bad.vtkhdf" in outcome.error
