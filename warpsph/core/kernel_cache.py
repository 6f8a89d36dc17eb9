"""Where compiled kernels are kept: Warp's folder, or where that cannot be written, one for this process."""

import atexit
import os
import shutil
import tempfile
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import warp as wp

from warpsph.errors import WarpsphError

WORTH_A_TRY = 1 << 16  # bytes


@cache
def start_warp() -> None:
    """Start Warp once, with a folder for its kernels that can be written.

    Raises:
        WarpsphError: there is no such folder on this machine.
    """
    try:
        with _without_driver_warning():
            wp.init()
        _try_to_write(Path(str(wp.config.kernel_cache_dir)))
    except OSError as error:
        refused = f"{wp.config.kernel_cache_dir}: {error.strerror}"
        _use_temporary_folder(refused)


def _use_temporary_folder(refused: str) -> None:
    try:
        folder = tempfile.mkdtemp(prefix="warpsph-kernels-")
        _try_to_write(Path(folder))
    except OSError:
        raise WarpsphError(
            f"compiled kernels cannot be kept ({refused}); name a folder with room in WARP_CACHE_PATH"
        ) from None
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    wp.config.kernel_cache_dir = folder
    with _without_driver_warning():
        wp.init()
    warnings.warn(
        f"compiled kernels cannot be kept ({refused}) and are compiled anew this time; "
        "name a folder with room in WARP_CACHE_PATH",
        stacklevel=4,
    )


def _try_to_write(folder: Path) -> None:
    """Raise OSError where ``folder`` takes no new file."""
    with tempfile.TemporaryFile(dir=folder) as file:
        file.write(b"\0" * WORTH_A_TRY)
        file.flush()


@contextmanager
def _without_driver_warning() -> Iterator[None]:
    """Warp's native part writes to standard error where there is no CUDA driver, whatever the log level."""
    try:
        kept = os.dup(2)
    except OSError:  # closed
        yield
        return
    with open(os.devnull, "w") as nowhere:
        os.dup2(nowhere.fileno(), 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
