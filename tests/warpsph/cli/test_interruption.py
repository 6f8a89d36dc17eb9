"""Ctrl-C during a real run, in a process of its own."""

import signal
import subprocess
import sys
from pathlib import Path

from warpsph.files.results import ResultFile

PROGRAM = (
    "import signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler);"
    "from warpsph.cli import main; sys.exit(main())"
)


def test_ctrl_c_keeps_what_has_been_simulated(tmp_path: Path):
    """If it failed, stopping a long run by hand would lose it, or pass it off as complete."""
    words = [
        "run",
        "heat_gaussian",
        "--preset",
        "coarse",
        "--until",
        "1e4",
        "--device",
        "cpu",
        "--output",
        "out.vtkhdf",
    ]
    command = [sys.executable, "-c", PROGRAM, *words]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        next(line for line in process.stderr if line.startswith("heat_gaussian "))  # the progress
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate()
    assert process.returncode == 130
    assert "interrupted at" in output
    result = ResultFile(tmp_path / "out.vtkhdf")
    assert result.provenance["status"] == "interrupted"
    assert 0.0 < result.times[-1] < 1e4
