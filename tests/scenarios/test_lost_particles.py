"""Observers and checks of every scenario stand particles that have leaked or frozen, or are all gone."""

import warnings
from collections.abc import Callable

import numpy as np
import pytest

import warpsph.scenarios  # noqa: F401  registers them
from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.scenario import Scenario, registered_scenarios
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.state import Snapshot
from warpsph.run.statistics import undefined_is_no_number

COARSE = {
    "hydrostatic": {"rows": 20, "columns": 10},
    "melting_block": {"columns": 20, "rows": 10},
    "heat_gaussian": {"spacing": 0.04},
    "rotated_disc": {"spacing": 0.005},
    "crystal_growth": {"spacing": 1e-3, "charge_half_width": 13e-3},
    "dam_break": {"columns": 8},
} | {
    name: {"rows": 12}
    for name in (
        *("dam_impact", "still_tank", "natural_convection", "poiseuille", "cavity_flow", "couette", "drop"),
        *("taylor_green", "free_patch", "heat_slab"),
    )
}


def free(state: Snapshot) -> np.ndarray:
    return state["role"] == Role.FREE


def are_gone(state: Snapshot) -> None:
    state["role"][free(state)] = Role.RESERVOIR


def are_gone_but_one(state: Snapshot) -> None:
    state["role"][np.flatnonzero(free(state))[1:]] = Role.RESERVOIR


def have_frozen(state: Snapshot) -> None:
    state["phase"][:] = Phase.SOLID


def have_melted(state: Snapshot) -> None:
    state["phase"][:] = Phase.LIQUID


def have_leaked(state: Snapshot) -> None:
    state["position"][np.flatnonzero(free(state))[::2], 1] -= 3.0


def are_far_above(state: Snapshot) -> None:
    state["position"][free(state)] += 1.0e6


def are_far_below(state: Snapshot) -> None:
    state["position"][free(state)] -= 1.0e6


def are_no_numbers(state: Snapshot) -> None:
    for values in state.values():
        if values.dtype.kind == "f":
            values[:] = np.nan


FATES = (
    are_gone,
    are_gone_but_one,
    have_frozen,
    have_melted,
    have_leaked,
    are_far_above,
    are_far_below,
    are_no_numbers,
)

UNCHECKED = (are_gone_but_one, have_frozen, have_melted, are_far_above)  # as the others, to save time


def changed(start: Snapshot, fate: Callable[[Snapshot], None]) -> Snapshot:
    """A copy of a snapshot, whose particles have that ``fate``."""
    snapshot = {name: values.copy() for name, values in start.items()}
    fate(snapshot)
    return snapshot


@pytest.fixture(params=registered_scenarios().values(), ids=lambda kind: kind.name)
def case(request: pytest.FixtureRequest) -> Scenario:
    kind = request.param
    layers = [preset_layer(kind, kind.default_preset)] if kind.default_preset else []
    coarse: dict = COARSE.get(kind.name, {})
    return kind(**resolve(kind, layers).model_dump() | coarse)


def test_observers_and_checks_stand_lost_particles(case, monkeypatch):
    """If it failed, a run whose particles leak would end in a traceback, hours of it lost, instead of a NaN."""
    simulation = case.build(Executor("cpu", 1))
    start = simulation.snapshot()
    for fate in FATES:
        what = f"{case.name}, where all {fate.__name__.replace('_', ' ')}"
        with monkeypatch.context() as patch, warnings.catch_warnings():
            warnings.simplefilter("error")
            patch.setattr(simulation.state, "snapshot", lambda fate=fate: changed(start, fate))
            try:
                simulation.recorder.begin(None)
                for time in (0.0, case.duration):
                    simulation.state.time.fill_(time)
                    simulation.recorder.keep()
                with undefined_is_no_number():
                    assert fate in UNCHECKED or isinstance(list(case.checks(simulation._result("", 1.0, 0, []))), list)
            except Exception as error:
                raise AssertionError(what) from error
        assert len(simulation.recorder.series) > 2, what
