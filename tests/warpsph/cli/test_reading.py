"""The commands that only read: list, describe, info, help."""

import subprocess
import sys
from importlib.metadata import version

import pytest

from warpsph.cli import main


def test_list(warpsph_command):
    """If it failed, a scenario or the source it reproduces would not be found."""
    lines = warpsph_command("list").output.splitlines()
    assert lines[0] == "ingot        A row of particles that cools  [Nobody 1900, section 1]"
    assert [line.split()[0] for line in lines] == ["ingot", "crooked", "diverging", "patient", "interrupted"]


def test_describe(warpsph_command):
    """If it failed, a parameter would stand without its unit, default, bounds or meaning."""
    outcome = warpsph_command("describe", "ingot")
    assert outcome.code == 0
    rows = outcome.output.splitlines()
    spacing = next(row for row in rows if "spacing" in row)
    for cell in ("m", "0.01", "> 0, <= 1", "distance between particles"):
        assert cell in spacing
    assert "copper | steel" in next(row for row in rows if "wall " in row)
    assert "true | false" in next(row for row in rows if "oscillates" in row)
    assert "[0.1, 0.2]" in next(row for row in rows if "zones" in row)
    assert "duration = 0.5, count = 2" in next(row for row in rows if "small (default)" in row)
    assert "Nobody 1900, section 1" in outcome.output


def test_info(warpsph_command):
    """If it failed, a file could not say what made it."""
    warpsph_command("run", "ingot", "--output", "out.vtkhdf")
    outcome = warpsph_command("info", "out.vtkhdf")
    assert outcome.code == 0
    text = " ".join(outcome.output.split())
    for part in (
        "scenario ingot",
        f"version {version('warpsph')}",
        "count 2",
        "device cpu",
        "threads 2",
        "status complete",
        "frames 6, from 0 to 0.5 s",
        "particles in the last 3",
        "level 0.4",
        "profile 3 values from 0 to 2",
        "0.5 s the last drop froze",
    ):
        assert part in text
    assert text.index("level 0.4") < text.index("profile 3 values")


@pytest.mark.parametrize("words", [[], ["--help"], ["run", "--help"], ["verify", "-h"]])
def test_help(capsys: pytest.CaptureFixture[str], words: list[str]):
    """If it failed, a newcomer who asks for help would get an error."""
    assert main(words) == 0
    assert "Usage: warpsph" in capsys.readouterr().out


def test_help_promises_only_what_exists(capsys: pytest.CaptureFixture[str]):
    """If it failed, the help would name a command or option that the program does not have."""
    main(["--help"])
    main(["run", "--help"])
    text = capsys.readouterr().out
    for absent in ("compare", "bench"):
        assert absent not in text


def test_version(capsys: pytest.CaptureFixture[str]):
    """If it failed, a report of a fault could not name the version."""
    assert main(["--version"]) == 0
    assert capsys.readouterr().out.strip() == f"warpsph {version('warpsph')}"


@pytest.mark.parametrize(
    ("words", "heavy"),
    [("--help", {"warp", "scipy", "pyvista", "vtk", "matplotlib"}), ("list", {"pyvista", "vtk", "matplotlib"})],
)
def test_start_is_light(words: str, heavy: set[str]):
    """If it failed, the help would wait seconds for Warp, or the list of scenarios for VTK, to load."""
    program = "import sys; from warpsph.cli import main; main(sys.argv[1:]); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", program, words], capture_output=True, text=True, check=True)
    assert not heavy & set(done.stdout.splitlines()[-1].split())


def test_module_is_the_command():
    """If it failed, ``python -m warpsph`` would not work where the script is not on the path."""
    done = subprocess.run([sys.executable, "-m", "warpsph", "fly"], capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
