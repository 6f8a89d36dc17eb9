"""What ``--levels`` says: lines of equal value, by numbers or as the ends of melting."""

from warpsph.errors import InputError, shown
from warpsph.files.results import ResultFile

ENDS = ("solidus", "liquidus")


def read_levels(text: str | None, result: ResultFile) -> tuple[str | None, tuple[float, ...]]:
    """The field, None for the one that the colours show, and the values of ``[NAME=]VALUE,...``.

    Raises:
        InputError: a value is no number, or nothing in the result melts.
    """
    if text is None:
        return None, ()
    name, _, values = text.rpartition("=")
    words = [word.strip() for word in values.split(",")]
    if not name and words and set(words) <= set(ENDS):
        return "temperature", tuple(value for word in words for value in _ends(result, ENDS.index(word)))
    try:
        return name.strip() or None, tuple(float(word) for word in words)
    except ValueError:
        raise InputError(
            f"--levels {shown(text)}: give numbers, for example 0.1,0.2 or temperature=1723,1773, or solidus,liquidus"
        ) from None


def _ends(result: ResultFile, which: int) -> list[float]:
    """The solidus (0) or the liquidus (1) [K] of each material that melts."""
    ranges = result.provenance.get("melting_ranges", {})
    try:
        ends = [float(both[which]) for both in ranges.values()]
    except (AttributeError, IndexError, KeyError, TypeError, ValueError):
        ends = []
    if not ends:
        raise InputError(f"{result.path}: nothing is known in it that melts; give temperature=VALUE,...")
    return ends
