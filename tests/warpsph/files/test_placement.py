"""Two runs on one output, links, and what killed runs leave."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from warpsph.errors import InputError, WarpsphError
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile


def write_a_frame(writer: ResultWriter) -> None:
    writer.write_frame(0.0, np.zeros((3, 3), "f4"), {"id": np.arange(3, dtype="i4")})


@pytest.mark.parametrize("overwrite", [False, True])
def test_a_file_that_a_run_writes_is_left_alone(tmp_path: Path, overwrite: bool):
    """If it failed, of two runs on one output one would lose its result, without a word."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        for appeared in (False, True):
            assert path.exists() == appeared
            with pytest.raises(InputError, match="another run is writing it"):
                ResultWriter(path, {}, {}, overwrite=overwrite)
            write_a_frame(writer)
    assert len(ResultFile(path).times) == 2
    with ResultWriter(path, {}, {}, overwrite=True) as writer:
        write_a_frame(writer)
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_that_appears_meanwhile_is_not_replaced(tmp_path: Path):
    """If it failed, a run would destroy what another program has put there since it began."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        path.write_text("mine")
        with pytest.raises(InputError, match="exists already"):
            write_a_frame(writer)
    assert path.read_text() == "mine"
    assert list(tmp_path.iterdir()) == [path]


def test_a_removed_file_is_told(tmp_path: Path):
    """If it failed, a run would go on for hours and write where nobody can read."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        write_a_frame(writer)
        path.unlink()
        with pytest.raises(WarpsphError, match="was removed or replaced"):
            write_a_frame(writer)


def test_a_link_stays_a_link(tmp_path: Path):
    """If it failed, a result meant for a large disk would fill the small one, and the link would be gone."""
    (tmp_path / "large").mkdir()
    link, target = tmp_path / "run.vtkhdf", tmp_path / "large" / "target.vtkhdf"
    link.symlink_to(target)
    with ResultWriter(link, {}, {}) as writer:
        write_a_frame(writer)
    assert link.is_symlink()
    assert len(ResultFile(target).times) == 1
    with pytest.raises(InputError, match="exists already"):
        ResultWriter(link, {}, {})


KILLED = """
import os, signal, sys
from warpsph.files.output import ResultWriter
writer = ResultWriter(sys.argv[1], {}, {})
os.kill(os.getpid(), signal.SIGKILL)
"""


def test_a_killed_run_stands_in_nobodys_way(tmp_path: Path):
    """If it failed, a run killed before its first frame would leave an unreadable file or block the next one."""
    path = tmp_path / f"{'long' * 60}.vtkhdf"
    subprocess.run([sys.executable, "-c", KILLED, path], check=False)
    assert not path.exists()
    assert len(list(tmp_path.iterdir())) == 2
    with ResultWriter(path, {}, {}) as writer:
        write_a_frame(writer)
    assert list(tmp_path.iterdir()) == [path]
