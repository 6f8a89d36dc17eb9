"""What a run will take is said, and refused where it is too much, before anything is taken."""

from pathlib import Path

import numpy as np
import pytest

from warpsph.core import capacity
from warpsph.core.capacity import in_bytes
from warpsph.core.executor import Executor
from warpsph.core.footprint import bytes_each
from warpsph.core.particles import lattice, parked
from warpsph.errors import InputError
from warpsph.run.estimate import in_time
from warpsph.run.simulation import Simulation
from warpsph.scenarios import Cantilever, HeatGaussian, Hydrostatic

PLATE = HeatGaussian(spacing=0.05)


@pytest.fixture
def plate() -> Simulation:
    return PLATE.build(Executor("cpu", 1))


def test_more_particles_than_memory_are_refused_before_they_are_placed(monkeypatch: pytest.MonkeyPatch):
    """If it failed, a slip in the spacing would take all memory of the machine, and end by its system's hand."""
    monkeypatch.setattr(capacity, "free_memory", lambda: 1.0e9)
    for place in (lambda: lattice((0.0, 0.0), (10.0, 10.0), 1e-3), lambda: parked((0.0, 0.0, 0.0), 1e18)):
        with pytest.raises(InputError, match="B of memory are needed and 1 GB are free"):
            place()


def test_a_simulation_that_does_not_fit_is_refused(monkeypatch: pytest.MonkeyPatch):
    """If it failed, fields and lists would be allocated for more particles than the memory holds."""
    monkeypatch.setattr("warpsph.core.footprint.free_memory", lambda: 1.0e4)
    with pytest.raises(InputError, match=r"400 particles: .* kB of memory are needed and 10 kB are free"):
        PLATE.build(Executor("cpu", 1))


@pytest.mark.parametrize("case", [PLATE, Hydrostatic(rows=20), Cantilever(layers=4)], ids=lambda case: case.name)
def test_the_memory_that_is_reckoned_is_what_is_taken(case):
    """If it failed, a case would be refused that fits, or taken that does not."""
    simulation = case.build(Executor("cpu", 1))
    estimate = simulation.estimate(simulation.schedule(case.duration, case.output_interval))
    beside = 4.0 * len(simulation.state.start) + 1e4  # cells of the grid, and what is not one entry a particle
    reckoned = simulation.state.count * bytes_each(simulation.model)[0]
    assert reckoned <= estimate.memory * 1.02
    assert estimate.memory <= 1.02 * reckoned + 2.0 * beside


def test_steps_frames_and_disk_are_those_of_the_run(plate: Simulation, tmp_path: Path):
    """If it failed, a dry run would promise another run than the one that follows."""
    estimate = plate.estimate(plate.schedule(3.1, 0.25))
    output = tmp_path / "plate.vtkhdf"
    result = plate.run(3.1, 0.25, output=output)
    assert (estimate.steps, estimate.frames) == (result.steps, len(result.diagnostics["time"]))
    assert estimate.particles == {"free": 400}
    assert 0.5 * estimate.disk < output.stat().st_size < 2.0 * estimate.disk + 2e6  # HDF5 takes whole chunks


@pytest.mark.parametrize(
    ("duration", "interval", "words"),
    [
        (1e-15, 0.5, "less than a millionth of a step"),
        (1e4, 1e-9, "years or more"),
        (1e4, 1e-30, "shorter one, or longer steps"),
        (1e4, 1e-45, "too short for single precision"),
    ],
)
def test_a_run_without_an_end_or_a_step_is_refused(plate: Simulation, duration: float, interval: float, words: str):
    """If it failed, a run would never end, or end without a step and with a file of nothing."""
    with pytest.raises(InputError, match=words):
        plate.run(duration, interval)


def test_a_full_disk_is_foreseen(plate: Simulation, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """If it failed, a night's run would end in the middle of a frame."""
    monkeypatch.setattr("shutil.disk_usage", lambda folder: type("Usage", (), {"free": 1e5}))
    with pytest.raises(InputError, match=r"frames need .* of disk and 100 kB are free"):
        plate.run(5.0, 0.01, output=tmp_path / "plate.vtkhdf")
    assert list(tmp_path.iterdir()) == []


def test_the_disk_that_counts_is_that_of_the_file_behind_a_link(plate: Simulation, tmp_path: Path, monkeypatch):
    """If it failed, a link from a small disk to a large one would be refused, and the other way round be taken."""
    (tmp_path / "large").mkdir()
    (tmp_path / "plate.vtkhdf").symlink_to("large/plate.vtkhdf")
    looked = []

    def usage(folder):
        looked.append(Path(folder))
        return type("Usage", (), {"free": 1e5})

    monkeypatch.setattr("shutil.disk_usage", usage)
    with pytest.raises(InputError, match=r"frames need .* of disk and 100 kB are free"):
        plate.run(5.0, 0.01, output=tmp_path / "plate.vtkhdf")
    assert looked == [tmp_path.resolve() / "large"]


def test_a_look_at_the_start_leaves_the_run_as_it_is(tmp_path: Path):
    """If it failed, what is drawn as the start would not be where the run begins."""
    fields = []
    for looks in (False, True):
        simulation = PLATE.build(Executor("cpu", 1))
        schedule = simulation.schedule(1.0, 0.5)
        if looks:
            simulation.write_start(schedule, tmp_path / "start.vtkhdf", {})
        fields.append(simulation.run(1.0, 0.5).fields["temperature"])
    assert np.array_equal(*fields)


def test_sizes_and_times_are_said_in_people_s_units():
    """If it failed, a refusal would speak of 3.1e+16 bytes or 9.5e+07 s."""
    assert [in_bytes(size) for size in (12, 4.2e7, 3.1e16)] == ["12 bytes", "42 MB", "31 PB"]
    assert [in_time(time) for time in (9.0, 7200.0, 9.5e7)] == ["9 s", "2 hours", "3.01 years"]
