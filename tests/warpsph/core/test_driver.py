"""A GPU driver that is there but unusable."""

import pytest

from warpsph.core import executor
from warpsph.core.driver import driver_complaint
from warpsph.core.executor import Executor
from warpsph.errors import InputError

NO_GPU_HERE = not any(device.is_cuda for device in [Executor("auto").device])


def test_a_machine_without_a_driver_gets_no_complaint():
    """If it failed, everybody on a laptop would be told about a GPU that is not there."""
    assert driver_complaint(False, (13, 4), None) is None


@pytest.mark.parametrize(
    ("built_with", "offered", "words"),
    [
        ((13, 4), (12, 4), "offers CUDA 12.4, too old: this warp-lang needs CUDA 13.0 or newer (NVIDIA driver 580 or"),
        ((12, 9), (11, 8), "needs CUDA 12.0 or newer (NVIDIA driver 525 or newer)"),
        ((13, 4), None, "cannot be used: this warp-lang needs one with CUDA 13.0 or newer (NVIDIA driver 580"),
        (None, (12, 4), "this build of warp-lang has no CUDA"),
        ((13, 4), (13, 4), "shows no CUDA device"),
    ],
)
def test_an_unusable_driver_is_named_with_what_is_needed(built_with, offered, words):
    """If it failed, a user would not know which driver to install."""
    complaint = driver_complaint(True, built_with, offered)
    assert words in complaint
    assert "\n" not in complaint


@pytest.mark.skipif(not NO_GPU_HERE, reason="this machine has a usable GPU, so nothing falls back")
def test_auto_says_that_it_falls_back(monkeypatch):
    """If it failed, a user with an old driver would compute on the CPU without a word."""
    monkeypatch.setattr(executor, "driver_is_here", lambda: True)
    monkeypatch.setattr(executor, "cuda_versions", lambda: ((13, 4), (12, 4)))
    too_old = r"'cuda:0' is not here; the GPU driver offers CUDA 12\.4, too old"
    with pytest.warns(UserWarning, match=r"too old.*driver 580.*this run computes on the CPU"):
        Executor("auto", 1)
    with pytest.raises(InputError, match=too_old):
        Executor("cuda:0")


def test_an_executor_describes_where_it_computes():
    """If it failed, a run could not name its device and threads."""
    assert Executor("cpu", 1).description == "cpu, 1 thread"
