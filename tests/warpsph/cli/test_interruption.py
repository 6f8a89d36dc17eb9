"""Ctrl-C and what a batch system sends, before and during a real run, in processes of their own; and going on."""

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
EARLY = (
    "import os, signal, sys, threading; signal.signal(signal.SIGINT, signal.default_int_handler);"
    "from warpsph.cli import main;"
    "threading.Timer({after}, os.kill, (os.getpid(), signal.{name})).start(); sys.exit(main(None))"
)
RUN = ["run", "heat_gaussian", "--device", "cpu", "--threads", "1"]
COARSE = [*RUN, "--preset", "coarse", "--every", "7"]
WORDS = [*COARSE, "--until", "1e4", "--output", "out.vtkhdf"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_keeps_what_has_been_simulated(
    tmp_path: Path, number: signal.Signals, monkeypatch: pytest.MonkeyPatch
):
    """If it failed, stopping a long run by hand or by a batch system would lose it, or leave no way to go on."""
    command = [sys.executable, "-c", PROGRAM, *WORDS]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        next(line for line in process.stderr if line.startswith("heat_gaussian "))  # the progress
        process.send_signal(number)
        output, _ = process.communicate()
    assert process.returncode == 128 + number
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


@pytest.mark.parametrize(("name", "after"), [("SIGINT", 0.02), ("SIGTERM", 0.4)])
def test_a_signal_before_the_run_leaves_one_line(tmp_path: Path, name: str, after: float):
    """If it failed, who stops a command that has just been started would be shown the inside of Python's imports."""
    command = [sys.executable, "-c", EARLY.format(after=after, name=name), *WORDS]
    ended = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert ended.stderr == "warpsph: interrupted\n"
    assert ended.returncode == 128 + getattr(signal, name)
    assert list(tmp_path.iterdir()) == []
