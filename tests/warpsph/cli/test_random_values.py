"""Random values within the bounds of every scenario: a case, or one line that says which of them do not go together."""

import math
import os
from enum import Enum
from typing import Any, Literal, get_args, get_origin

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from pydantic.fields import FieldInfo

from warpsph.cases.case import resolve, settings_layer
from warpsph.cli.catalogue import all_scenarios
from warpsph.cli.describe import show_value
from warpsph.errors import InputError

CAMPAIGN = int(os.environ.get("WARPSPH_CAMPAIGN", 0))  # examples, as in CONTRIBUTING.md
KINDS = {name: kind for name, kind in all_scenarios().items() if kind.__module__.startswith("warpsph.scenarios")}


def bound(field: FieldInfo, *names: str, none: float) -> float:
    """A bound of a parameter."""
    return next((getattr(item, name) for item in field.metadata for name in names if hasattr(item, name)), none)


def values_of(field: FieldInfo) -> st.SearchStrategy[Any]:
    """Values within the bounds of a parameter, their ends and what lies just inside among them."""
    kind = field.annotation
    if get_origin(kind) is Literal:
        return st.sampled_from(get_args(kind))
    if isinstance(kind, type) and issubclass(kind, Enum):
        return st.sampled_from([choice.value for choice in kind])
    if kind is bool:
        return st.booleans()
    low, high = bound(field, "ge", "gt", none=-1e6), bound(field, "le", "lt", none=1e6)
    if kind is int:
        return st.integers(math.ceil(low), math.floor(high))
    number = st.floats(low, high, exclude_min=bound(field, "gt", none=math.nan) == low)
    if low >= 0.0:
        number |= st.floats(math.log10(max(low, 1e-30)), math.log10(high)).map(lambda power: 10.0**power)
    return number if kind is float else st.lists(number, max_size=4) | number


@st.composite
def cases(draw: st.DrawFn) -> tuple[str, list[str]]:
    """The name of a scenario, and a few settings."""
    name = draw(st.sampled_from(sorted(KINDS)))
    fields = KINDS[name].model_fields
    keys = draw(st.lists(st.sampled_from(sorted(fields)), min_size=1, max_size=6, unique=True))
    return name, [f"{key}={show_value(draw(values_of(fields[key])))}" for key in keys]


@settings(max_examples=CAMPAIGN or 200, deadline=None, database=None)
@given(cases())
@example(("melting_block", ["step=5e-324"]))
@example(("point_sink", ["duration=5e-324"]))
def test_values_within_bounds_are_a_case_or_one_line(case: tuple[str, list[str]]):
    """If it failed, two values that contradict each other would end in a traceback before anything is computed."""
    name, given_values = case
    try:
        resolve(KINDS[name], [settings_layer(given_values)])
    except InputError as error:
        if "\n" in str(error) or not str(error).startswith("--set: "):
            pytest.fail(str(error))
