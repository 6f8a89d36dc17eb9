"""Result files that are wrong in every way we know: one line or a sensible reading, soon, in little memory."""

import os
import resource
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from mutations import DRAWN, HUGE, REFUSED, good_file, mutated

from warpsph.cli import main
from warpsph.errors import InputError
from warpsph.files.particles import read_particles
from warpsph.files.results import ResultFile

READ = DRAWN | REFUSED
PICTURED = ("some places are no numbers", "one place", "role -1")
PLOTTED = ("escape codes", "huge diagnostics")
ALL = bool(os.environ.get("WARPSPH_CAMPAIGN"))


def told(capsys: pytest.CaptureFixture[str], *words: str) -> int:
    """The exit code of a command, which is 0 or 2, the latter with one line, and nothing that steers a terminal."""
    code = main(words)
    captured = capsys.readouterr()
    assert code in (0, 2)
    assert captured.err.count("\n") <= 1
    assert "\n" in captured.err or code == 0
    assert (captured.out + captured.err).replace("\n", "").isprintable()
    return code


def all_of(path: Path) -> int:
    """Number of particles in a file of which everything is read."""
    result = ResultFile(path)
    return sum(len(result.frame(k)[0]) for k in range(len(result.times)))


@pytest.mark.parametrize("name", READ)
def test_wrong_files_are_refused_or_read(tmp_path: Path, capsys, name: str):
    """If it failed, a damaged file would end in a traceback, hang at a pipe, or write to the terminal what it likes."""
    path = mutated(tmp_path / "a.vtkhdf", READ[name])
    if name in REFUSED:
        with pytest.raises(InputError, match=r"a\.vtkhdf"):
            all_of(path)
        with pytest.raises(InputError, match=r"a\.vtkhdf"):
            read_particles(path, 2)
    else:
        assert all_of(path) == 36
        with suppress(InputError):  # some of these places and names no simulation can start with
            assert len(read_particles(path, 2)["position"]) == 12
    assert told(capsys, "info", str(path)) == (2 if name in REFUSED else 0)


@pytest.mark.parametrize("name", READ if ALL else PICTURED)
def test_wrong_files_are_drawn_or_refused(tmp_path: Path, capsys, name: str):
    """If it failed, a picture of a damaged file would end in a traceback, or take all memory for a distant particle."""
    path = mutated(tmp_path / "a.vtkhdf", READ[name])
    code = told(capsys, "render", str(path), "--levels", "350", "--overwrite")
    assert (code == 0) == (tmp_path / "a-levels.png").exists()
    assert code == 0 or ALL


@pytest.mark.parametrize("name", READ if ALL else PLOTTED)
def test_diagnostics_of_wrong_files_are_plotted_or_refused(tmp_path: Path, capsys, name: str):
    """If it failed, odd series would end a plot in a traceback, or hundreds of them would take minutes."""
    path = mutated(tmp_path / "a.vtkhdf", READ[name])
    code = told(capsys, "plot", str(path))
    assert (code == 0) == (tmp_path / "a-diagnostics.png").exists()
    assert code == 0 or ALL


READ_ALL = """
import sys
from warpsph.errors import InputError
from warpsph.files.results import ResultFile
for path in sys.argv[1:]:
    try:
        result = ResultFile(path)
        for k in range(len(result.times)):
            result.frame(k)
    except InputError as error:
        print("refused", error)
    else:
        print("read", path)
"""
MEMORY = 2 * 2**30  # bytes of addresses: the libraries take the half


def test_huge_claims_take_no_memory(tmp_path: Path):
    """If it failed, a file of a megabyte could take all memory of a machine."""
    paths = [mutated(tmp_path / f"{k}.vtkhdf", mutation) for k, mutation in enumerate(HUGE.values())]
    assert max(path.stat().st_size for path in paths) < 16e6
    done = subprocess.run(
        [sys.executable, "-c", READ_ALL, *map(str, paths)],
        capture_output=True,
        text=True,
        timeout=120,
        env=os.environ | {"OPENBLAS_NUM_THREADS": "1"},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)),
    )
    assert done.stderr == ""
    assert [line.split()[0] for line in done.stdout.splitlines()] == ["refused"] * len(HUGE)
    assert done.stdout.count("more than there can be in it") == len(HUGE)


def test_a_compressed_file_is_read(tmp_path: Path):
    """If it failed, the guard against compressed zeros would refuse files that were packed to save space."""
    import h5py

    good_file(tmp_path / "a.vtkhdf")
    with h5py.File(tmp_path / "a.vtkhdf", "r+") as file:
        points = file["VTKHDF/Points"][:]
        del file["VTKHDF/Points"]
        file.create_dataset("VTKHDF/Points", data=points, chunks=True, compression="gzip", shuffle=True)
    assert all_of(tmp_path / "a.vtkhdf") == 36
