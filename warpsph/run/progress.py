"""What a run reports of itself."""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass
class Progress:
    """Where a run stands: physical time and its end [s], steps done, speed, wall time left [s], and a note."""

    time: float
    duration: float
    steps: int
    steps_per_second: float
    seconds_left: float
    note: str = ""


Report = Callable[[Progress], None]
