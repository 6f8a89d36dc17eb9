"""The errors that a user can cause or must know of; the command line turns each into its exit code."""

from collections.abc import Iterable
from numbers import Real
from typing import Any

LONGEST_VALUE = 80  # letters


class WarpsphError(Exception):
    """Base of the errors that warpsph raises on purpose; its text is one line a user can act on."""

    exit_code = 1


class InputError(WarpsphError):
    """The input is wrong: which key or file, what was given, what is allowed. Nothing has been written."""

    exit_code = 2


def require(owner: object, name: str, holds: bool, allowed: str) -> None:
    """Refuse the value of an argument unless something ``holds`` of it.

    Raises:
        InputError: one line with the owner, the argument, what was given and what is ``allowed``.
    """
    if not holds:
        raise InputError(f"{type(owner).__name__}: {name} = {shown(getattr(owner, name))}: must be {allowed}")


def shown(value: Any) -> str:
    """A value for a message: in one line, and not a long one."""
    text = " ".join(repr(value).split())
    return text if len(text) <= LONGEST_VALUE else f"{text[:LONGEST_VALUE]}..."


def number(value: Any) -> float:
    """A value as a number; NaN, which is within no bounds, where it is none, such as a text or a list."""
    return float(value) if isinstance(value, Real) else float("nan")


def numbers(values: Any, count: int) -> tuple[float, ...]:
    """A sequence as so many numbers; NaN where it is something else, such as a text, or of another length."""
    one_each = isinstance(values, Iterable) and not isinstance(values, str) and len(listed := list(values)) == count
    return tuple(number(value) for value in listed) if one_each else (float("nan"),) * count


class DivergenceError(WarpsphError):
    """The simulation left the physical range: which particle, where, which quantity, at what time."""

    exit_code = 3
