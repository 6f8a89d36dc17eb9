"""Plain values and NumPy arrays, nested in any way, as a JSON text and arrays by name, and back to the bit."""

from typing import Any

import numpy as np

Arrays = dict[str, np.ndarray]


def pack(value: Any, arrays: Arrays, name: str) -> Any:
    """What stands for a value in JSON; its arrays are added to ``arrays`` under names that begin with ``name``.

    Args:
        value: numbers, texts, None, NumPy arrays and scalars, and lists, tuples, sets and dicts of them.

    Raises:
        TypeError: it holds something else.
    """
    if value is None or type(value) in (bool, int, float, str):
        return value
    if isinstance(value, np.ndarray | np.generic):
        return _put(value, arrays, name, "array" if isinstance(value, np.ndarray) else "scalar")
    if isinstance(value, list) and _is_uniform(value):
        return _put(np.stack(value), arrays, name, "rows")
    if isinstance(value, dict):
        return {"dict": [[key, pack(item, arrays, f"{name}/{key}")] for key, item in value.items()]}
    if isinstance(value, list | tuple | set):
        items = sorted(value) if isinstance(value, set) else value
        return {type(value).__name__: [pack(item, arrays, f"{name}/{k}") for k, item in enumerate(items)]}
    raise TypeError(f"{name}: a {type(value).__name__} cannot be kept in a checkpoint")


def unpack(packed: Any, arrays: Arrays) -> Any:
    """What :func:`pack` was given.

    Raises:
        ValueError, KeyError: it comes from somewhere else.
    """
    if not isinstance(packed, dict):
        return packed
    ((kind, held),) = packed.items()
    match kind:
        case "array":
            return arrays[held]
        case "scalar":
            return arrays[held][()]
        case "rows":
            return list(arrays[held])
        case "dict":
            return {key: unpack(item, arrays) for key, item in held}
        case "list" | "tuple" | "set":
            return {"list": list, "tuple": tuple, "set": set}[kind](unpack(item, arrays) for item in held)
    raise ValueError(f"a '{kind}' is not known")


def _put(value: np.ndarray | np.generic, arrays: Arrays, name: str, kind: str) -> dict[str, str]:
    arrays[name] = np.asarray(value)
    return {kind: name}


def _is_uniform(items: list) -> bool:
    """Whether a list consists of NumPy values of one type and shape, as a time series does."""
    kinds = {(item.dtype, item.shape) if isinstance(item, np.ndarray | np.generic) else None for item in items}
    return len(kinds) == 1 and None not in kinds
