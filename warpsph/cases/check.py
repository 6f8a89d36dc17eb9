"""A measured value beside its reference: one row of ``warpsph verify``."""

from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Check:
    """One verified quantity.

    ``reference`` is None where the measured value itself is an error that must stay within ``tolerance``; otherwise
    the error is ``|measured - reference|``, divided by ``|reference|`` when ``relative``.

    Args:
        case: name of the scenario.
        quantity: what was measured, in a few words.
        unit: unit of measured and reference, "" where it has none.
        measured: the simulated value.
        reference: the exact or published value, or None.
        tolerance: largest accepted error.
        source: where the reference comes from.
        relative: whether error and tolerance are relative to the reference.
        reason: why this tolerance: the error that the method is expected to have at this resolution.
    """

    case: str
    quantity: str
    unit: str
    measured: float
    reference: float | None
    tolerance: float
    source: str
    relative: bool = True
    reason: str = ""

    @property
    def error(self) -> float:
        if self.reference is None:
            return abs(self.measured)
        difference = abs(self.measured - self.reference)
        return difference / abs(self.reference) if self.relative else difference

    @property
    def passed(self) -> bool:
        return self.error <= self.tolerance

    def as_dict(self) -> dict:
        """The row as ``warpsph verify --json`` writes it."""
        return asdict(self) | {"error": self.error, "passed": self.passed}
