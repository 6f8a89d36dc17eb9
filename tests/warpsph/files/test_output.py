"""The result file: what is written comes back, in VTK, in PyVista and in our reader, also after a kill."""

import signal
import subprocess
import sys

import h5py
import numpy as np
import pytest
import pyvista

from warpsph.errors import InputError, WarpsphError
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile

COUNTS = (0, 5, 3, 70_000, 4)


def frame(step: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """A frame of ``COUNTS[step]`` particles whose values tell the step and the particle."""
    n = COUNTS[step]
    random = np.random.default_rng(step)
    return random.random((n, 3), dtype="f4"), {
        "id": np.arange(n, dtype="i4") + 100_000 * step,
        "role": np.full(n, step % 3, "i4"),
        "velocity": random.random((n, 3), dtype="f4"),
        "temperature": random.random(n, dtype="f4"),
    }


@pytest.fixture
def path(tmp_path):
    """A file of five frames of which the first is empty."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(
        path, {"scenario": "made_up", "spacing": 0.004}, {"device": "cpu", "count": np.int64(3)}
    ) as writer:
        for step in range(len(COUNTS)):
            writer.write_frame(0.5 * step, *frame(step))
            writer.write_diagnostics(0.5 * step, {"level": 0.4 + step, "profile": np.arange(4.0) * step})
        writer.write_event(1.25, "breakout at 0.2 m, wall side ° 'quoted'")
        writer.finish(status="complete", wall_time=1.5)
    return path


def test_everything_comes_back(path):
    """If it failed, a result read again would differ from the one that was computed."""
    result = ResultFile(path)
    assert result.times.tolist() == [0.0, 0.5, 1.0, 1.5, 2.0]
    assert result.parameters == {"scenario": "made_up", "spacing": 0.004}
    assert result.provenance == {"status": "complete", "device": "cpu", "count": 3, "wall_time": 1.5}
    assert result.events == [(1.25, "breakout at 0.2 m, wall side ° 'quoted'")]
    assert result.diagnostics["time"].tolist() == result.times.tolist()
    assert result.diagnostics["level"].tolist() == [0.4, 1.4, 2.4, 3.4, 4.4]
    assert result.diagnostics["profile"].tolist() == [[0.0, step, 2.0 * step, 3.0 * step] for step in range(5)]
    for step in range(len(COUNTS)):
        points, fields = result.frame(step)
        expected_points, expected_fields = frame(step)
        np.testing.assert_array_equal(points, expected_points)
        assert set(fields) == set(expected_fields)
        for name, expected in expected_fields.items():
            np.testing.assert_array_equal(fields[name], expected)
            assert fields[name].dtype == expected.dtype


def test_nearest_frame_and_last_frame(path):
    """If it failed, a picture would show another moment than the one that was asked for."""
    result = ResultFile(path)
    assert [result.nearest(time) for time in (-9.0, 0.6, 0.8, 99.0)] == [0, 1, 2, 4]
    assert len(result.frame(-1)[0]) == COUNTS[-1]
    with pytest.raises(InputError, match="no frame 5; it holds 5 frames"):
        result.frame(5)


def test_vtk_and_pyvista_read_every_frame(path):
    """If it failed, ParaView would show nothing, or the particles of another frame."""
    reader = pyvista.get_reader(path)
    assert reader.reader.GetNumberOfSteps() == len(COUNTS)
    for step in (*range(len(COUNTS)), 1):
        reader.reader.SetStep(step)
        mesh = reader.read()
        expected_points, expected_fields = frame(step)
        np.testing.assert_array_equal(mesh.points, expected_points)
        if COUNTS[step]:
            assert mesh.verts.reshape(-1, 2)[:, 1].tolist() == list(range(COUNTS[step]))
        for name, expected in expected_fields.items():
            np.testing.assert_array_equal(mesh.point_data[name], expected)
        assert reader.reader.GetTimeValue() == pytest.approx(0.5 * step)


def test_existing_file_is_left_alone(path):
    """If it failed, a second run with the same name would destroy the first one's result."""
    before = path.read_bytes()
    with pytest.raises(InputError, match="exists already"):
        ResultWriter(path, {}, {})
    assert path.read_bytes() == before


def test_overwrite_replaces(path):
    """If it failed, ``--overwrite`` would mix an old result with a new one."""
    with ResultWriter(path, {"scenario": "second"}, {}, overwrite=True) as writer:
        writer.write_frame(0.0, *frame(1))
    result = ResultFile(path)
    assert result.parameters == {"scenario": "second"}
    assert result.provenance == {"status": "unfinished"}
    assert len(result.times) == 1


def test_failed_creation_leaves_nothing(path, monkeypatch):
    """If it failed, a run that cannot start would leave a broken file, or destroy the one that it should replace."""
    before = path.read_bytes()

    def full_disk(file):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("warpsph.files.output.create_layout", full_disk)
    for target in (path, path.with_name("new.vtkhdf")):
        with pytest.raises(WarpsphError, match="No space left on device"):
            ResultWriter(target, {}, {}, overwrite=True)
    assert path.read_bytes() == before
    assert list(path.parent.iterdir()) == [path]


def test_unusable_targets(tmp_path):
    """If it failed, a wrong output name would be found only after the run, or end in a traceback."""
    with pytest.raises(InputError, match="there is no folder"):
        ResultWriter(tmp_path / "missing" / "run.vtkhdf", {}, {})
    with pytest.raises(InputError, match="is a folder"):
        ResultWriter(tmp_path, {}, {}, overwrite=True)
    assert list(tmp_path.iterdir()) == []


def test_frame_after_a_failed_one_is_whole(tmp_path, monkeypatch):
    """If it failed, one failed write would shift the fields of all later frames against their positions."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        writer.write_frame(0.0, *frame(1))
        points, fields = frame(2)
        with monkeypatch.context() as patch:
            patch.setattr("warpsph.files.vtkhdf.TOPOLOGIES", ("Vertices", "missing"))
            with pytest.raises(KeyError):
                writer.write_frame(0.5, points, fields)
        writer.write_frame(1.0, *frame(4))
    result = ResultFile(path)
    assert result.times.tolist() == [0.0, 1.0]
    np.testing.assert_array_equal(result.frame(1)[0], frame(4)[0])
    np.testing.assert_array_equal(result.frame(1)[1]["id"], frame(4)[1]["id"])


def test_inconsistent_frames_are_refused(tmp_path):
    """If it failed, a field that is missing in one frame would be read from another frame's particles."""
    with ResultWriter(tmp_path / "run.vtkhdf", {}, {}) as writer:
        points, fields = frame(1)
        writer.write_frame(0.0, points, fields)
        without_id = {name: values for name, values in fields.items() if name != "id"}
        with pytest.raises(ValueError, match="rows of each of"):
            writer.write_frame(0.5, points, without_id)
        with pytest.raises(ValueError, match="rows of each of"):
            writer.write_frame(0.5, points[:-1], fields)


def test_diagnostics_that_come_and_go(tmp_path):
    """If it failed, what was not measured once would shift the later values to earlier times."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        writer.write_diagnostics(0.0, {"level": 1.0})
        writer.write_diagnostics(0.5, {"depth": 2.0, "profile": np.arange(3.0)})
        writer.write_diagnostics(1.0, {"level": 3.0, "depth": 4.0})
    diagnostics, nan = ResultFile(path).diagnostics, np.nan
    np.testing.assert_array_equal(diagnostics["time"], [0.0, 0.5, 1.0])
    np.testing.assert_array_equal(diagnostics["level"], [1.0, nan, 3.0])
    np.testing.assert_array_equal(diagnostics["depth"], [nan, 2.0, 4.0])
    np.testing.assert_array_equal(diagnostics["profile"], [[nan] * 3, [0.0, 1.0, 2.0], [nan] * 3])


def test_write_error_is_one_line(path, monkeypatch):
    """If it failed, a full disk in mid-run would end in a traceback."""
    with ResultWriter(path, {}, {}, overwrite=True) as writer:
        writer.write_frame(0.0, *frame(1))

        def full_disk(*arguments):
            raise OSError(28, "No space left on device")

        with monkeypatch.context() as patch:
            patch.setattr("warpsph.files.output.append_step", full_disk)
            with pytest.raises(WarpsphError, match=r"frames before this are safe.*No space left"):
                writer.write_frame(0.5, *frame(2))
    assert len(ResultFile(path).times) == 1


WRITE_UNTIL_KILLED = """
import sys
import numpy as np
from warpsph.files.output import ResultWriter

n = int(sys.argv[2])
with ResultWriter(sys.argv[1], {"scenario": "killed"}, {}) as writer:
    for step in range(1_000_000):
        points = np.full((n + step % 7, 3), step, "f4")
        writer.write_frame(float(step), points, {"id": np.full(len(points), step, "i4"), "velocity": points})
        writer.write_diagnostics(float(step), {"level": float(step), "profile": np.full(5, step)})
        writer.write_event(float(step), f"step {step}")
        if step == 5:
            print("writing", flush=True)
"""

# In a process of its own: VTK crashes on what it does not understand.
READ_BY_VTK = """
import sys
import pyvista

reader = pyvista.get_reader(sys.argv[1])
step, count = map(int, sys.argv[2:])
reader.reader.SetStep(step)
points = reader.read().points
sys.exit(int(points.shape != (count, 3) or (points != step).any()))
"""


@pytest.mark.parametrize(("count", "wait"), [(3, 0.05), (20_000, 0.1), (20_000, 0.23), (300_000, 0.17)])
def test_killed_run_leaves_a_readable_file(tmp_path, count, wait):
    """If it failed, the hours before a power cut, or before a batch system kills the run, would be lost."""
    path = tmp_path / "run.vtkhdf"
    writing = subprocess.Popen([sys.executable, "-c", WRITE_UNTIL_KILLED, path, str(count)], stdout=subprocess.PIPE)
    try:
        assert writing.stdout.readline() == b"writing\n"
        with pytest.raises(subprocess.TimeoutExpired):
            writing.wait(wait)
    finally:
        writing.send_signal(signal.SIGKILL)
        writing.communicate()
    result = ResultFile(path)
    assert len(result.times) >= 6
    assert result.provenance["status"] == "unfinished"
    for step, time in enumerate(result.times):
        points, fields = result.frame(step)
        assert time == step
        assert len(points) == len(fields["id"]) == count + step % 7
        assert np.all(points == step)
        assert np.all(fields["id"] == step)
        assert np.all(fields["velocity"] == step)
    assert np.all(result.diagnostics["level"] == result.diagnostics["time"])
    assert len(result.events) >= 6
    last = len(result.times) - 1
    subprocess.run([sys.executable, "-c", READ_BY_VTK, path, str(last), str(count + last % 7)], check=True)


def test_steps_that_are_not_whole_are_left_out(path):
    """If it failed, a file that was cut between two flushes would show particles without fields."""
    with h5py.File(path, "r+") as file:
        file["VTKHDF/PointData/temperature"].resize(70_000, axis=0)
        file["VTKHDF/Steps"].attrs.modify("NSteps", np.int64(9))
    assert ResultFile(path).times.tolist() == [0.0, 0.5, 1.0]
