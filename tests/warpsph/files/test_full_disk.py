"""Disks that are full or broken: the file keeps its whole frames, and HDF5 lives."""

import errno
import itertools
import os
from pathlib import Path

import numpy as np
import pytest

from warpsph.errors import WarpsphError
from warpsph.files.beside import hidden_until_whole
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile

FRAMES = 6


def write(path: Path) -> None:
    """A file of some frames whose values tell the frame; the fourth is larger than the ones before."""
    with ResultWriter(path, {}, {}) as writer:
        for step in range(FRAMES):
            values = np.full((20_000 if step == 3 else 900, 3), step, "f4")
            writer.write_frame(float(step), values, {"velocity": values})
            writer.write_diagnostics(float(step), {"level": float(step)})
            writer.write_event(float(step), f"step {step}")
        writer.finish(status="complete")


def how_it_ends(path: Path) -> str:
    """The reason that the one line gives, "" where all is written."""
    try:
        write(path)
    except WarpsphError as error:
        return str(error).rpartition(": ")[2]
    return ""


class FailingWrites:
    """Stands in the place of ``os.pwrite`` and fails from a number of calls on, for so many calls."""

    def __init__(self, first: int, count: float, number: int) -> None:
        self.calls, self.first, self.count, self.number = 0, first, count, number
        self.really = os.pwrite

    def __call__(self, descriptor: int, content, start: int) -> int:
        self.calls += 1
        if self.first <= self.calls < self.first + self.count:
            raise OSError(self.number, os.strerror(self.number))
        return self.really(descriptor, content, start)


@pytest.mark.parametrize(("number", "count"), [(errno.ENOSPC, 1), (errno.EIO, 1)])
def test_any_write_may_fail(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, count: int):
    """If it failed, a full disk would end a run with HDF5's segmentation fault, or with an unreadable file."""
    path, ended_whole = tmp_path / "run.vtkhdf", False
    for first in itertools.chain(range(1, 40), range(40, 10_000, 37)):
        failing = FailingWrites(first, count, number)
        with monkeypatch.context() as patch:
            patch.setattr("warpsph.files.disk.os.pwrite", failing)
            ended = how_it_ends(path)
            assert ended in ("", os.strerror(number))
            ended_whole = failing.calls < first
        if path.exists():
            result = ResultFile(path)
            for k, time in enumerate(result.times):
                points, fields = result.frame(k)
                assert time == k
                assert (points == k).all()
                assert (fields["velocity"] == k).all()
                assert len(points) == (20_000 if k == 3 else 900)
            assert len(result.times) >= 1
            path.unlink()
        assert list(tmp_path.iterdir()) == []
        if ended_whole:
            break
    assert ended_whole


def write_many(writer: ResultWriter, values: np.ndarray) -> None:
    for step in range(1, 9):
        writer.write_frame(float(step), values, {"velocity": values})


def test_a_limit_of_size_keeps_the_frames_and_the_status(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """If it failed, a file on a full disk would not say why it ends where it ends."""
    path = tmp_path / "run.vtkhdf"
    really = os.pwrite

    def limited(descriptor: int, content, start: int) -> int:
        room = 1_500_000 - start
        if room <= 0:
            raise OSError(errno.EFBIG, os.strerror(errno.EFBIG))
        return really(descriptor, content[:room], start)

    monkeypatch.setattr("warpsph.files.disk.os.pwrite", limited)
    with ResultWriter(path, {}, {}) as writer:
        values = np.zeros((20_000, 3), "f4")
        writer.write_frame(0.0, values, {"velocity": values})
        with pytest.raises(WarpsphError, match="the frames before this are safe: File too large"):
            write_many(writer, values)
        writer.finish(status="failed")
    provenance = ResultFile(path).provenance
    assert provenance == {"status": "failed", "reason": "File too large"}
    assert len(ResultFile(path).times) >= 1


def test_what_is_not_whole_leaves_nothing(tmp_path: Path):
    """If it failed, a full disk would leave stumps of pictures, or destroy the picture that was there before."""
    path = tmp_path / "picture.png"
    path.write_text("before")
    with pytest.raises(WarpsphError, match=r"picture.png: cannot be written: No space left"), hidden_until_whole(path):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    assert path.read_text() == "before"
    assert list(tmp_path.iterdir()) == [path]
