"""A run that is resumed from its checkpoint has the bits of one that was never stopped."""

import pickle
import shutil
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from warpsph.core.executor import available_cores
from warpsph.errors import InputError, WarpsphError
from warpsph.files.checkpoint import Checkpoint, beside, previous
from warpsph.files.results import ResultFile
from warpsph.run.result import Result
from warpsph.scenarios import Casting, HeatGaussian

SMALL_HEAT = {"spacing": 0.04, "duration": 2.0, "output_interval": 0.5}


def run(case, output: Path, duration: float, device: str = "cpu", threads: int = 1, **options) -> Result:
    return case.run(device, threads, duration=duration, output=output, **options)


def different(one: Path, two: Path) -> list[str]:
    """What two result files do not have in common, to the bit."""
    a, b = ResultFile(one), ResultFile(two)
    found = [] if a.times.tobytes() == b.times.tobytes() else [f"times {a.times} {b.times}"]
    found += [] if a.events == b.events else ["events"]
    names = a.diagnostics.keys() | b.diagnostics.keys()
    found += [name for name in names if a.diagnostics[name].tobytes() != b.diagnostics[name].tobytes()]
    for k in range(min(len(a.times), len(b.times))):
        (points, fields), (others, other_fields) = a.frame(k), b.frame(k)
        found += [] if points.tobytes() == others.tobytes() else [f"positions of frame {k}"]
        found += [f"{name} of frame {k}" for name in fields if fields[name].tobytes() != other_fields[name].tobytes()]
    return found


def test_a_resumed_run_has_the_bits_of_one_that_was_never_stopped(case, device, tmp_path):
    """If it failed, a restart would drift, or its file would have a doubled, a missing or a foreign frame."""
    whole, parts, many = tmp_path / "whole.vtkhdf", tmp_path / "parts.vtkhdf", available_cores()
    end = run(case, whole, 1.5 * case.duration, device, many)
    run(case, parts, case.duration, device, checkpoint_every=0.37 * case.duration)
    long_before = Checkpoint.read(previous(beside(parts)))
    assert long_before.facts["time"] < case.duration
    run(case, parts, 1.3 * case.duration, device, many, resume=long_before, checkpoint_every=0.61 * case.duration)
    again = run(case, parts, 1.5 * case.duration, device, resume=beside(parts))
    assert different(whole, parts) == []
    assert (again.time, again.steps, again.events) == (end.time, end.steps, end.events)
    assert again.ledgers == end.ledgers
    assert [str(ledger) for ledger in end.ledgers if not ledger.closes] == []
    assert again.positions.tobytes() == end.positions.tobytes()
    assert [name for name, field in end.fields.items() if again.fields[name].tobytes() != field.tobytes()] == []


@pytest.fixture
def begun(tmp_path) -> Path:
    """A checkpoint, and the result beside it."""
    run(HeatGaussian(**SMALL_HEAT), tmp_path / "heat.vtkhdf", 2.0, checkpoint_every=0.5)
    return beside(tmp_path / "heat.vtkhdf")


def resumed(checkpoint: Path, output: Path | None = None, duration: float = 4.0, **changes) -> Result:
    case = HeatGaussian(**SMALL_HEAT | changes)
    return case.run("cpu", 1, duration=duration, output=output, resume=checkpoint)


def test_a_finished_run_can_be_made_longer(begun, tmp_path):
    """If it failed, more of a run could be had only by running it anew."""
    result = resumed(begun, tmp_path / "heat.vtkhdf")
    run(HeatGaussian(**SMALL_HEAT), tmp_path / "whole.vtkhdf", 4.0)
    assert different(tmp_path / "heat.vtkhdf", tmp_path / "whole.vtkhdf") == []
    assert len(result.diagnostics["time"]) == 9


def test_frames_beside_the_schedule_are_taken_back(tmp_path):
    """If it failed, a run that ended between two frames would have one too many when it goes on."""
    case, parts, whole = HeatGaussian(**SMALL_HEAT), tmp_path / "parts.vtkhdf", tmp_path / "whole.vtkhdf"
    run(case, parts, 1.7, checkpoint_every=10.0)
    assert ResultFile(parts).times[-1] == 1.7
    run(case, parts, 4.0, resume=beside(parts))
    run(case, whole, 4.0)
    assert different(parts, whole) == []


def test_what_may_change_changes(begun, tmp_path):
    """If it failed, a run could not be looked at more closely from some time on."""
    resumed(begun, tmp_path / "heat.vtkhdf", output_interval=0.25)
    assert np.diff(ResultFile(tmp_path / "heat.vtkhdf").times) == pytest.approx([0.5] * 4 + [0.25] * 8)


