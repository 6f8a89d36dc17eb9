"""Freezing from a cold face: as published, by the default, with unequal phases."""

import numpy as np
import pytest

from warpsph.cases.case import preset_layer, resolve
from warpsph.core.executor import Executor
from warpsph.errors import InputError
from warpsph.scenarios.freezing.numerics import Phases
from warpsph.scenarios.freezing.stefan_slab import StefanSlab


def case(*presets: str, **changes) -> StefanSlab:
    layers = [preset_layer(StefanSlab, preset) for preset in presets]
    return resolve(StefanSlab, layers).model_copy(update={"columns": 6} | changes)


def test_the_published_run(device):
    """Otherwise the paper's method would not be what the preset runs: its steps, its front, its mushy row."""
    paper = case("paper")
    result = paper.run(device=device)
    assert result.steps == 400
    assert [check for check in paper.checks(result) if not check.passed] == []
    f = result.fields["solid_fraction"]
    mushy = (f > 0.0) & (f < 1.0)
    assert np.unique(np.round(result.positions[mushy, 1], 4)) == pytest.approx([9.0 / 39.0], abs=1e-4)
    assert f[mushy] == pytest.approx(np.full(6, 0.66), abs=0.01)


@pytest.mark.parametrize("presets", [(), ("unequal",)], ids=["equal", "unequal"])
def test_the_default(device, presets):
    """A front in a particle that let too much heat pass, or too little, would show where the phases differ."""
    slab = case(*presets)
    result = slab.run(device=device)
    assert [check for check in slab.checks(result) if not check.passed] == []
    columns = result.fields["temperature"][np.argsort(result.positions[:, 1], kind="stable")].reshape(40, 6)
    assert np.ptp(columns, axis=1).max() < 1e-5
    taken = result.diagnostics["heat_cold"][-1] / (6 * slab.spacing)
    lost = slab.heat_capacity_liquid * (slab.start - slab.melting) + slab.latent_heat
    lost += slab.heat_capacity_solid * (slab.melting - slab.exact.plane)
    half_row = 0.5 * slab.spacing * slab.density * lost  # on the face, cold from the start
    assert taken + half_row == pytest.approx(slab.exact.heat(result.time), rel=0.02)


def test_water(device):
    """If it failed, the slab would have one height only, or one kind of substance; ice 8 cm thick in half a day."""
    slab = case("water")
    result = slab.run(device=device)
    assert [check for check in slab.checks(result) if not check.passed] == []
    assert result.diagnostics["exact_front"][-1] == pytest.approx(0.0821, abs=1e-4)


def test_the_same_slab_in_another_size(device):
    """If it failed, a length of one metre would be left somewhere: twice the height takes four times as long."""
    slabs = [case(height=size, duration=size**2 * 0.02, output_interval=size**2 * 0.02) for size in (1.0, 2.0)]
    one, two = (slab.run(device=device).diagnostics for slab in slabs)
    assert two["front"][-1] == pytest.approx(2.0 * one["front"][-1], rel=1e-5)
    assert two["temperature_error"][-1] == pytest.approx(one["temperature_error"][-1], rel=1e-3)
    for name in ("heat", "heat_cold", "heat_warm"):  # a breadth of so many columns, a height: the square
        assert two[name][-1] == pytest.approx(4.0 * one[name][-1], rel=1e-4, abs=1e-4)


@pytest.mark.parametrize("name", ["density", "conductivity_liquid", "latent_heat"])
def test_numbers_that_single_precision_loses_are_refused(name):
    """If it failed, a run would divide zero by zero and leave a file of numbers that are none."""
    with pytest.raises(InputError, match=r"must be (zero, or )?from 1e-06 to 1e\+09|in single precision"):
        case(**{name: 1e-300}).build(Executor("cpu"))


def test_both_ways_of_latent_heat_agree_where_phases_conduct_alike(device):
    """Heat stored until the phase flips, and the enthalpy curve, are then the same bookkeeping."""
    stored, curve = (case(phases=phases, particles=20).run(device=device) for phases in (Phases.STORED, Phases.CURVE))
    assert stored.fields["temperature"] == pytest.approx(curve.fields["temperature"], abs=1e-6)
    assert stored.fields["solid_fraction"] == pytest.approx(curve.fields["solid_fraction"], abs=1e-6)


def test_a_front_in_the_particles_is_worth_its_while(device):
    """With unequal phases the published way was off by 2.3 %, the curve by 0.8 %, a front by 0.5 %."""
    errors = [
        case("unequal", phases=phases).run(device=device).diagnostics["temperature_error"][-1]
        for phases in (Phases.FRONT, Phases.CURVE, Phases.STORED)
    ]
    assert errors[0] < 0.7 * errors[1] < 0.4 * errors[2]


@pytest.mark.slow
def test_every_check_passes():
    """Otherwise `warpsph verify` would fail."""
    failed = [check for check in StefanSlab.verify(lambda case: case.run(device="cpu"), True) if not check.passed]
    assert failed == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"start": 0.9}, "start = 0.9 K: must lie above melting, 1.0 K"),
        ({"similarity": 2.0}, "asks for a cold face of -"),
        ({"particles": 5}, "particles = 5"),
        ({"phases": "mush"}, "phases = 'mush'"),
    ],
)
def test_wrong_input_is_refused_in_one_line(changes, words):
    """A traceback, or a run that melts what it should freeze, would not tell what is wrong."""
    with pytest.raises(InputError, match=words) as caught:
        StefanSlab(**changes)
    assert "\n" not in str(caught.value)
