"""What changes in a run, on the device: fields, values and lists, all of them known by name."""

from typing import Any

import numpy as np
import warp as wp

from warpsph.core.field import Field, Value
from warpsph.errors import InputError

Snapshot = dict[str, np.ndarray]


def members_of(structure: Any) -> list[str]:
    """Names of the members of an instance of a Warp structure."""
    return list(structure._cls.vars)


class State:
    """Every device array of a run, as attributes by name: ``state.position``, ``state.time``, ``state.neighbours``.

    Args:
        count: number of particles n.
        device: where the arrays live.

    Attributes:
        fields: the declarations of the fields, by name.
        arrays: their arrays (n,), by name, those with the carries of compensated fields among them.
        values: arrays that are not one entry a particle, or belong to a list, by name; those of a term as "term.name".
        lists: Warp structures whose arrays are among the values, or the scratch, by name.
        scratch: arrays that are written anew before they are read, by name; they need not be kept.
    """

    def __init__(self, count: int, device: wp.Device):
        self.count, self.device = count, device
        self.fields: dict[str, Field] = {}
        self.arrays: dict[str, wp.array] = {}
        self.values: dict[str, wp.array] = {}
        self.lists: dict[str, Any] = {}
        self.scratch: dict[str, wp.array] = {}

    def __getattr__(self, name: str) -> Any:
        for known in ("arrays", "values", "lists", "scratch"):
            if name in self.__dict__.get(known, {}):
                return self.__dict__[known][name]
        raise AttributeError(f"the state holds nothing that is called '{name}'")

    def add(self, field: Field, values: np.ndarray) -> None:
        """Add the array of a field with its start ``values`` (n, ...), and what single precision loses of them.

        Raises:
            InputError: something of that name is there already, or the values are not one for each particle.
        """
        self._refuse_taken(field.name)
        if np.shape(values) != (self.count, *field.shape):
            raise InputError(
                f"field '{field.name}': start values of shape {np.shape(values)}; {self.count} particles need "
                f"{(self.count, *field.shape)}"
            )
        self.fields[field.name] = field
        self.arrays[field.name] = field.array(values, self.device)
        if field.compensated:
            self._refuse_taken(field.carry_name)
            lost = self.arrays[field.name].numpy() - np.asarray(values, float)
            self.arrays[field.carry_name] = field.array(lost, self.device)

    def hold(self, name: str, array: wp.array, scratch: bool = False) -> wp.array:
        """Keep an array that is not a field, under a name of its own."""
        self._refuse_taken(name)
        (self.scratch if scratch else self.values)[name] = array
        return array

    def hold_list(self, name: str, structure: Any, scratch: bool = False) -> None:
        """Keep a Warp structure and all its arrays."""
        self._refuse_taken(name)
        for member in members_of(structure):
            if isinstance(array := getattr(structure, member), wp.array):
                self.hold(f"{name}.{member}", array, scratch)
        self.lists[name] = structure

    def hold_values(self, owner: str, term: Any, values: list[Value]) -> None:
        """Make the arrays of the values that a term declares, and give them to it.

        Raises:
            InputError: the term has been given arrays before.
        """
        if term.arrays:
            raise InputError(f"this {type(term).__name__} belongs to another simulation already; make a new one")
        for value in values:
            term.arrays[value.name] = self.hold(f"{owner}.{value.name}", value.array(term, self.device), value.scratch)

    @property
    def kept(self) -> dict[str, wp.array]:
        """The arrays of fields that belong to their particles from step to step, and their carries."""
        of_kept = {name for field in self.fields.values() if field.kept for name in (field.name, field.carry_name)}
        return {name: array for name, array in self.arrays.items() if name in of_kept}

    def numpy(self, name: str) -> np.ndarray:
        """A copy of one array on the host."""
        return getattr(self, name).numpy().copy()

    def snapshot(self) -> Snapshot:
        """A copy of all kept fields on the host, in the order of the ids."""
        order = np.argsort(self.numpy("id"))
        return {name: self.numpy(name)[order] for name, field in self.fields.items() if field.kept}

    def _refuse_taken(self, name: str) -> None:
        if not name or hasattr(self, name):
            raise InputError(f"the name '{name}' is taken: an array, a list or an attribute of the state is called so")
