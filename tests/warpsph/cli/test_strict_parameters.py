"""Numbers are numbers: no parameter of any scenario takes a truth value or a text for one."""

from enum import Enum

import numpy as np
import pytest

from warpsph.cli.catalogue import all_scenarios
from warpsph.errors import InputError

KINDS = list(all_scenarios().values())


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_neither_truth_values_nor_texts_are_numbers(kind):
    """If it failed, duration=true would run for one second, and a typo in quotes would pass."""
    for key, field in kind.model_fields.items():
        if isinstance(field.default, str | Enum | bool):
            continue
        for wrong in (True, "1", (True,), ("1",), {"x": 1}, b"1"):
            with pytest.raises(InputError, match=rf"{kind.name}: {key}(\.0)? = ") as caught:
                kind(**{key: wrong})
            assert "\n" not in str(caught.value)


def test_numbers_of_numpy_and_whole_numbers_are_numbers():
    """If it failed, a study over an array of values would have to convert each of them."""
    kind = all_scenarios()["casting"]
    assert kind(spray_failing=np.array([1, 2]), spray_failure=np.int64(1), duration=np.float32(2)).duration == 2.0
    assert kind(duration=2, spray_failing=[2]).spray_failing == (2,)
