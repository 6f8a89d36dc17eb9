"""The place of a result file: one run writes it, and it appears there with its first frame."""

import contextlib
import glob
import os
import secrets
from contextlib import ExitStack
from pathlib import Path

from warpsph.errors import InputError, WarpsphError
from warpsph.files.beside import cannot_be_written, hidden_name, registered

try:
    import fcntl
except ImportError:  # not on Windows
    fcntl = None  # type: ignore[assignment]

UNFINISHED = "unfinished"


class Placement:
    """An open file that stands hidden beside its place until :meth:`appear`, and a lock on this place.

    The lock is on a file of its own: a lock on the result would keep viewers from reading it. It goes with the process,
    so a killed run leaves none; the hidden files that it leaves are removed by the next run of this place.

    Args:
        path: the file; where it is a symbolic link, what it points to.
        overwrite: whether an existing file is replaced.
        existing: whether the file that is there is opened, to go on with it.

    Raises:
        InputError: the file exists and ``overwrite`` is false, it cannot be made, or another run writes it.
        WarpsphError: the disk is full or broken.

    Attributes:
        descriptor: of the open file.
        appeared: whether it has its name.
    """

    def __init__(self, path: Path, overwrite: bool, existing: bool = False) -> None:
        self.path, self.overwrite = path, overwrite
        self.appeared, self._locked = existing, False
        self._ending = ExitStack()
        try:
            self._target = Path(os.path.realpath(path))
            _check_target(path, self._target)
            self._lock()
            if existing:
                self.descriptor = os.open(self._target, os.O_RDWR)
                self._ending.callback(os.close, self.descriptor)
            else:
                self._refuse_existing()
                self._hide()
        except OSError as error:
            self.close()
            raise cannot_be_written(path, error) from None
        except WarpsphError:
            self.close()
            raise

    def appear(self) -> None:
        """Give the file its name, once; the whole of it may still grow.

        Raises:
            InputError: somebody else has made a file of this name meanwhile.
        """
        if self.appeared:
            return
        if not self.overwrite:
            try:
                os.link(self._hidden, self._target)
            except FileExistsError:
                self._refuse_existing()
            except OSError:  # a file system without hard links
                os.close(os.open(self._target, os.O_CREAT | os.O_EXCL))
                os.replace(self._hidden, self._target)
        else:
            os.replace(self._hidden, self._target)
        self._hiding.close()
        self.appeared = True

    def refuse_removed(self) -> None:
        """Raise WarpsphError where nothing leads to the file any more."""
        if os.fstat(self.descriptor).st_nlink == 0:
            raise WarpsphError(f"{self.path}: was removed or replaced during the run; what it computes would be lost")

    def close(self) -> None:
        """Close the file, remove it where it has not appeared, and let others have the place."""
        self._ending.close()

    def _lock(self) -> None:
        """Take the lock; where the file system has none, nobody is kept out before the end."""
        if fcntl is None:
            return
        path = hidden_name(self._target, "lock")
        while True:
            descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
                if os.path.exists(path) and os.path.samestat(os.fstat(descriptor), os.stat(path)):
                    self._ending.callback(os.close, descriptor)
                    self._ending.callback(path.unlink, missing_ok=True)
                    self._locked = True
                    return
            except BlockingIOError:
                os.close(descriptor)
                raise InputError(
                    f"{self.path}: another run is writing it; wait for its end or choose another name"
                ) from None
            except OSError:
                os.close(descriptor)
                return
            os.close(descriptor)  # its owner has just removed it

    def _hide(self) -> None:
        if self._locked:  # with the lock no run that still lives has such a file
            for old in self._target.parent.glob(glob.escape(hidden_name(self._target, UNFINISHED).name) + ".*"):
                with contextlib.suppress(OSError):
                    old.unlink()
        self._hidden = hidden_name(self._target, f"{UNFINISHED}.{secrets.token_hex(4)}")
        self.descriptor = os.open(self._hidden, os.O_CREAT | os.O_EXCL | os.O_RDWR, 0o666)
        self._ending.callback(os.close, self.descriptor)
        self._hiding = self._ending.enter_context(ExitStack())
        self._hiding.enter_context(registered(self._hidden))

    def _refuse_existing(self) -> None:
        if os.path.lexists(self._target) and not self.overwrite:
            raise InputError(f"{self.path}: exists already; choose another name, or give overwrite=True to replace it")


def _check_target(path: Path, target: Path) -> None:
    if target.is_dir():
        raise InputError(f"{path}: is a folder; give the name of a file")
    if not target.parent.is_dir():
        raise InputError(f"{path}: there is no folder {target.parent}; make it first")
    if target.exists() and not target.is_file():
        raise InputError(f"{path}: is no ordinary file; choose another name")
