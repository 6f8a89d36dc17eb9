"""The registry: all that changes in a run is in it, and nothing else is needed to go on."""

import gc
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import warp as wp

from warpsph.cases.scenario import Scenario
from warpsph.core.executor import Executor
from warpsph.run.simulation import Simulation


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
