"""Ctrl-C during a real run, in a process of its own, and going on from there."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

from warpsph.cli import main
from warpsph.files.results import ResultFile

PROGRAM = (
    "import signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler);"
    "from warpsph.cli import main; sys.exit(main())"
)


RUN = ["run", "heat_gaussian", "--device", "cpu"]
COARSE = [*RUN, "--preset", "coarse", "--every", "7"]


def test_ctrl_c_keeps_what_has_been_simulated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """If it failed, stopping a long run by hand would lose it, pass it off as complete, or leave no way to go on."""
    command = [sys.executable, "-c", PROGRAM, *COARSE, "--until", "1e4", "--output", "out.vtkhdf"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        next(line for line in process.stderr if line.startswith("heat_gaussian "))  # the progress
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate()
    assert process.returncode == 130
    assert "interrupted at" in output
    result = ResultFile(tmp_path / "out.vtkhdf")
    assert result.provenance["status"] == "interrupted"
    stopped = result.times[-1]
    assert 0.0 < stopped < 1e4
    monkeypatch.chdir(tmp_path)
    until = ["--until", f"{stopped + 20.0:.0f}"]
    assert main([*RUN, "--resume", "out.checkpoint", *until]) == 0
    assert main([*COARSE, *until, "--output", "whole.vtkhdf"]) == 0
    gone_on, whole = ResultFile(tmp_path / "out.vtkhdf"), ResultFile(tmp_path / "whole.vtkhdf")
    assert gone_on.provenance["status"] == "complete"
    assert gone_on.times.tobytes() == whole.times.tobytes()
    assert gone_on.frame(-1)[1]["temperature"].tobytes() == whole.frame(-1)[1]["temperature"].tobytes()
