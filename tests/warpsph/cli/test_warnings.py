"""A warning of the engine, for example of a driver that cannot be used, on the command line."""

import warnings

import pytest

import warpsph.core.executor as executor
from warpsph.cli import main

LINE = (
    "warpsph: a GPU driver is here, but it cannot be used: this warp-lang needs one with CUDA 13.0 or newer "
    "(NVIDIA driver 580 or newer); this run computes on the CPU\n"
)


@pytest.fixture
def useless_driver(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine whose NVIDIA driver is too old to show a device."""
    monkeypatch.setattr(executor, "driver_is_here", lambda: True)
    monkeypatch.setattr(executor, "cuda_versions", lambda: ((13, 0), None))
    monkeypatch.setattr(executor.wp, "get_cuda_devices", lambda: [])


@pytest.mark.usefixtures("useless_driver")
def test_useless_driver_is_one_line(warpsph_command):
    """If it failed, a run would crawl on the CPU of a machine with a GPU, and nobody would be told why."""
    outcome = warpsph_command("run", "ingot")
    assert outcome.code == 0
    assert outcome.error.startswith(LINE + "ingot: computing on cpu, ")
    assert outcome.error.count("warpsph: ") == 1


@pytest.mark.usefixtures("useless_driver")
def test_useless_driver_is_told_even_with_quiet(warpsph_command):
    """If it failed, a script would never learn that it does not use the GPU."""
    outcome = warpsph_command("run", "ingot", "--quiet")
    assert (outcome.code, outcome.output, outcome.error) == (0, "", LINE)


@pytest.mark.usefixtures("useless_driver")
def test_who_asks_for_the_cpu_is_not_warned(warpsph_command):
    """If it failed, a warning that is none of the user's concern would appear at every run."""
    assert warpsph_command("run", "ingot", "--device", "cpu", "--quiet").error == ""


def test_warnings_are_shown_as_before_afterwards(capsys: pytest.CaptureFixture[str]):
    """If it failed, a program that calls the command line would see its own warnings as those of warpsph."""
    before = warnings.showwarning
    assert main(["--version"]) == 0
    assert warnings.showwarning is before
