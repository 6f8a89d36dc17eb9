"""The casting machine, coarse and short."""

import numpy as np
import pytest

from warpsph.cases.case import preset_layer, resolve
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.errors import InputError
from warpsph.machine import Spray
from warpsph.scenarios.casting.casting import Casting

COARSE = {"spacing": 0.004, "duration": 0.45, "output_interval": 0.15}


@pytest.fixture(scope="module", params=["published", "corrected"])
def result(request):
    return Casting(**COARSE, formulation=request.param).run(device="cpu")


def test_ledgers_close(result):
    """Mass or heat from nowhere would decide over holes and shells."""
    checks = {check.quantity: check for check in Casting(**COARSE).checks(result)}
    for quantity in (
        "particles lost (inside - start - in + out)",
        "ids that are missing or doubled",
        "enthalpy ledger",
    ):
        assert checks[quantity].passed, checks[quantity]
    assert result.diagnostics["particles_in"][-1] > 0
    assert result.diagnostics["particles_out"][-1] > 0
    assert result.diagnostics["heat_mould"][-1] > 0
    assert result.diagnostics["heat_spray"][-1] > 0


def test_there_is_a_shell_that_grows_downwards(result):
    """A strand without a shell is a bath."""
    thickness = result.diagnostics["shell_thickness"][-1]
    assert thickness[0] > 0.012
    assert np.mean(thickness[:5]) > np.mean(thickness[10:15]) > np.mean(thickness[17:])
    solid = (result.fields["phase"] == Phase.SOLID) & (result.fields["role"] == Role.FREE)
    assert np.min(result.positions[solid, 0]) > 0.5 * 0.1


def test_level_and_speed_stay(result):
    """A level that runs away at once would never come to rest."""
    assert np.all(np.abs(result.diagnostics["level"] - 0.44) < 0.02)
    assert np.all(np.abs(result.diagnostics["casting_speed"] - 0.01) < 0.0005)


@pytest.mark.slow
def test_the_melt_keeps_its_volume():
    """Melt that is shifted towards the shell must flow off it, as if the shell gave volume: 2.6 % in a second."""
    diagnostics = Casting(formulation="corrected", duration=0.8, output_interval=0.4).run(device="cpu").diagnostics
    # the meniscus by weight and by place; a spacing for the swell of the start, of which there were 0.2 mm, and 9.4 mm
    # with shifting into the shell
    assert abs(diagnostics["meniscus"][-1] - diagnostics["level"][-1]) < 0.004


def test_threads_do_not_change_a_bit(result, request):
    """Inlet, outflow, spray and phase change must be as reproducible as the flow."""
    formulation = request.node.callspec.params["result"]
    other = Casting(**COARSE, formulation=formulation).run(device="cpu", threads=1)
    assert np.array_equal(result.positions, other.positions)
    for name, values in result.fields.items():
        assert np.array_equal(values, other.fields[name], equal_nan=True), name


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("roll_radius", 0.03),
        ("roll_radius", 0.001),
        ("level", 0.6),
        ("nozzle_mouth", 0.1),
        ("nozzle_mouth", 0.45),
        ("nozzle_width", 0.06),
        ("roll_first", 0.3),
        ("pouring_temperature", 1700.0),
    ],
)
def test_machines_that_cannot_work_are_refused(key, value):
    """A nozzle in the air or a roll in the mould would only show as nonsense after hours."""
    with pytest.raises(InputError, match=key):
        Casting(**{key: value})


def test_failing_sprays_are_an_event_and_stop():
    """A breakout without the failure that caused it in the file could not be explained."""
    case = Casting(**COARSE | {"spray_failure": 0.2, "spray_failing": (1, 3)})
    simulation = case.build(Executor("cpu"))
    result = simulation.run(0.45, 0.15)
    assert result.events == [(0.2, "sprays fail in zone 1, 3")]
    spray = simulation.model.the(Spray)
    numbers = {1: 0, 2: 0, 3: 0}
    for stretch, sprayed in zip(spray.zones, spray.sprayed.numpy(), strict=True):
        numbers[case.zone_at(0.5 * (stretch.low + stretch.high))] += sprayed
    lengths = {zone: sum(s.high - s.low for s in spray.zones if case.zone_at(s.low) == zone) for zone in numbers}
    assert numbers[1] / lengths[1] == pytest.approx(numbers[3] / lengths[3], abs=60.0)
    assert numbers[2] / lengths[2] > 1.5 * numbers[1] / lengths[1]
    assert result.diagnostics["missing_water"][-1] == result.diagnostics["missing_melt"][-1] == 0


def test_a_run_says_that_it_is_not_yet_steady(result):
    """Otherwise the shell that the start was given would pass for one that the run has made."""
    assert "not yet steady (the start's strand is gone at 44 s)" in result.summary["at the end"]


def test_a_strand_that_has_passed_through_is_an_event():
    """Otherwise nobody would know from when on a result is that of the machine."""
    case = Casting(**COARSE)
    simulation = case.build(Executor("cpu"))
    observe, describe = simulation.recorder.observe, simulation.recorder.describe
    for time in (0.5 * case.passage, case.passage, 2.0 * case.passage):
        values = {name: given.value for name, given in observe(simulation.snapshot(), time).items()}
        assert ("not yet steady" in describe(values | {"time": time})) == (time < case.passage)
    assert [time for time, text in simulation.events.all if "passed through" in text] == [case.passage]


def test_zones_that_fail_must_be_there():
    """A failure that no zone has would be a control run by mistake; without one the default does not matter."""
    with pytest.raises(InputError, match="spray_failing"):
        Casting(spray_failure=1.0, spray_failing=(4,))
    Casting(spray_zones=1)


@pytest.mark.parametrize("change", [{}, {"spray_zones": 20}, {"roll_first": 0.07}])
def test_the_billet_begins(change):
    """Its mould has more particles within reach of one than any other case."""
    case = resolve(Casting, [preset_layer(Casting, "billet")]).model_copy(update=change)
    result = case.model_copy(update={"duration": 0.01, "output_interval": 0.005}).run(device="cpu")
    assert result.status == "complete"
    assert result.diagnostics["water_inside"][-1] == 0.0
    assert np.isfinite(result.diagnostics["shell_thickness"][-1]).all()
