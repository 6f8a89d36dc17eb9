"""A run that is killed within any of its writes leaves a file of which all whole frames are read."""

import os
import warnings
from pathlib import Path

import numpy as np
import pytest

from warpsph.files import disk
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile

FRAMES = 3  # that are whole before the writes that are cut


def write_frame(writer: ResultWriter, step: int) -> None:
    """A frame of as many particles as tell it from the others, with a diagnostic and an event."""
    points = np.full((5 + step, 3), step, "f4")
    writer.write_frame(float(step), points, {"id": np.full(len(points), step, "i4")})
    writer.write_diagnostics(float(step), {"level": float(step)})
    writer.write_event(float(step), f"step {step}")


def written(path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[bytes, list[tuple[int, bytes | None]]]:
    """A file with whole frames, and the writes of one more and of the end: where, and what; None where it was cut."""
    writes: list[tuple[int, bytes | None]] = []
    write, truncate = disk._write, os.ftruncate

    def noted_write(descriptor: int, content, start: int) -> None:
        writes.append((start, bytes(content)))
        write(descriptor, content, start)

    def noted_truncate(descriptor: int, size: int) -> None:
        writes.append((size, None))
        truncate(descriptor, size)

    with ResultWriter(path, {"scenario": "killed"}, {"cpu": "x" * 3000}) as writer:
        for step in range(FRAMES):
            write_frame(writer, step)
        before = path.read_bytes()
        with monkeypatch.context() as patch:
            patch.setattr(disk, "_write", noted_write)
            patch.setattr(disk.os, "ftruncate", noted_truncate)
            write_frame(writer, FRAMES)
            writer.finish(status="complete")
    return before, writes


def applied(content: bytes, place: int, data: bytes | None) -> bytes:
    """The file after a write."""
    content = content.ljust(place, b"\0")
    return content[:place] if data is None else content[:place] + data + content[place + len(data) :]


def test_whole_frames_are_read_wherever_the_writing_ends(tmp_path: Path, monkeypatch):
    """If it failed, hours of a run would be lost because it was killed within its last bytes."""
    content, writes = written(tmp_path / "a.vtkhdf", monkeypatch)
    path, lost = tmp_path / "cut.vtkhdf", 0
    for place, data in writes:
        for part in (data[: len(data) // 2],) if data else ():
            path.write_bytes(applied(content, place, part))
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                result = ResultFile(path)
            lost += len(told)
            assert result.provenance["status"] in ("unfinished", "complete")
            assert len(result.times) in (FRAMES, FRAMES + 1)
            for step in range(len(result.times)):
                points, fields = result.frame(step)
                assert points.shape == (5 + step, 3)
                assert np.all(points == step)
                assert np.all(fields["id"] == step)
            assert np.all(result.diagnostics["level"] == result.diagnostics["time"])
            assert len(result.events) >= FRAMES
        content = applied(content, place, data)
    assert len(writes) > 30
    assert lost < 5


def test_what_is_lost_of_the_provenance_is_told(tmp_path: Path, monkeypatch):
    """If it failed, a file whose last text is damaged would be refused whole, or its loss would pass unseen."""
    path = tmp_path / "a.vtkhdf"
    with ResultWriter(path, {"scenario": "killed"}, {}) as writer:
        write_frame(writer, 0)

    def damaged(*arguments):
        raise OSError("bad heap index")

    good = ResultFile(path)
    monkeypatch.setattr(
        "warpsph.files.results.read_table", lambda file, name: damaged() if name.endswith("provenance") else {}
    )
    with pytest.warns(UserWarning, match="was killed while it wrote"):
        result = ResultFile(path)
    assert result.provenance == {"status": "unfinished"}
    assert result.times.tolist() == good.times.tolist()
