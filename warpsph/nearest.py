"""The nearest allowed name for a mistyped one."""

from collections.abc import Iterable
from difflib import get_close_matches

LONGEST_NAME = 100  # letters, above which nothing is near, and looking for it would take long


def did_you_mean(given: str, allowed: Iterable[str]) -> str:
    """``"; did you mean 'x'?"``, or ``"; allowed: a, b"`` where nothing is near."""
    allowed = list(allowed)
    near = get_close_matches(given, allowed, n=1) if len(given) <= LONGEST_NAME else []
    return f"; did you mean '{near[0]}'?" if near else f"; allowed: {', '.join(allowed)}"
