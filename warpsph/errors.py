"""The errors that a user can cause or must know of; the command line turns each into its exit code."""

from collections.abc import Iterable, Mapping
from numbers import Real
from typing import Any

LONGEST_VALUE = 80  # letters
LONGEST_MESSAGE = 3000  # letters: more than any list of allowed names has
UNPRINTABLE = "\N{REPLACEMENT CHARACTER}"


class WarpsphError(Exception):
    """Base of the errors that warpsph raises on purpose; its text is one line a user can act on.

    Whatever of the input is in the text, no control character and no endless value of it reaches a terminal.
    """

    exit_code = 1

    def __init__(self, message: str = "") -> None:
        lines = "\n".join(printable(line) for line in str(message).split("\n"))
        super().__init__(middle_cut(lines, LONGEST_MESSAGE))


class InputError(WarpsphError):
    """The input is wrong: which key or file, what was given, what is allowed. Nothing has been written."""

    exit_code = 2

    def __init__(self, message: str = "") -> None:
        super().__init__(" ".join(str(message).splitlines()))  # a value of the input may have lines


def require(owner: object, name: str, holds: bool, allowed: str) -> None:
    """Refuse the value of an argument unless something ``holds`` of it.

    Raises:
        InputError: one line with the owner, the argument, what was given and what is ``allowed``.
    """
    if not holds:
        raise InputError(f"{type(owner).__name__}: {name} = {shown(getattr(owner, name))}: must be {allowed}")


def shown(value: Any) -> str:
    """A value for a message: in one line, and not a long one."""
    try:
        text = " ".join(repr(value).split())
    except (ValueError, RecursionError):  # an integer of thousands of digits; lists in lists in lists
        return f"a {type(value).__name__} too long to be shown"
    return cut(text, LONGEST_VALUE)


def printable(text: str) -> str:
    """A text in one line without what would steer a terminal, turn the writing around, or not be encodable."""
    if text.isprintable():
        return text
    spaced = (" " if letter.isspace() else letter for letter in text)
    return "".join(letter if letter.isprintable() else UNPRINTABLE for letter in spaced)


def cut(text: str, longest: int) -> str:
    """The beginning of a text, with dots where it goes on."""
    return text if len(text) <= longest else f"{text[:longest]}..."


def middle_cut(text: str, longest: int) -> str:
    """A text without its middle where it is too long: what is wrong stands at its beginning, the remedy at its end."""
    return text if len(text) <= longest else f"{text[: longest // 2]} ... {text[-longest // 2 :]}"


def number(value: Any) -> float:
    """A value as a number; NaN, which is within no bounds, where it is none, such as a text or a list."""
    return float(value) if isinstance(value, Real) else float("nan")


def numbers(values: Any, count: int) -> tuple[float, ...]:
    """A sequence as so many numbers; NaN where it is something else, such as a text, or of another length."""
    one_each = isinstance(values, Iterable) and not isinstance(values, str) and len(listed := list(values)) == count
    return tuple(number(value) for value in listed) if one_each else (float("nan"),) * count


class DivergenceError(WarpsphError):
    """The simulation left the physical range: which particle, where, which quantity, at what time.

    Args:
        message: that, in one line.
        facts: what else helps to understand it, a text by a few words; whoever knows more may add to it.
    """

    exit_code = 3

    def __init__(self, message: str, facts: Mapping[str, str] | None = None) -> None:
        super().__init__(message)
        self.facts = dict(facts or {})
