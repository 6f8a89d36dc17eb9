"""The reader: what is not a result file gives one line, never a traceback."""

import h5py
import numpy as np
import pytest

from warpsph.errors import InputError
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile


@pytest.fixture
def path(tmp_path):
    """A small, whole result file."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {"scenario": "made_up"}, {}) as writer:
        points = np.zeros((10, 3), "f4")
        for step in range(3):
            writer.write_frame(float(step), points, {"id": np.arange(10, dtype="i4")})
            writer.write_diagnostics(float(step), {"level": 1.0})
    return path


def refused(path) -> str:
    """The one line with which the reader refuses ``path``."""
    with pytest.raises(InputError) as caught:
        ResultFile(path)
    text = str(caught.value)
    assert str(path) in text
    assert "\n" not in text
    assert len(text) < len(str(path)) + 300
    return text


def test_missing_foreign_and_damaged_files(path, tmp_path):
    """If it failed, a mistyped file name would be answered with a traceback out of HDF5."""
    assert "no such file" in refused(tmp_path / "missing.vtkhdf")
    assert "is a folder" in refused(tmp_path)
    for name, content in {"empty": b"", "text": b"level,time\n0,1\n", "cut": path.read_bytes()[:2000]}.items():
        other = tmp_path / name
        other.write_bytes(content)
        assert "damaged or not a result file" in refused(other)
    foreign = tmp_path / "foreign.h5"
    with h5py.File(foreign, "w") as file:
        file["temperature"] = [1.0]
    assert "is not a result file of warpsph" in refused(foreign)


@pytest.mark.parametrize(
    "name",
    [
        "VTKHDF/Points",
        "VTKHDF/Steps",
        "VTKHDF/Steps/Values",
        "VTKHDF/PointData",
        "warpsph/parameters",
        "warpsph/provenance",
        "warpsph/diagnostics",
        "warpsph/diagnostics/time",
        "warpsph/events/text",
    ],
)
def test_missing_and_mistyped_parts(path, name):
    """If it failed, a file that another program has changed would end in a traceback."""
    with h5py.File(path, "r+") as file:
        del file[name]
    refused(path)
    with h5py.File(path, "r+") as file:
        file[name] = 3.0
    refused(path)


@pytest.mark.parametrize("text", ["", "{", "[1, 2]", "[" * 100_000, "nan"])
def test_parameters_that_are_no_table(path, text):
    """If it failed, damaged parameters would be taken for a case, or end in a traceback."""
    with h5py.File(path, "r+") as file:
        file["warpsph/parameters"][()] = text
    refused(path)


def test_absurd_counts_are_left_out(path):
    """If it failed, a damaged count would ask for more memory than there is."""
    with h5py.File(path, "r+") as file:
        file["VTKHDF/NumberOfPoints"][1] = 2**60
    assert ResultFile(path).times.tolist() == [0.0]


def test_random_damage_never_escapes(path):
    """If it failed, a file with some flipped bytes would end in a traceback instead of one line."""
    whole = bytearray(path.read_bytes())
    random = np.random.default_rng(1)
    refusals = several_lines = 0
    for _ in range(60):
        damaged = whole.copy()
        for place in random.integers(0, 6000, 20):
            damaged[place] = random.integers(256)
        path.write_bytes(damaged)
        try:
            result = ResultFile(path)
            for k in range(len(result.times)):
                result.frame(k)
        except InputError as error:
            refusals += 1
            several_lines += "\n" in str(error)
    assert refusals > 20
    assert several_lines == 0


def test_a_file_without_frames(tmp_path):
    """If it failed, a run that ended before its first frame could not even be asked what it was."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {"scenario": "made_up"}, {}) as writer:
        writer.write_event(0.0, "nothing to begin with")
    result = ResultFile(path)
    assert result.parameters["scenario"] == "made_up"
    assert len(result.times) == 0
    with pytest.raises(InputError, match="holds no frame"):
        result.nearest(0.0)


def test_a_running_simulation_can_be_read(tmp_path):
    """If it failed, one would have to wait for the end of a run before looking at it."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        writer.write_frame(0.0, np.zeros((4, 3), "f4"), {"id": np.arange(4, dtype="i4")})
        assert len(ResultFile(path).frame(0)[0]) == 4