def test_the_end_counts_from_the_begin_of_the_run_after_a_change_of_the_interval(begun, tmp_path):
    """If it failed, a resume after a resume with other frames would run on beyond the end that was asked for."""
    heat = tmp_path / "heat.vtkhdf"
    changed = HeatGaussian(**SMALL_HEAT | {"output_interval": 0.25})
    run(changed, heat, 3.0, resume=begun, checkpoint_every=0.5)
    result = run(changed, heat, 4.0, resume=previous(begun))
    assert result.time == 4.0
    run(HeatGaussian(**SMALL_HEAT), tmp_path / "other.vtkhdf", 2.0, checkpoint_every=0.5)
    at_once = run(changed, tmp_path / "other.vtkhdf", 4.0, resume=beside(tmp_path / "other.vtkhdf"))
    assert different(heat, tmp_path / "other.vtkhdf") == []
    assert at_once.positions.tobytes() == result.positions.tobytes()


def test_an_end_that_leaves_nothing_to_do_is_refused(begun, tmp_path):
    """If it failed, such a resume would lack its last frame, or blame the checkpoint."""
    with pytest.raises(InputError, match="at 2 s already; give a longer"):
        resumed(begun, tmp_path / "heat.vtkhdf", duration=2.0 + 1e-8)


@pytest.mark.parametrize("every", [1e-320, 1e308])
def test_any_distance_of_checkpoints_will_do(tmp_path, every):
    """If it failed, a very large or small one would end in the inside of Python."""
    run(HeatGaussian(**SMALL_HEAT), tmp_path / "heat.vtkhdf", 1.0, checkpoint_every=every)
    assert Checkpoint.read(beside(tmp_path / "heat.vtkhdf")).facts["time"] == 1.0


@pytest.mark.parametrize("name", ["heat.checkpoint", "heat.checkpoint.previous"])
def test_a_folder_in_the_place_of_a_checkpoint_is_refused_at_the_start(tmp_path, name):
    """If it failed, a run would end at its first checkpoint, or a folder of the user would have another name."""
    (tmp_path / name).mkdir()
    with pytest.raises(InputError, match=f"{name}: is no ordinary file, and checkpoints go there"):
        run(HeatGaussian(**SMALL_HEAT), tmp_path / "heat.vtkhdf", 1.0, checkpoint_every=0.5)
    assert [path.name for path in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        ("no/x.checkpoint", "there is no folder no"),
        ("", "ends in .checkpoint"),
        ("heat.vtkhdf", "ends in .checkpoint"),
        (5, "must be the name of a file"),
    ],
)
def test_a_place_without_a_checkpoint_is_refused_at_the_start(given, reason):
    """If it failed, a run of hours could not be gone on with when it is stopped, and would say so only then."""
    with pytest.raises(InputError, match=reason):
        HeatGaussian(**SMALL_HEAT).run("cpu", 1, checkpoint=given)


def test_what_is_no_checkpoint_at_all_is_refused():
    """If it failed, a mistake in a script would end in the inside of Python."""
    with pytest.raises(InputError, match="resume = 5: must be the name of a file"):
        HeatGaussian(**SMALL_HEAT).run("cpu", 1, resume=5)


def test_a_folder_that_goes_during_a_run_is_no_wrong_input(tmp_path):
    """If it failed, the exit code would say that nothing had been computed."""
    folder = tmp_path / "folder"
    folder.mkdir()
    case = HeatGaussian(**SMALL_HEAT)
    with pytest.raises(WarpsphError, match="cannot be written: No such file") as raised:
        case.run(
            "cpu",
            1,
            checkpoint=folder / "heat.checkpoint",
            checkpoint_every=0.5,
            progress=lambda now: folder.exists() and shutil.rmtree(folder),
        )
    assert not isinstance(raised.value, InputError)


def test_another_case_is_refused(begun, tmp_path):
    """If it failed, the rest of a run would be of another case than its begin, without a word."""
    before = (tmp_path / "heat.vtkhdf").read_bytes()
    with pytest.raises(InputError, match=r"diffusivity = 0.002: was 0.001 when .* duration, output_interval"):
        resumed(begun, tmp_path / "heat.vtkhdf", diffusivity=0.002)
    with pytest.raises(InputError, match="at 2 s already; give a longer"):
        resumed(begun, tmp_path / "heat.vtkhdf", duration=1.5)
    assert (tmp_path / "heat.vtkhdf").read_bytes() == before


def test_the_result_of_another_run_is_refused(begun, tmp_path):
    """If it failed, the frames of one run would be continued by those of another."""
    other = tmp_path / "other.vtkhdf"
    run(HeatGaussian(**SMALL_HEAT), other, 2.0)
    before = other.read_bytes()
    with pytest.raises(InputError, match="not the result of the run of this checkpoint"):
        resumed(begun, other)
    assert other.read_bytes() == before


def test_a_new_file_begins_at_the_checkpoint(begun, tmp_path):
    """If it failed, a run whose result was lost or moved away could not go on."""
    resumed(begun, tmp_path / "rest.vtkhdf")
    assert ResultFile(tmp_path / "rest.vtkhdf").times == pytest.approx([2.5, 3.0, 3.5, 4.0])


