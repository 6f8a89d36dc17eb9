"""Every scenario, present and later, as a case that is done in a second."""

from collections.abc import Callable
from typing import Any

import pytest

import warpsph.scenarios  # noqa: F401  registers them
from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.scenario import Scenario, registered_scenarios

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
