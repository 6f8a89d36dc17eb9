"""The crucible of particles: what stands where, and its temperature against finite volumes."""

from collections import Counter

import numpy as np
import pytest

from warpsph.cases.case import preset_layer, resolve
from warpsph.errors import InputError
from warpsph.scenarios.crystal.crystal_growth import CrystalGrowth


def coarse(**values) -> CrystalGrowth:
    layer = preset_layer(CrystalGrowth, "coarse")
    return resolve(CrystalGrowth, [layer, type(layer)("test", values)])


def test_as_many_particles_as_published():
    """Another geometry would have another temperature."""
    case = CrystalGrowth()
    assert case.shape == (27, 102)
    counts = Counter(case.material_at(case.points))
    assert counts == {"quartz": 27 * 4 + 2 * 98, "germanium": 25 * 26, "solution": 25 * 64, "silicon": 25 * 8}
    assert sum(counts.values()) == 2754  # Rook, Yildiz & Dost (2007), section 5


@pytest.mark.parametrize("integrator", ["explicit", "backward_euler", "crank_nicolson"])
def test_the_crucible_follows_finite_volumes(device, integrator):
    """A wall that took the furnace of another height would miss the reference long before the end.

    Within 60 s the temperature moves by more than 40 K from that of the furnace. The checks allow 2 K; explicitly and
    by Crank and Nicolson the root mean square is 0.23 K.
    """
    case = coarse(integrator=integrator, duration=60.0, output_interval=20.0)
    result = case.run(device=device, threads=1)
    moved = result.fields["temperature"] - case.furnace.at(result.positions, 0.0)
    assert np.abs(moved).max() > 40.0
    checks = case.checks(result)
    assert len(checks) == 6
    assert [check for check in checks if not check.passed] == []
    assert checks[0].measured < (1.0 if integrator == "backward_euler" else 0.3)


def test_the_interface_at_the_end():
    """What is published is the shape of the interface after half an hour; it is the same from 10 minutes on."""
    case = coarse(step=30.0, duration=900.0)
    result = case.run(device="cpu", threads=1)
    assert [check for check in case.checks(result) if not check.passed] == []
    interface = 1e3 * result.diagnostics["interface"][-1]
    assert np.all(np.diff(interface) > 0.0)  # concave
    assert interface[[0, -1]] == pytest.approx([14.21, 16.85], abs=0.02)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"spacing": 3e-4}, "crystal_growth: charge_half_width = 0.0125 m is 41.6667 spacings of 0.0003 m"),
        ({"crucible_wall": 2e-4}, "crucible_wall = 0.0002 m is 0.4 spacings"),
        ({"furnace_places": (0.0, 0.0)}, "furnace_places = .*: must be one or more heights that rise"),
        ({"furnace_places": (0.0, 0.1)}, "furnace_temperatures = .*: must be 2 positive temperatures"),
        ({"furnace_temperatures": (1.0, 2.0, 3.0, -4.0)}, "furnace_temperatures = .*: must be 4 positive"),
        ({"furnace_places": "low"}, "crystal_growth: furnace_places = 'low'"),
        ({"side_conductance": 0.0}, "crystal_growth: side_conductance = 0.0: .*greater than 0"),
    ],
)
def test_wrong_parameters_are_refused_in_one_line(values, words):
    """A crucible that is not what was asked for would be simulated without a word."""
    with pytest.raises(InputError, match=words) as caught:
        CrystalGrowth(**values)
    assert "\n" not in str(caught.value)
