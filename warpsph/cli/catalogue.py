"""The scenarios that the command line knows: those that the scenarios package registers."""

from importlib import import_module

from warpsph.cases.scenario import Scenario, registered_scenarios
from warpsph.errors import InputError
from warpsph.nearest import did_you_mean


def all_scenarios() -> dict[str, type[Scenario]]:
    """Every scenario by name."""
    import_module("warpsph.scenarios")
    return registered_scenarios()


def find_scenario(name: str) -> type[Scenario]:
    """The scenario of that name."""
    scenarios = all_scenarios()
    if name not in scenarios:
        raise InputError(f"unknown scenario '{name}'{did_you_mean(name, scenarios)} (see warpsph list)")
    return scenarios[name]
