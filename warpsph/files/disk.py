"""The disk below HDF5: what is written between two commits is in the file as a whole, or not at all.

HDF5 ends the process with a segmentation fault where it cannot write what it has held back. So it never hears of a full
disk: from the first write that fails on, everything stays in memory, and :meth:`Disk.commit` raises what happened.
"""

import os

PAGE = 4096  # bytes


class Disk:
    """A file as h5py takes it in the place of a name, which a failed write does not harm.

    What is new stands behind the old end and is written at once. What changes in front of that is held back until HDF5
    flushes, and what stood there is kept until the commit, so that it can be put back.

    Args:
        descriptor: of the open file; it is not closed.

    Attributes:
        failure: the first error since the last commit, or None.
    """

    def __init__(self, descriptor: int) -> None:
        self.descriptor = descriptor
        self.failure: OSError | None = None
        self._place = 0
        self._end = self._committed = os.fstat(descriptor).st_size
        self._pages: dict[int, bytearray] = {}
        self._before: dict[int, bytes] = {}

    def commit(self) -> None:
        """Let what has been flushed stand.

        Raises:
            OSError: something could not be written or read; :meth:`roll_back` is what remains.
        """
        self.flush()
        if self.failure is not None:
            raise self.failure
        self._before.clear()
        self._committed = self._end

    def roll_back(self) -> None:
        """Make the file what it was at the last commit; this object is of no use afterwards.

        Raises:
            OSError: that is not possible, the file may be damaged.
        """
        for page, content in self._before.items():
            _write(self.descriptor, content, page * PAGE)
        os.ftruncate(self.descriptor, self._committed)

    def sink(self) -> None:
        """Write nothing to the disk any more."""
        self.failure = self.failure or OSError("no longer written")

    # what h5py asks of a file

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        start = {os.SEEK_SET: 0, os.SEEK_CUR: self._place, os.SEEK_END: self._end}[whence]
        self._place = start + offset
        return self._place

    def tell(self) -> int:
        return self._place

    def readinto(self, buffer) -> int:
        view = memoryview(buffer).cast("B")
        view[:] = self._read(self._place, len(view))
        self._place += len(view)
        return len(view)

    def read(self, size: int) -> bytes:
        content = self._read(self._place, size)
        self._place += size
        return content

    def write(self, content) -> int:
        view = memoryview(content).cast("B")
        held = len(view) if self.failure else min(max(self._held_until() - self._place, 0), len(view))
        self._hold(view[:held], self._place)
        if held < len(view):
            try:
                _write(self.descriptor, view[held:], self._place + held)
            except OSError as error:
                self.failure = error
                self._hold(view[held:], self._place + held)
        self._place += len(view)
        self._end = max(self._end, self._place)
        return len(view)

    def truncate(self, size: int) -> int:
        self._end = size
        self._try(lambda: os.ftruncate(self.descriptor, size))
        return size

    def flush(self) -> None:
        for page in sorted(self._pages):
            self._try(lambda page=page: self._write_page(page))
            if self.failure:
                return
        self._pages.clear()

    def _held_until(self) -> int:
        """The end of the last page that the last commit has anything in."""
        return -(-self._committed // PAGE) * PAGE

    def _hold(self, content: memoryview, start: int) -> None:
        done = 0
        while done < len(content):
            page, first = divmod(start + done, PAGE)
            piece = content[done : done + PAGE - first]
            if page not in self._pages:
                whole = len(piece) == PAGE
                self._pages[page] = bytearray(PAGE) if whole else bytearray(self._on_disk(page * PAGE, PAGE))
            self._pages[page][first : first + len(piece)] = piece
            done += len(piece)

    def _write_page(self, page: int) -> None:
        start = page * PAGE
        content = self._pages[page][: self._end - start]
        old = os.pread(self.descriptor, PAGE, start)
        if old.startswith(content):
            return
        if start < self._committed:
            self._before.setdefault(page, old)
        _write(self.descriptor, content, start)

    def _read(self, start: int, size: int) -> bytes:
        content = bytearray(self._on_disk(start, size))
        if self._pages:
            for page in range(start // PAGE, -(-(start + size) // PAGE)):
                held = self._pages.get(page)
                if held is not None:
                    first, last = max(page * PAGE, start), min((page + 1) * PAGE, start + size)
                    content[first - start : last - start] = held[first - page * PAGE : last - page * PAGE]
        return bytes(content)

    def _on_disk(self, start: int, size: int) -> bytes:
        """What stands on the disk, zeros behind its end."""
        try:
            content = os.pread(self.descriptor, size, start)
        except OSError as error:
            self.failure = self.failure or error
            content = b""
        return content.ljust(size, b"\0")

    def _try(self, work) -> None:
        if self.failure is None:
            try:
                work()
            except OSError as error:
                self.failure = error


def _write(descriptor: int, content, start: int) -> None:
    """Write all of ``content``; a disk that is nearly full takes a part of it first."""
    view = memoryview(content)
    while view:
        written = os.pwrite(descriptor, view, start)
        view, start = view[written:], start + written
