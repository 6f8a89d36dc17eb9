"""The way from one particle to another, with and without a periodic box."""

import numpy as np
import pytest
import warp as wp

from warpsph.kernels.neighbours.pairs import NeighbourList, difference, difference_of_doubles, precise_difference

PERIOD = np.array([1.25, 0.0, 0.7])


@wp.kernel
def take_ways(
    neighbours: NeighbourList,
    x: wp.array[wp.vec3],
    x_carry: wp.array[wp.vec3],
    y: wp.array[wp.vec3d],
    way: wp.array[wp.vec3],
    way_of_doubles: wp.array[wp.vec3d],
    precise_way: wp.array[wp.vec3],
):
    i = wp.tid()
    j = x.shape[0] - 1 - i
    way[i] = difference(neighbours, x[i], x[j])
    way_of_doubles[i] = difference_of_doubles(neighbours, y[i], y[j])
    precise_way[i] = precise_difference(neighbours, x, x_carry, i, j)


def ways(device: str, periodic: bool, y: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The ways (n, 3) [m] by the three functions from the last of the places y (n, 3) to the first, and so on."""
    n, rows = len(y), NeighbourList()
    if periodic:
        rows.periodic, rows.period = -1, wp.vec3(*PERIOD)
        rows.inverse_period = wp.vec3(*np.divide(1.0, PERIOD, out=np.zeros(3), where=PERIOD > 0.0))
    x = y.astype(np.float32)
    given = [
        wp.array(x, dtype=wp.vec3, device=device),
        wp.array(x - y, dtype=wp.vec3, device=device),
        wp.array(y, dtype=wp.vec3d, device=device),
    ]
    found = [wp.zeros(n, dtype=kind, device=device) for kind in (wp.vec3, wp.vec3d, wp.vec3)]
    wp.launch(take_ways, n, inputs=[rows, *given], outputs=found, device=device)
    single, double, precise = (array.numpy() for array in found)
    return single, double, precise


def places() -> np.ndarray:
    """Places (200, 3) [m], by pairs from outside in."""
    return np.random.default_rng(3).uniform(-0.6, 0.6, (200, 3))


def test_without_a_period_it_is_the_plain_difference(device):
    """Cases without a periodic box would change their bits, and with them every number that was measured."""
    y = places()
    x = y.astype(np.float32)
    single, double, precise = ways(device, False, y)
    carry = (x - y).astype(np.float32)
    assert np.array_equal(single, x - x[::-1])
    assert np.array_equal(double, y - y[::-1])
    assert np.array_equal(precise, (x - x[::-1]) - (carry - carry[::-1]))


def test_it_leads_to_the_nearest_image(device):
    """A pair across the border would see each other from the far side, or not at all."""
    y = places()
    periods = np.array(np.meshgrid(*[np.arange(-2, 3)] * 3)).reshape(3, 125).T * np.float32(PERIOD)
    images = (y - y[::-1])[:, None] - periods
    nearest = images[np.arange(len(y)), np.argmin(np.linalg.norm(images, axis=2), axis=1)]
    for way in ways(device, True, y):
        assert np.allclose(way, nearest, atol=2e-7)


def test_it_is_opposite_for_the_other_one(device):
    """Forces of a pair would not cancel: a flow through the border would gain momentum."""
    for way in ways(device, True, places()):
        assert np.array_equal(way, -way[::-1])


@pytest.mark.parametrize("periodic", [False, True])
def test_a_small_difference_is_precise(device, periodic):
    """Strain is such a difference: bonds across the border would be as rough as single precision is a period away."""
    generator = np.random.default_rng(4)
    small = generator.uniform(-1.0e-3, 1.0e-3, (100, 3))
    periods = generator.integers(-1, 2, (100, 3)) * np.float32(PERIOD) * periodic
    one = places()[:100]
    y = np.concatenate([one, (one - small - periods)[::-1]])
    _, _, precise = ways(device, periodic, y)
    assert np.allclose(precise[:100], small, rtol=0.0, atol=3e-10)
