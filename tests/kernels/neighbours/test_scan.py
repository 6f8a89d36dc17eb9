"""Running sums."""

import numpy as np
import pytest
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.launch import Launch
from warpsph.kernels.neighbours.scan import PARTS, sum_before_parts, sum_parts, sum_within_parts


@pytest.mark.parametrize("length", [1, 2, PARTS - 1, PARTS, PARTS + 1, 5 * PARTS + 17, 100_003])
def test_running_sum(device, length):
    """If it failed, particles would be put into the wrong cells."""
    numbers = np.random.default_rng(length).integers(0, 50, length)
    values = wp.array(numbers, dtype=int, device=device)
    launch = Launch(Executor(device), length, {"values": values, "parts": wp.zeros(PARTS, dtype=int, device=device)})
    launch(sum_parts, PARTS)
    launch.whole(sum_before_parts)
    launch(sum_within_parts, PARTS)
    assert np.array_equal(values.numpy(), np.cumsum(numbers))
