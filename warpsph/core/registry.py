"""All that changes in a run: the device arrays of the state, and the memory of objects on the host."""

from copy import deepcopy
from typing import Any, Protocol, runtime_checkable

import numpy as np

from warpsph.core.state import State
from warpsph.errors import InputError


@runtime_checkable
class Remembers(Protocol):
    """An object on the host whose attributes change in a run."""

    def memory(self) -> dict[str, Any]:
        """What has changed since it was made, as plain values and NumPy arrays."""
        ...

    def restore(self, memory: dict[str, Any]) -> None:
        """Become as it was when ``memory`` was taken."""
        ...


class Registry:
    """Everything that must be saved to go on later as if nothing had happened.

    Args:
        state: its kept fields and its values are the device's part; its scratch is not kept.
        memories: objects on the host, by name.
    """

    def __init__(self, state: State, memories: dict[str, Remembers]):
        self.arrays = state.kept | state.values
        self.scratch = {name: a for name, a in state.arrays.items() if name not in state.kept} | state.scratch
        self.memories = memories

    def save(self) -> dict[str, Any]:
        """A copy of everything: arrays and memories by name."""
        arrays = {name: array.numpy().copy() for name, array in self.arrays.items()}
        return arrays | {name: deepcopy(owner.memory()) for name, owner in self.memories.items()}

    def load(self, saved: dict[str, Any]) -> None:
        """Become as it was at :meth:`save`.

        Raises:
            InputError: what was saved belongs to another case; nothing is changed, but memories may be.
        """
        for name, array in self.arrays.items():
            there, here = saved.get(name), array.numpy()
            fits = isinstance(there, np.ndarray) and there.shape == here.shape and there.dtype == here.dtype
            if not fits:
                raise InputError(f"what was saved belongs to another case: '{name}' is missing or of another kind")
        for name, owner in self.memories.items():
            try:
                owner.restore(deepcopy(saved[name]))
            except (KeyError, TypeError, ValueError, AttributeError, IndexError):
                raise InputError(
                    f"what was saved belongs to another case: the memory '{name}' is not its own"
                ) from None
        for name, array in self.arrays.items():
            array.assign(np.ascontiguousarray(saved[name]))
