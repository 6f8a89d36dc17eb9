"""Parameters that are each within their bounds, and together cannot work, are refused in one line."""

import os
from typing import Any, Literal, get_args, get_origin

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import warpsph.scenarios  # noqa: F401  registers them
from warpsph.cases.scenario import Scenario, registered_scenarios
from warpsph.core.executor import Executor
from warpsph.errors import DivergenceError, InputError

SCENARIOS = registered_scenarios()
CAMPAIGN = int(os.environ.get("WARPSPH_CAMPAIGN", "10"))  # cases; thousands in a campaign
QUICK = sorted(SCENARIOS.keys() - {"casting", "breakout"})  # these reckon their shells for seconds
DRAWN = QUICK if CAMPAIGN < 100 else sorted(SCENARIOS)
SMALL_MACHINE = 2.0e7  # bytes, so that no case is large


@pytest.fixture(scope="module")
def executor() -> Executor:
    return Executor("cpu", 1)


@pytest.fixture
def small_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("capacity", "footprint"):
        monkeypatch.setattr(f"warpsph.core.{module}.free_memory", lambda: SMALL_MACHINE)


REFUSED = [
    ("heat_gaussian", {"edge": 10.0, "spacing": 0.001}, "of memory are needed"),
    ("casting", {"spacing": 0.0002, "dimension": 3}, "spacing = 0.0002.*of memory are needed"),
    ("rubber_rings", {"inner_radius": 0.999, "outer_radius": 1.0, "layers": 100}, "two rings of .*memory"),
    ("taylor_green", {"rows": 2000}, "of memory are needed"),
    ("casting", {"casting_speed": 1e-5}, "casting_speed = 1e-05"),
    ("casting", {"roll_pitch": 1e-6}, "roll_pitch of 1e-06"),
    ("breakout", {"roll_pitch": 1e-30}, "roll_pitch of 1e-30"),
    ("casting", {"spray_flux": 50.0, "spray_particle": 1e-12, "spray_speed": 20.0}, "a spray_particle of"),
    ("casting", {"nozzle_mouth": 0.45}, "nozzle_mouth = 0.45: must lie in the melt"),
    ("casting", {"spray_failure": 1.0, "spray_failing": (4,)}, "spray_failing = .*spray_zones 3"),
    ("casting", {"spacing": 0.01, "roll_radius": 0.016}, "less than 2 spacings of 10 mm|nozzle|sound"),
    ("casting", {"level": 0.6}, "level = 0.6: must lie between"),
    ("rubber_rings", {"inner_radius": 0.05}, "inner_radius = 0.05: must be less than outer_radius"),
    ("cantilever", {"thickness": 0.99}, "thickness = 0.99: a plate as short as"),
    ("cantilever", {"youngs_modulus": 1e-30}, "youngs_modulus = 1e-30"),
    ("heat_gaussian", {"spacing": 0.05, "duration": 1e-15}, r"duration = 1e-15 s \(--until\)"),
    ("heat_gaussian", {"spacing": 0.05, "rise": 1e-30}, "rise = 1e-30"),
    ("heat_gaussian", {"spacing": 0.05, "output_interval": 1e-9}, "longer output_interval"),
    ("hydrostatic", {"rows": 10, "columns": 6, "step_factor": 9e-9}, "longer steps .*sound and viscosity"),
]


@pytest.mark.parametrize(("name", "values", "words"), REFUSED, ids=lambda value: str(value)[:60])
def test_what_cannot_work_is_refused(small_machine, executor: Executor, name: str, values: dict[str, Any], words: str):
    """If it failed, a case would take all memory, never begin, never end, or end in a traceback."""
    with pytest.raises(InputError, match=words) as refusal:
        _begin(SCENARIOS[name], values, executor)
    assert "\n" not in str(refusal.value)


@st.composite
def cases(draw: st.DrawFn) -> tuple[str, dict[str, Any]]:
    """A scenario, and up to three of its parameters anywhere within their bounds, often at one of them."""
    name = draw(st.sampled_from(DRAWN))
    fields = SCENARIOS[name].model_fields
    keys = draw(st.lists(st.sampled_from(sorted(fields)), max_size=3, unique=True))
    return name, {key: draw(_within(fields[key])) for key in keys}


def _within(field: Any) -> st.SearchStrategy:
    """Values within the bounds of a parameter, evenly over their orders of magnitude."""
    kind = field.annotation
    if get_origin(kind) is Literal:
        return st.sampled_from(get_args(kind))
    if kind is not int and kind is not float:
        return st.just(field.default)
    bounds = {
        name: getattr(rule, name) for rule in field.metadata for name in ("gt", "ge", "lt", "le") if hasattr(rule, name)
    }
    low, high = bounds.get("ge", bounds.get("gt", 0.0)), bounds.get("le", bounds.get("lt", 1e9))
    if kind is int:
        return st.integers(int(low), int(high)) | st.sampled_from([int(low), int(high)])
    powers = st.floats(np.log10(max(low, 1e-30)), np.log10(max(high, 1e-30))).map(lambda power: 10.0**power)
    scaled = st.floats(0.2, 5.0).map(lambda factor: factor * (field.default or 1.0))
    return (powers | scaled | st.sampled_from([low, high])).filter(lambda value: _holds(value, bounds))


def _holds(value: float, bounds: dict[str, float]) -> bool:
    return (
        value > bounds.get("gt", -np.inf)
        and value >= bounds.get("ge", -np.inf)
        and value < bounds.get("lt", np.inf)
        and value <= bounds.get("le", np.inf)
    )


@pytest.mark.filterwarnings("error::RuntimeWarning")
@settings(max_examples=CAMPAIGN, deadline=None, suppress_health_check=list(HealthCheck), derandomize=CAMPAIGN < 100)
@given(case=cases())
def test_any_values_within_bounds_run_or_are_refused(small_machine, executor: Executor, case):
    """If it failed, some values that `warpsph describe` allows would end in a traceback or a warning of NumPy."""
    name, values = case
    try:
        simulation = _begin(SCENARIOS[name], values, executor)
        step = simulation.plan.longest
        simulation.run(2.0 * step, 2.0 * step)
    except (InputError, DivergenceError) as refusal:
        message = str(refusal)
    else:
        message = ""
    assert "\n" not in message


def _begin(kind: type[Scenario], values: dict[str, Any], executor: Executor):
    """The simulation as `warpsph run` has it before its first step."""
    scenario = kind(**values)
    simulation = scenario.build(executor)
    simulation.refuse_too_long(simulation.schedule(scenario.duration, scenario.output_interval))
    return simulation
