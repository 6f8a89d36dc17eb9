"""What the values of a field lie between as long as a run is sound."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Bound:
    """Values at which a run counts as diverged.

    Args:
        lower, upper: what no value may reach; infinite by default, which asks for numbers only.
        cause: what usually makes a value leave it, and what to do.
    """

    lower: float = -np.inf
    upper: float = np.inf
    cause: str = ""
