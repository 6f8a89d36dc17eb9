"""What this machine can hold: asked before it is taken."""

import os
from collections.abc import Iterator
from pathlib import Path

from warpsph.errors import InputError

try:
    import resource
except ImportError:  # Windows knows no such limits
    resource = None  # type: ignore[assignment]

LEAST_BYTES = 400  # of a particle: its fields, its places in the sorting, and a short row of neighbours
CGROUP = Path("/sys/fs/cgroup")


def free_memory() -> float:
    """Memory [bytes] that this process can still take on the host; infinite where the system says nothing of it."""
    return max(min(_limits(), default=float("inf")), 0.0)


def refuse_more_than_fits(what: str, needed: float, free: float | None = None) -> None:
    """Refuse what would need more memory than there is.

    Args:
        what: what needs it, for people.
        needed: [bytes]; infinite and more than any number of bytes too.
        free: memory of the device [bytes], by default that of the host.

    Raises:
        InputError: how much is needed, and how much there is.
    """
    free = free_memory() if free is None else free
    if needed > free:
        raise InputError(
            f"{what}: {in_bytes(needed)} of memory are needed and {in_bytes(free)} are free; "
            "a larger spacing, fewer rows or a smaller case needs less"
        )


def refuse_too_many(what: str, count: float) -> None:
    """Refuse to place more particles than the memory of the host could hold.

    Raises:
        InputError: as :func:`refuse_more_than_fits` does.
    """
    if count * LEAST_BYTES > 1.0e6:  # a few need no look
        refuse_more_than_fits(f"{what} of {count:.3g} particles", count * LEAST_BYTES)


def in_bytes(size: float) -> str:
    """A size [bytes] as people write it."""
    for unit in ("bytes", "kB", "MB", "GB", "TB"):
        if size < 1000.0:
            return f"{size:.3g} {unit}"
        size /= 1000.0
    return f"{size:.3g} PB"


def _limits() -> Iterator[float]:
    try:
        meminfo = dict(line.split(":", 1) for line in Path("/proc/meminfo").read_text().splitlines())
        yield 1024.0 * float(meminfo["MemAvailable"].split()[0])
    except (OSError, ValueError, KeyError):
        if "SC_PHYS_PAGES" in getattr(os, "sysconf_names", {}):
            yield float(os.sysconf("SC_PHYS_PAGES")) * os.sysconf("SC_PAGE_SIZE")
    try:
        limit, used = (float((CGROUP / f"memory.{name}").read_text()) for name in ("max", "current"))
        stat = dict(line.split() for line in (CGROUP / "memory.stat").read_text().splitlines())
        yield limit - used + float(stat["inactive_file"])  # the system takes that back
    except (OSError, ValueError, KeyError):
        pass
    try:
        limit = resource.getrlimit(resource.RLIMIT_AS)[0]
        if limit != resource.RLIM_INFINITY:
            yield limit - int(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, AttributeError):
        pass
