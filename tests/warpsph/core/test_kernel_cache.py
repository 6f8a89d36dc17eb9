"""Machines on which Warp's folder for compiled kernels cannot be written."""

import subprocess
import sys

import pytest

START = (
    "from warpsph.core.executor import Executor; import warp; Executor('cpu', 1); print(warp.config.kernel_cache_dir)"
)


@pytest.mark.parametrize("folder", ["/proc/nope", "/dev/null/below"])
def test_a_folder_that_cannot_be_written_is_replaced(folder: str, tmp_path):
    """If it failed, a run in a batch system without a home would end in a traceback."""
    environment = {"WARP_CACHE_PATH": folder, "TMPDIR": str(tmp_path)}
    ended = subprocess.run(
        [sys.executable, "-W", "always", "-c", START], capture_output=True, text=True, env=environment
    )
    assert ended.returncode == 0
    assert ended.stdout.startswith(f"{tmp_path}/warpsph-kernels-")
    assert f"({folder}" in ended.stderr
    assert list(tmp_path.iterdir()) == []
