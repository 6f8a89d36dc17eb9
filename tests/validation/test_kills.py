"""Runs that are killed at any moment and resumed, until they end: nothing is lost, and the bits are those of one run.

``WARPSPH_KILLS=100 pytest tests/validation/test_kills.py`` kills a hundred times.
"""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import pyvista

from warpsph.cli import main
from warpsph.errors import InputError
from warpsph.files.checkpoint import Checkpoint, beside, previous
from warpsph.files.results import ResultFile

KILLS = int(os.environ.get("WARPSPH_KILLS", "4"))  # in all
HEAT = ["heat_gaussian", "--set", "spacing=0.02", "--every", "0.05", "--until", "60", "--checkpoint-every", "0.32"]
STRAND = [
    "casting", "--set", "spacing=0.006", "spray_flux=0.8", "--every", "0.004", "--until", "0.2",
    "--checkpoint-every", "0.0093",
]  # fmt: skip


def start(words: list[str], folder: Path) -> subprocess.Popen:
    command = [sys.executable, "-m", "warpsph", "run", *words, "--device", "cpu", "--output", "out.vtkhdf"]
    return subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def kill_or_end(process: subprocess.Popen, within: float, luck: random.Random) -> bool:
    """Kill a run at a random time after it has begun to compute; whether it was still there."""
    with process:
        for line in process.stderr:
            if "computing on" in line:
                break
        time.sleep(luck.uniform(0.0, within))
        process.kill()
        process.stderr.read()
    assert process.returncode in (0, -signal.SIGKILL)
    return process.returncode != 0


def refuse_other_frames(path: Path, whole: ResultFile) -> int:
    """Read what a killed run has left, here and with VTK, and compare all of it; the number of frames."""
    cut = ResultFile(path)
    count = len(cut.times)
    assert cut.times.tobytes() == whole.times[:count].tobytes()
    for k in range(count):
        (points, fields), (right, right_fields) = cut.frame(k), whole.frame(k)
        assert points.tobytes() == right.tobytes()
        assert all(fields[name].tobytes() == right_fields[name].tobytes() for name in right_fields)
    for name, series in cut.diagnostics.items():
        assert series.tobytes() == whole.diagnostics[name][: len(series)].tobytes()
    reader = pyvista.get_reader(path)
    assert reader.reader.GetNumberOfSteps() >= count
    reader.reader.SetStep(count - 1)
    assert np.array_equal(reader.read().points, points)
    return count


def newest(path: Path) -> Path | None:
    """The newest whole checkpoint."""
    for candidate in (beside(path), previous(beside(path))):
        try:
            Checkpoint.read(candidate)
        except InputError:
            continue
        return candidate
    return None


@pytest.mark.parametrize("words", [HEAT, STRAND], ids=["heat", "strand"])
def test_killed_and_resumed_until_the_end(words: list[str], tmp_path: Path):
    """If it failed, a crash of the machine would cost more than what was done since the last checkpoint."""
    whole = tmp_path / "whole.vtkhdf"
    assert main(["run", *words, "--device", "cpu", "--output", str(whole), "--quiet"]) == 0
    right, out, luck = ResultFile(whole), tmp_path / "out.vtkhdf", random.Random(1)
    kills = kept = resumes = 0
    while kills < KILLS / 2:
        checkpoint = newest(out) if out.exists() else None
        again = ["--resume", str(checkpoint)] if checkpoint else ["--overwrite"]
        until = words[words.index("--until") : words.index("--until") + 2]
        process = start([words[0], *again, *until, *words[-2:]] if checkpoint else [*words, *again], tmp_path)
        resumes += checkpoint is not None
        if kill_or_end(process, 4.0, luck):
            kills += 1
            kept += refuse_other_frames(out, right) if out.exists() else 0
        else:
            assert refuse_other_frames(out, right) == len(right.times)
            assert ResultFile(out).events == right.events
            for file in (out, beside(out), previous(beside(out))):
                file.unlink(missing_ok=True)
    if checkpoint := newest(out):
        assert main(["run", words[0], "--resume", str(checkpoint), "--quiet"]) == 0
        assert refuse_other_frames(out, right) == len(right.times)
    print(f"{words[0]}: {kills} kills, {resumes} resumes, {kept} frames compared")
