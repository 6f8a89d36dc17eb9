"""The ledgers of a run: what is there at the end is what was there at the start, and what has come in."""

import warnings
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsph.core.content import Content

if TYPE_CHECKING:  # not at run time: Warp takes long to import, and help must appear at once
    from warpsph.core.model import Model
    from warpsph.core.state import State


@dataclass(frozen=True)
class Ledger:
    """One conserved quantity over a run; in 2D amounts are per metre of depth.

    Attributes:
        quantity, unit: what it is.
        start, end: how much there was and is.
        gains: how much has come in, by way; negative where it went out.
        error: what is missing or too much, over the gross amount; each particle's own, where each keeps its own.
        rounding: the most that single precision explains.
    """

    quantity: str
    unit: str
    start: float
    end: float
    gains: dict[str, float]
    error: float
    rounding: float

    @property
    def closes(self) -> bool:
        """Whether nothing has been lost or made."""
        return abs(self.error) <= self.rounding

    def __str__(self) -> str:
        ways = "".join(f", {gain:+.6g} {self.unit} by {way}" for way, gain in self.gains.items() if gain)
        verdict = "closes to" if self.closes else "does not close: off by"
        return f"{self.start:.6g} {self.unit}{ways}, now {self.end:.6g} {self.unit}; {verdict} {abs(self.error):.1e}"


class Ledgers:
    """Remembers what there was at the start.

    Args:
        model, state: the case and its particles.
    """

    def __init__(self, model: "Model", state: "State"):
        self.model, self.state = model, state
        self._start: dict[str, Any] = {}

    def open(self) -> None:
        """Take what there is now for the start."""
        gains = self._gains()
        for name, content in self._contents().items():
            came = sum(gains.get(name, {}).values())
            self._start[name] = (content.amount - came, content.gross)

    def close(self) -> list[Ledger]:
        """The ledgers of all quantities from the start to now."""
        gains, ledgers = self._gains(), []
        for name, content in self._contents().items():
            if name in self._start:
                start, gross = self._start[name]
                ledgers.append(_ledger(name, content, start, gross, gains.get(name, {})))
        return ledgers

    def memory(self) -> dict[str, Any]:
        return {"start": dict(self._start)}

    def restore(self, memory: dict[str, Any]) -> None:
        self._start = dict(memory["start"])

    def _contents(self) -> dict[str, Content]:
        return {
            name: content
            for term in self.model.terms
            for name, content in term.contents(self.model, self.state).items()
        }

    def _gains(self) -> dict[str, dict[str, Any]]:
        gains: dict[str, dict[str, Any]] = {}
        for term in self.model.terms:
            for name, ways in term.gains(self.state).items():
                gains.setdefault(name, {}).update(ways)
        return gains


def warn_of_open(ledgers: Iterable[Ledger]) -> None:
    """Warn of each ledger that does not close."""
    for ledger in ledgers:
        if not ledger.closes:
            warnings.warn(f"the ledger of {ledger.quantity} does not close: {ledger}", stacklevel=3)


def _ledger(name: str, content: Content, start: Any, gross: float, gains: dict[str, Any]) -> Ledger:
    came = sum(gains.values())
    off = content.amount - start - came
    turnover = sum(float(np.sum(np.abs(gain))) for gain in gains.values())
    scale = max(gross, content.gross, turnover)
    return Ledger(
        quantity=name,
        unit=content.unit,
        start=float(np.sum(start)),
        end=float(np.sum(content.amount)),
        gains={way: float(np.sum(gain)) for way, gain in gains.items()},
        error=float(np.sum(np.abs(off)) if np.ndim(off) else off) / scale if scale > 0.0 else 0.0,
        rounding=content.rounding,
    )
