"""Compensated summation (Kahan): sums of tiny increments that single precision alone would lose."""

from typing import Any

import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.func
def compensated_sum(value: Any, increment: Any, carry: Any):
    """Add ``increment`` to ``value``.

    Args:
        value: the running sum (float or vec3).
        increment: what to add.
        carry: what earlier additions lost.

    Returns:
        The new sum and the new carry.
    """
    corrected = increment - carry
    total = value + corrected
    return total, (total - value) - corrected
