"""Diagnostics as tables of pandas and xarray, which are installed only by those who want them."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsph.core.quantity import Quantity, undeclared
from warpsph.errors import InputError

if TYPE_CHECKING:
    import pandas
    import xarray

TIME = "time"


class Diagnosed:
    """What holds diagnostics over time: a result in memory, and a result file.

    Attributes:
        diagnostics: time series by name (T,) or (T, ...), with ``time`` [s].
        quantities: what they are called and in which unit.
    """

    diagnostics: dict[str, np.ndarray]
    quantities: dict[str, Quantity]

    def to_pandas(self) -> "pandas.DataFrame":
        """The diagnostics that are one number at a time, a column each, over the time [s].

        Their units stand in ``attrs["units"]``, their labels in ``attrs["labels"]``.

        Raises:
            InputError: pandas is not installed.
        """
        pandas = optional("pandas")
        series = {name: values for name, values in self.diagnostics.items() if values.ndim == 1 and name != TIME}
        frame = pandas.DataFrame(series, index=pandas.Index(self.diagnostics[TIME], name=TIME))
        known = {name: self._quantity(name) for name in (TIME, *series)}
        frame.attrs["units"] = {name: quantity.unit for name, quantity in known.items()}
        frame.attrs["labels"] = {name: quantity.label for name, quantity in known.items()}
        return frame

    def to_xarray(self) -> "xarray.Dataset":
        """All diagnostics, with ``units`` and ``long_name``, over ``time`` [s].

        An array that is given over another one, as a profile over heights, has that one as its second dimension and
        coordinate; where those heights change with time, and for arrays that are over nothing, the second dimension
        counts, as ``<name>_index``.

        Raises:
            InputError: xarray is not installed.
        """
        xarray = optional("xarray")
        fixed = {
            name: row for name in self._supports() if (row := _same_at_all_times(self.diagnostics[name])) is not None
        }
        variables, coordinates = {}, {}
        for name, values in self.diagnostics.items():
            quantity = self._quantity(name)
            attributes = {"units": quantity.unit, "long_name": quantity.label}
            if name == TIME:
                coordinates[name] = (TIME, values, attributes)
            elif name in fixed:
                coordinates[name] = (name, fixed[name], attributes)
            else:
                variables[name] = ((TIME, *self._dimensions(name, fixed)), values, attributes)
        dataset = xarray.Dataset(variables, coordinates)
        return dataset.set_coords([name for name in self._supports() if name not in fixed])

    def _quantity(self, name: str) -> Quantity:
        return self.quantities.get(name) or undeclared(name)

    def _supports(self) -> list[str]:
        """The diagnostics over which others are given."""
        given = {name: self._over(name) for name in self.diagnostics}
        return list(dict.fromkeys(over for over in given.values() if over))

    def _over(self, name: str) -> str:
        """Over which diagnostic an array is given, "" where there is none of its length."""
        over = self._quantity(name).over
        shape = self.diagnostics[name].shape
        known = over in self.diagnostics and over != name and len(shape) == 2 and self.diagnostics[over].shape == shape
        return over if known else ""

    def _dimensions(self, name: str, fixed: dict[str, np.ndarray]) -> list[str]:
        """The dimensions of an array beside the time."""
        over = self._over(name) or name
        if over in fixed:
            return [over]
        further = self.diagnostics[name].ndim - 1
        return [f"{over}_index"] if further == 1 else [f"{over}_index_{axis}" for axis in range(further)]


def optional(library: str) -> Any:
    """A library that warpsph does not need for its runs.

    Raises:
        InputError: it is not installed; one line says how it is.
    """
    try:
        return import_module(library)
    except ImportError:
        raise InputError(
            f"{library} is not installed; 'pip install warpsph[analysis]' or 'pip install {library}'"
        ) from None


def _same_at_all_times(values: np.ndarray) -> np.ndarray | None:
    """The row (m,) that an array (T, m) has wherever it was measured, or None."""
    measured = values[np.isfinite(values).all(axis=1)]
    return measured[0] if len(measured) and np.all(measured == measured[0]) else None
