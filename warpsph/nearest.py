"""The nearest allowed name for a mistyped one."""

from collections.abc import Iterable
from difflib import get_close_matches


def did_you_mean(given: str, allowed: Iterable[str]) -> str:
    """``"; did you mean 'x'?"``, or ``"; allowed: a, b"`` where nothing is near."""
    allowed = list(allowed)
    near = get_close_matches(str(given), allowed, n=1)
    return f"; did you mean '{near[0]}'?" if near else f"; allowed: {', '.join(allowed)}"
