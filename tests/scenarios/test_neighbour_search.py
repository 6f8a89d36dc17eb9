"""The neighbour list against brute force, while particles drift."""

import pytest

from warpsph.scenarios.neighbour_search import NeighbourSearch


@pytest.mark.parametrize("centre", [-3.0, 0.0, 50.0])
@pytest.mark.parametrize("arrangement", ["random", "lattice", "coincident"])
@pytest.mark.parametrize("dimension", [2, 3])
def test_list_equals_brute_force(dimension, arrangement, centre, device):
    """Otherwise forces between some neighbours would be missing or counted twice."""
    scenario = NeighbourSearch(dimension=dimension, arrangement=arrangement, centre=centre, count=700, duration=0.5)
    result = scenario.run(device=device)
    assert all(check.passed for check in scenario.checks(result))
    assert result.diagnostics["pairs"].min() > 1000
    assert result.diagnostics["renewals"][-1] > 2


def test_two_particles_alone(device):
    """Otherwise a list of next to nothing would fail."""
    scenario = NeighbourSearch(count=2, duration=0.1)
    assert all(check.passed for check in scenario.checks(scenario.run(device=device)))
