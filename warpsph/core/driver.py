"""Whether the NVIDIA driver of this machine can be used, and what it lacks."""

from pathlib import Path

import warp as wp

Version = tuple[int, int]

TRACES = ("/proc/driver/nvidia/version", "/dev/nvidia0", "/dev/nvidiactl", "/dev/dxg")  # that a driver leaves (Linux)
DRIVERS = {12: "525", 13: "580"}  # the first driver (Linux) of each CUDA release


def driver_is_here() -> bool:
    """Whether this machine has an NVIDIA driver, usable or not."""
    return any(Path(trace).exists() for trace in TRACES)


def cuda_versions() -> tuple[Version | None, Version | None]:
    """The CUDA versions that Warp was built with and that the driver offers."""
    return tuple(wp.get_cuda_toolkit_version() or ()) or None, tuple(wp.get_cuda_driver_version() or ()) or None  # type: ignore[return-value]


def driver_complaint(here: bool, built_with: Version | None, offered: Version | None) -> str | None:
    """Why no CUDA device can be used although a driver is here, and which driver is needed; None without a driver.

    Args:
        here: whether there is a driver.
        built_with: CUDA version of Warp, None for a build without CUDA.
        offered: CUDA version of the driver, None where it cannot be loaded.
    """
    if not here:
        return None
    if built_with is None:
        return "a GPU driver is here, but this build of warp-lang has no CUDA; install warp-lang from PyPI"
    needed = f"CUDA {built_with[0]}.0 or newer"
    if built_with[0] in DRIVERS:
        needed += f" (NVIDIA driver {DRIVERS[built_with[0]]} or newer)"
    if offered is None:
        return f"a GPU driver is here, but it cannot be used: this warp-lang needs one with {needed}"
    if offered < (built_with[0], 0):
        return f"the GPU driver offers CUDA {offered[0]}.{offered[1]}, too old: this warp-lang needs {needed}"
    return "a GPU driver is here, but it shows no CUDA device; see nvidia-smi"
