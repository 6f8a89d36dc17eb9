"""Files that appear under their name when they are whole: until then they stand hidden beside their place."""

import contextlib
import errno
import hashlib
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from warpsph.errors import InputError, WarpsphError

DISK_TROUBLE = {errno.ENOSPC, errno.EFBIG, errno.EIO, getattr(errno, "EDQUOT", errno.ENOSPC)}
LONGEST_NAME = 200  # bytes, which leaves room for what hidden names add

_hidden: set[Path] = set()


def hidden_name(target: Path, ending: str) -> Path:
    """A hidden file beside ``target`` that is called after it; no name is too long for that."""
    name = target.name
    if len(os.fsencode(name)) > LONGEST_NAME:
        name = hashlib.sha256(os.fsencode(name)).hexdigest()
    return target.with_name(f".{name}.{ending}")


@contextmanager
def hidden_until_whole(target: Path) -> Iterator[Path]:
    """A context that yields a hidden file to write, which takes the place of ``target`` at its end.

    Where ``target`` is a symbolic link, what it points to is replaced. Where the work fails, nothing is left.

    Raises:
        InputError: the folder may not be written in.
        WarpsphError: the disk is full or broken.
    """
    try:
        place = Path(os.path.realpath(target))
        hidden = hidden_name(place, f"{secrets.token_hex(4)}{place.suffix}")
        with registered(hidden):
            os.close(os.open(hidden, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
            yield hidden
            _synchronise(hidden)
            os.replace(hidden, place)
    except OSError as error:
        raise cannot_be_written(target, error) from None


@contextmanager
def registered(hidden: Path) -> Iterator[None]:
    """A context at whose end a hidden file is gone, also if the process is asked to end at once."""
    _hidden.add(hidden)
    try:
        yield
    finally:
        hidden.unlink(missing_ok=True)
        _hidden.discard(hidden)


def remove_hidden() -> None:
    """Remove what is not whole yet; for a process that ends at once."""
    for path in list(_hidden):
        with contextlib.suppress(OSError):
            path.unlink(missing_ok=True)


def cannot_be_written(path: Path, error: OSError) -> WarpsphError:
    """The error for a file, in one line: a full or broken disk is no fault of the input."""
    kind = WarpsphError if error.errno in DISK_TROUBLE else InputError
    return kind(f"{path}: cannot be written: {error.strerror or error}")


def _synchronise(path: Path) -> None:
    """Hear of what a file system tells only when it must, such as a quota over the network."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
