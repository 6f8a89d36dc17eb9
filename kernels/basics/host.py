"""Device functions evaluated on the host, over NumPy arrays and in double precision."""

from collections.abc import Callable
from types import FunctionType, SimpleNamespace
from typing import Any

import numpy as np
import warp as wp

NUMPY = SimpleNamespace(
    max=np.maximum,
    min=np.minimum,
    sqrt=np.sqrt,
    where=np.where,
    sin=np.sin,
    cos=np.cos,
    exp=np.exp,
    log=np.log,
    pow=np.power,
    float64=np.float64,
)


def on_host(function: wp.Function) -> Callable[..., Any]:
    """The function for NumPy arrays: its one definition, with NumPy in the place of Warp."""
    source = function.func
    names = source.__code__.co_names
    known = {name: _counterpart(value) for name, value in source.__globals__.items() if name in names}
    return FunctionType(source.__code__, known)


def _counterpart(value: Any) -> Any:
    if value is wp:
        return NUMPY
    return on_host(value) if isinstance(value, wp.Function) else value
