"""Plain values and arrays survive packing to the bit."""

import json

import numpy as np
import pytest

from warpsph.files.packing import pack, unpack


@pytest.mark.parametrize(
    "value",
    [
        None, True, -3, 2**70, 0.1, float("inf"), "a text \u00e9\n", [], {}, (1, (2.0, "x")), {"b", "a"},
        {1.5: [1, 2.5, None], "x": {"y": ()}}, np.float64(0.1), np.arange(6, dtype="i2").reshape(2, 3),
        [np.float64(1.0), np.float64("nan")], [np.zeros((2, 3), "f4"), np.ones((2, 3), "f4")],
        [np.float64(1.0), 2.0], np.array([], "f4"),
    ],
    ids=repr,
)  # fmt: skip
def test_what_is_unpacked_is_what_was_packed(value):
    """If it failed, an observer would remember something else after a resume."""
    arrays = {}
    packed = json.loads(json.dumps(pack(value, arrays, "it")))
    again = unpack(packed, {name: array.copy() for name, array in arrays.items()})
    assert type(again) is type(value)
    assert (again == value) if isinstance(value, set) else repr(again) == repr(value)


def test_what_cannot_be_kept_is_named():
    """If it failed, a checkpoint would lack something, and nobody knew until the resume."""
    with pytest.raises(TypeError, match="observer/plan: a object cannot be kept"):
        pack({"plan": object()}, {}, "observer")
