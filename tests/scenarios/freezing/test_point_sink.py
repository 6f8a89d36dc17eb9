"""Freezing around a point sink: radius, heat, temperatures, and the published errors."""

import pytest

from warpsph.cases.case import preset_layer, resolve
from warpsph.errors import DivergenceError, InputError
from warpsph.scenarios.freezing.point_sink import TABLE, PointSink


@pytest.mark.parametrize("presets", [(), ("strong",), ("paper",)], ids=["default", "strong", "paper"])
def test_the_ice_is_where_it_must_be(device, presets):
    """A sink that takes too much, or ice that holds too little, would move the front."""
    case = resolve(PointSink, [preset_layer(PointSink, preset) for preset in presets])
    result = case.run(device=device)
    assert [check for check in case.checks(result) if not check.passed] == []
    if presets == ("paper",):
        assert result.steps == 3000


def test_half_of_the_published_errors(device):
    """Otherwise the default would be worth no more than what was published."""
    case = PointSink()
    assert case.radius_errors(case.run(device=device))["radius"] < 0.5 * min(TABLE[40])


def test_the_published_errors(device):
    """Otherwise the preset would run another method than the paper's; the finer rows of its table are slow."""
    for n in (20, 30):
        case = resolve(PointSink, [preset_layer(PointSink, "paper")]).model_copy(update={"particles": n})
        found = case.radius_errors(case.run(device=device))
        assert found["radius_of_ice"] < 1.15 * TABLE[n][0]
        assert found["radius_of_loss"] < 1.15 * TABLE[n][1]


@pytest.mark.slow
def test_every_check_passes():
    """Otherwise `warpsph verify` would fail."""
    failed = [check for check in PointSink.verify(lambda case: case.run(device="cpu"), True) if not check.passed]
    assert failed == []


def test_water_that_starts_frozen_is_refused():
    """There would be no front."""
    with pytest.raises(InputError, match=r"start = 270.0 K: must lie above melting, 273.15 K") as caught:
        PointSink(start=270.0)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("similarity", [0.5, 2.0])
def test_sinks_that_would_take_all_heat_are_refused(similarity):
    """If it failed, a run would go on below 0 K."""
    with pytest.raises(
        InputError, match=r"has fallen to -.* K at a smoothing length, 0.0256 m, from the sink; a small"
    ):
        PointSink(similarity=similarity)


def test_a_run_that_falls_below_zero_is_stopped(device):
    """If it failed, temperatures that do not exist would be written; the exact solution has 13 K at h yet."""
    with pytest.raises(DivergenceError, match=r"has temperature -.* K, must be above -") as caught:
        PointSink(similarity=0.43, output_interval=2e4).run(device=device)
    assert "more heat is taken" in caught.value.facts["usual cause"]
