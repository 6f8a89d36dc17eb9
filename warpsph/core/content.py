"""What a simulation holds of a conserved quantity."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Content:
    """How much of a conserved quantity there is.

    Args:
        amount: a number, or one for each particle by its id (n,), where each keeps its own.
        gross: the sum of all amounts without their signs, with which errors are compared.
        unit: SI unit; in 2D all are per metre of depth.
        rounding: by how much the ledger may be off, relative, for what single precision loses.
    """

    amount: float | np.ndarray
    gross: float
    unit: str
    rounding: float
