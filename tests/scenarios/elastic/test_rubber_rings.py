"""Two rings of rubber that collide."""

import numpy as np

from warpsph.core.executor import Executor
from warpsph.scenarios.elastic.rubber_rings import RubberRings


def bonds(simulation) -> set[tuple[int, int]]:
    """Pairs of ids that share a bond."""
    state = simulation.state
    ids, count = state.numpy("id"), state.bonds.count.numpy()
    partner = state.bonds.partner.numpy().reshape(len(ids), -1)
    return {(int(ids[i]), int(ids[j])) for i in range(len(ids)) for j in partner[i, : count[i]]}


def test_rings_bounce_and_stay_whole(device):
    """Rings that stick, break, drift or lose energy would show that contact or elasticity is wrong."""
    scenario = RubberRings(layers=4)
    simulation = scenario.build(Executor(device, 1))
    simulation.prepare()
    before = bonds(simulation)
    result = simulation.run(scenario.duration, scenario.output_interval)
    inner = outer = len(result.positions) // 2  # of four layers
    assert len(before) == 8 * inner + 5 * outer
    assert bonds(simulation) == before
    checks = scenario.checks(result)
    assert len(checks) == 4
    assert all(check.passed for check in checks)
    assert 0.7 < scenario.restitution(result) < 0.95
    assert result.diagnostics["gap"][-1] > 0.5 * scenario.outer_radius
    assert result.diagnostics["gap"].min() > scenario.spacing


def test_rings_that_have_not_met_keep_their_speed(device):
    """Contact at a distance would slow the rings before they meet."""
    scenario = RubberRings(layers=4, gap=0.02, duration=0.001)
    result = scenario.run(device=device, threads=1)
    assert np.allclose(result.diagnostics["separation_speed"], -2.0 * scenario.flight_speed)
    assert len(scenario.checks(result)) == 3


def test_the_area_of_a_ring_is_exact():
    """Wrong volumes would give the rings a wrong mass and stiffness."""
    scenario = RubberRings(layers=5)
    place, volume = scenario.ring()
    assert np.isclose(volume.sum(), np.pi * (0.04**2 - 0.03**2))
    assert np.allclose(place.sum(axis=0), 0.0)