@pytest.mark.parametrize("fact", ["warpsph", "warp", "kind of device"])
def test_a_checkpoint_of_another_version_is_refused(begun, fact):
    """If it failed, a run would go on with other bits, without a word."""
    checkpoint = Checkpoint.read(begun)
    Checkpoint(checkpoint.facts | {fact: "other"}, checkpoint.saved).write(begun)
    with pytest.raises(InputError, match=f"of {fact} other, this is"):
        resumed(begun)


def test_a_damaged_checkpoint_is_refused_and_the_one_before_works(begun, tmp_path):
    """If it failed, a run would go on from garbage, or could not go on at all."""
    whole, right = begun.read_bytes(), pickle.dumps(Checkpoint.read(begun))
    for place in np.linspace(0, len(whole) - 1, 40).astype(int):
        begun.write_bytes(whole[:place] + bytes([whole[place] ^ 0x40]) + whole[place + 1 :])
        with suppress(InputError):  # where it is read, the bit is one of those that nobody looks at
            assert pickle.dumps(Checkpoint.read(begun)) == right
    for length in (0, 1, 100, len(whole) // 2, len(whole) - 1):
        begun.write_bytes(whole[:length])
        with pytest.raises(InputError, match=r"damaged .*; the one before it is .*heat.checkpoint.previous"):
            Checkpoint.read(begun)
    resumed(previous(begun), tmp_path / "heat.vtkhdf")
    run(HeatGaussian(**SMALL_HEAT), tmp_path / "whole.vtkhdf", 4.0)
    assert different(tmp_path / "heat.vtkhdf", tmp_path / "whole.vtkhdf") == []


HOSTILE = {
    "an array is missing": lambda c: (c.facts, {k: v for k, v in c.saved.items() if k != "position"}),
    "an array is of another kind": lambda c: (c.facts, c.saved | {"id": c.saved["id"].astype(float)}),
    "an array has another shape": lambda c: (c.facts, c.saved | {"position": c.saved["position"][1:]}),
    "a memory is another's": lambda c: (c.facts, c.saved | {"events": {"all": [1], "told": "x"}}),
    "a fact is missing": lambda c: ({k: v for k, v in c.facts.items() if k != "cycles"}, c.saved),
    "a fact is of another kind": lambda c: (c.facts | {"time": "late"}, c.saved),
    "the place in the schedule is nowhere": lambda c: (c.facts | {"cycles": -3}, c.saved),
    "the result is nowhere": lambda c: (c.facts | {"result": {}}, c.saved),
    "the result holds more": lambda c: (c.facts | {"result": c.facts["result"] | {"diagnostics": 10**9}}, c.saved),
    "nothing is there": lambda c: ({}, {}),
}


@pytest.mark.parametrize("how", HOSTILE)
def test_a_checkpoint_that_is_whole_but_wrong_is_refused(begun, tmp_path, how):
    """If it failed, such a file would end in the inside of Python, or harm the result that it names."""
    before = (tmp_path / "heat.vtkhdf").read_bytes()
    Checkpoint(*HOSTILE[how](Checkpoint.read(begun))).write(begun)
    with pytest.raises(InputError):
        resumed(begun, tmp_path / "heat.vtkhdf")
    assert (tmp_path / "heat.vtkhdf").read_bytes() == before


def test_a_spray_may_fail_in_what_is_left(tmp_path):
    """If it failed, what happens next could not be varied from one checkpoint on, without the hours before."""
    case = Casting(spacing=0.006, spray_flux=0.8, spray_particle=1e-3, duration=0.06, output_interval=0.02)
    failing = case.model_copy(update={"spray_failure": 0.04})
    for name, which in (("parts", case), ("other", case), ("whole", failing)):
        run(which, tmp_path / f"{name}.vtkhdf", 0.06 if which is failing else 0.03, checkpoint_every=0.03)
    for name, which in (("parts", failing), ("other", case)):
        checkpoint = Checkpoint.read(beside(tmp_path / f"{name}.vtkhdf"))
        run(which, tmp_path / f"{name}.vtkhdf", 0.06, resume=checkpoint)
    assert different(tmp_path / "parts.vtkhdf", tmp_path / "whole.vtkhdf") == []
    assert different(tmp_path / "parts.vtkhdf", tmp_path / "other.vtkhdf") != []


@pytest.mark.parametrize("end", [2.0, 1.5])
def test_a_run_that_was_killed_at_its_very_end_is_finished(end, tmp_path):
    """If it failed, such a run would stay "unfinished", and who resumes until the end would be told of wrong input."""
    whole, parts = tmp_path / "whole.vtkhdf", tmp_path / "parts.vtkhdf"
    case = HeatGaussian(**SMALL_HEAT | {"output_interval": 1.0, "step": 0.25})
    for path in (whole, parts):
        run(case, path, end, checkpoint_every=0.5)
    result = run(case, parts, end, resume=beside(parts))
    assert (result.time, result.status) == (end, "complete")
    assert different(parts, whole) == []
