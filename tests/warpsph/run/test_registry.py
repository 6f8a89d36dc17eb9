"""The registry: all that changes in a run is in it, and nothing else is needed to go on."""

import gc
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import warp as wp

import warpsph.scenarios  # noqa: F401  registers them
from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.scenario import Scenario, registered_scenarios
from warpsph.core.executor import Executor
from warpsph.run.simulation import Simulation

SMALL: dict[str, Callable[[], dict[str, Any]]] = {
    "casting": lambda: {"duration": 0.06, "output_interval": 0.02, "spray_flux": 0.8},
    "breakout": lambda: {"duration": 0.06, "output_interval": 0.02, "spray_failure": 0.03},
    "dam_break": lambda: {"columns": 8, "duration": 0.1, "output_interval": 0.02},
    "dam_impact": lambda: {"rows": 8, "duration": 0.1, "output_interval": 0.02},
    "still_tank": lambda: {"rows": 8, "duration": 0.2, "output_interval": 0.05},
    "hydrostatic": lambda: {"rows": 20, "columns": 10, "duration": 0.05, "output_interval": 0.01},
    "natural_convection": lambda: {"rows": 10, "duration": 0.2, "output_interval": 0.05},
    "poiseuille": lambda: {"rows": 8, "duration": 0.2, "output_interval": 0.05},
    "cavity_flow": lambda: {"rows": 10, "duration": 0.2, "output_interval": 0.05},
    "couette": lambda: {"rows": 8, "duration": 0.2, "output_interval": 0.05},
    "drop": lambda: {"rows": 8, "duration": 0.2, "output_interval": 0.05},
    "taylor_green": lambda: {"rows": 16, "duration": 0.1, "output_interval": 0.02},
    "free_patch": lambda: {"rows": 16, "duration": 0.1, "output_interval": 0.02},
    "cantilever": lambda: {"layers": 4, "duration": 0.02, "output_interval": 0.005},
    "rubber_rings": lambda: {"layers": 4, "duration": 0.01, "output_interval": 0.002},
    "rotated_disc": lambda: {"spacing": 0.005, "stretch": 0.02, "duration": 4e-3, "output_interval": 1e-3},
    "heat_gaussian": lambda: {"spacing": 0.04, "duration": 2.0, "output_interval": 0.5},
    "crystal_growth": lambda: {
        "spacing": 1e-3,
        "charge_half_width": 13e-3,
        "step": 2.0,
        "duration": 8.0,
        "output_interval": 4.0,
    },
    "melting_triangle": lambda: {
        "duration": 0.1,
        "output_interval": 0.05,
        "averaged_steps": 250,
        "until": (0.1, 0.15, 9.0),
    },
    "melting_rectangle": lambda: {"duration": 0.1, "output_interval": 0.05, "averaged_steps": 250},
    "melting_block": lambda: {
        "columns": 20,
        "rows": 10,
        "settling": 0.2,
        "duration": 0.2,
        "output_interval": 0.1,
    },
    "heat_slab": lambda: {"rows": 10, "duration": 40.0, "output_interval": 10.0},
}


def small(kind: type[Scenario]) -> Scenario:
    """A case of a scenario that is done in a second."""
    layers = [preset_layer(kind, kind.default_preset)] if kind.default_preset else []
    case = resolve(kind, layers)
    changes = SMALL.get(kind.name, lambda: {"duration": 2.0 * case.output_interval})()
    return type(case)(**case.model_dump() | changes)


@pytest.fixture(params=registered_scenarios().values(), ids=lambda kind: kind.name)
def case(request: pytest.FixtureRequest) -> Scenario:
    return small(request.param)


def go_on(simulation: Simulation, case: Scenario) -> None:
    simulation.run(case.duration, case.output_interval)


def bits(simulation: Simulation) -> dict[str, bytes]:
    """All that the registry has, as bytes."""
    return {name: pickle.dumps(value) for name, value in simulation.registry.save().items()}


def arrays_made_by(build: Callable[[], Simulation]) -> tuple[Simulation, list[wp.array]]:
    """A simulation and every Warp array that is alive because of it."""
    before = {id(array) for array in alive()}
    simulation = build()
    gc.collect()
    return simulation, [array for array in alive() if id(array) not in before]


def alive() -> list[wp.array]:
    """All arrays of this process, by their type alone: a dead proxy must not be asked."""
    return [thing for thing in gc.get_objects() if type(thing) is wp.array]


def test_no_device_array_changes_that_is_not_in_the_registry(case, device):
    """If it failed, a checkpoint made of the registry would lack something that changes in a run."""
    executor = Executor(device)
    simulation, arrays = arrays_made_by(lambda: case.build(executor))
    go_on(simulation, case)
    registry = simulation.registry
    known = {array.ptr for array in (*registry.arrays.values(), *registry.scratch.values())}
    known.add(executor._meeting.ptr)
    unknown = [array for array in arrays if array.ptr not in known and array.size]
    before = [array.numpy().tobytes() for array in unknown]
    simulation.run(case.duration, case.output_interval)
    changed = [array for array, old in zip(unknown, before, strict=True) if array.numpy().tobytes() != old]
    assert not changed, [f"{array.dtype} {array.shape}" for array in changed]
    assert len(arrays) > len(registry.arrays) > 10


def test_no_attribute_of_an_observer_changes_that_is_not_in_its_memory(case):
    """If it failed, an event would be noted twice, or a ledger begin anew, after a resume."""
    simulation = case.build(Executor("cpu"))
    saved = simulation.registry.save()
    before = {name: pickle.dumps(value) for name, value in observed(simulation).items()}
    go_on(simulation, case)
    simulation.registry.load(saved)
    assert {name: pickle.dumps(value) for name, value in observed(simulation).items()} == before


def observed(simulation: Simulation) -> dict[str, Any]:
    """Plain attributes of what observes a run, and of what that consists of in turn."""
    found: dict[str, Any] = {}

    def walk(name: str, thing: Any) -> None:
        for key, value in vars(thing).items() if hasattr(thing, "__dict__") else ():
            if isinstance(value, str | int | float | set | list | dict | np.ndarray):
                found[f"{name}.{key}"] = value
            elif type(value).__module__.startswith("warpsph.scenarios") and not isinstance(value, Scenario):
                walk(f"{name}.{key}", value)

    observe = simulation.recorder.observe
    walk("observer", getattr(observe, "__self__", observe))
    return found


def test_what_is_restored_goes_on_with_the_same_bits(case, device):
    """If it failed, the registry would not hold all that the next steps depend on."""
    simulation = case.build(Executor(device))
    go_on(simulation, case)
    saved = simulation.registry.save()
    go_on(simulation, case)
    once = bits(simulation)
    for array in simulation.registry.scratch.values():
        array.assign(np.full(array.numpy().shape, 1, array.numpy().dtype))
    simulation.registry.load(saved)
    go_on(simulation, case)
    again = bits(simulation)
    assert [name for name in once if once[name] != again[name]] == []


def test_a_run_in_two_parts_has_the_bits_of_one(case):
    """If it failed, a run could not be continued, and its time step would depend on how much is left."""
    whole, parts = (case.build(Executor("cpu")) for _ in range(2))
    whole.run(2.0 * case.duration, case.output_interval)
    for _ in range(2):
        go_on(parts, case)
    one, two = ({name: data for name, data in bits(s).items() if name != "recorder"} for s in (whole, parts))
    assert [name for name in one if one[name] != two[name]] == []
