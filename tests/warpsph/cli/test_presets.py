"""The ready-made cases of the real scenarios."""

from pathlib import Path

import pytest

import warpsph.scenarios
from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.scenario import Scenario, registered_scenarios

FOLDER = Path(warpsph.scenarios.__file__).parent
SCENARIOS = list(registered_scenarios().values())
PRESETS = [pytest.param(kind, preset, id=f"{kind.name}-{preset}") for kind in SCENARIOS for preset in kind.presets]


@pytest.mark.parametrize(("kind", "preset"), PRESETS)
def test_preset_is_a_valid_case(kind: type[Scenario], preset: str):
    """If it failed, a ready-made case would be empty, or refused by its own scenario."""
    layer = preset_layer(kind, preset)
    assert layer.values
    assert resolve(kind, [layer]).model_fields_set == layer.values.keys()


def test_every_case_file_is_a_preset():
    """If it failed, a case file would lie there that no --preset reaches."""
    listed = {f"{kind.name}/{preset}.toml" for kind in SCENARIOS for preset in kind.presets}
    assert {f"{path.parent.name}/{path.name}" for path in FOLDER.rglob("presets/*/*.toml")} == listed


@pytest.mark.parametrize("kind", SCENARIOS, ids=lambda kind: kind.name)
def test_scenario_describes_itself(kind: type[Scenario]):
    """If it failed, warpsph list or describe would show a scenario or a parameter without explanation."""
    assert kind.summary
    assert "\n" not in kind.summary
    assert kind.source
    assert kind.default_preset is None or kind.default_preset in kind.presets
    for name, field in kind.model_fields.items():
        assert field.description, name
        assert "unit" in (field.json_schema_extra or {}), name
