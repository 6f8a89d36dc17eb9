"""An HDF5 file of unknown origin: only what lies in it is read, and no more than it can hold.

A file may claim any size, lead to other files and to pipes, or hold a gigabyte of zeros in a kilobyte. So links and
outside storage are never followed, types and shapes are looked at before anything is read, and what is read is counted.
"""

import os
from collections.abc import Sequence
from math import prod

import h5py
import numpy as np

from warpsph.errors import cut, printable

LARGEST_RATIO = 16  # of what is compressed to what it is in the file
LEAST_BYTES = 2**24  # that may be read of any file
MOST_ITEMS = 1000  # that a group may have
LARGEST_ATTRIBUTE = 2**16  # bytes
LONGEST_TEXT = 200_000  # letters
LONGEST_NAME = 200  # letters of a name, a label, a unit
TEXTS_AT_ONCE = 16  # variable texts tell their lengths only when they are read

FILTERS = (h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE, h5py.h5z.FILTER_FLETCHER32, h5py.h5z.FILTER_LZF)


class GuardedFile:
    """Reads an open file; every method raises ``ValueError`` or what h5py raises where something is wrong with it."""

    def __init__(self, file: h5py.File) -> None:
        self._file = file
        self._spent = 0.0

    def has(self, path: str) -> bool:
        """Whether there is a group or a dataset of that path in the file itself."""
        try:
            self._find(path)
        except ValueError:
            return False
        return True

    def group(self, path: str) -> h5py.Group:
        """A group."""
        found = self._find(path)
        if not isinstance(found, h5py.Group):
            raise ValueError(f"{path} is no group")
        return found

    def dataset(self, path: str) -> h5py.Dataset:
        """A dataset whose values are all in this file, plain or in a compression that can be counted."""
        found = self._find(path)
        if not isinstance(found, h5py.Dataset):
            raise ValueError(f"{path} is no dataset")
        layout = found.id.get_create_plist()
        if layout.get_layout() == h5py.h5d.VIRTUAL or layout.get_external_count() > 0:
            raise ValueError(f"{path} has its values in another file")
        if any(code not in FILTERS for code in _filters(found)):
            raise ValueError(f"{path} is compressed in another way than gzip or LZF")
        if found.shape is None:
            raise ValueError(f"{path} is empty")
        return found

    def members(self, path: str) -> dict[str, str]:
        """What is in a group: names, as they may be printed, and paths."""
        group = self.group(path)
        if len(group) > MOST_ITEMS:
            raise ValueError(f"{path} holds {len(group)} items; at most {MOST_ITEMS} are read")
        return {cut(printable(name), LONGEST_NAME): f"{path}/{name}" for name in group}

    def numbers(self, path: str, start: int, stop: int, kinds: str = "iufb") -> np.ndarray:
        """Rows of a dataset of numbers.

        Args:
            path: of the dataset.
            start, stop: the rows; all of them must be there.
            kinds: NumPy's letters of the kinds of numbers that are allowed.
        """
        dataset = self.dataset(path)
        if dataset.dtype.kind not in kinds or dataset.dtype.itemsize > 8:
            raise ValueError(f"{path} holds {dataset.dtype} values")
        self._look_at_rows(dataset, start, stop)
        self._count(dataset, (stop - start, *dataset.shape[1:]))
        return dataset[start:stop]

    def text(self, path: str) -> str:
        """The one text of a dataset, as it stands there."""
        dataset = self.dataset(path)
        if h5py.check_string_dtype(dataset.dtype) is None or dataset.shape != ():
            raise ValueError(f"{path} is no text")
        self._count(dataset, ())
        text = dataset.asstr(errors="replace")[()]
        if len(text) > LONGEST_TEXT:
            raise ValueError(f"{path} has {len(text)} letters; at most {LONGEST_TEXT} are read")
        return text

    def texts(self, path: str, stop: int) -> list[str]:
        """The first rows of a dataset of texts, as they may be printed."""
        dataset = self.dataset(path)
        if h5py.check_string_dtype(dataset.dtype) is None or len(dataset.shape) != 1:
            raise ValueError(f"{path} holds no texts")
        self._look_at_rows(dataset, 0, stop)
        self._count(dataset, (stop,))
        texts: list[str] = []
        for start in range(0, stop, TEXTS_AT_ONCE):
            some = dataset.asstr(errors="replace")[start : min(start + TEXTS_AT_ONCE, stop)].tolist()
            self.spend(sum(map(len, some)))
            texts += [cut(printable(text), LONGEST_NAME) for text in some]
        return texts

    def spend(self, size: float) -> None:
        """Note that so many bytes are taken, and refuse more than the file can hold."""
        self._spent += size
        allowed = max(os.stat(self._file.filename).st_size, LEAST_BYTES)  # now: a run may be writing it
        if self._spent > allowed:
            raise ValueError(f"it claims to hold {self._spent:.3g} bytes, more than there can be in it")

    def _find(self, path: str) -> h5py.HLObject:
        found: h5py.HLObject = self._file
        for name in path.split("/"):
            link = found.get(name, getlink=True) if isinstance(found, h5py.Group) else None
            if link is None:
                raise ValueError(f"{path} is missing")
            if not isinstance(link, h5py.HardLink):
                raise ValueError(f"{path} is a link, which is not followed")
            found = found[name]
        return found

    def _count(self, dataset: h5py.Dataset, shape: Sequence[int]) -> None:
        """Note what a reading takes: values, or a whole chunk where they are fewer."""
        size = prod(shape) * dataset.dtype.itemsize
        if size and dataset.chunks:
            size = max(size, prod(dataset.chunks) * dataset.dtype.itemsize)
        self.spend(size / LARGEST_RATIO if _filters(dataset) else size)

    @staticmethod
    def _look_at_rows(dataset: h5py.Dataset, start: int, stop: int) -> None:
        if not dataset.shape or not 0 <= start <= stop <= dataset.shape[0]:
            raise ValueError(f"{dataset.name} has no rows {start} to {stop}")


def whole_number(owner: h5py.HLObject, name: str) -> int:
    """An attribute that is one whole number."""
    value = _attribute(owner, name)
    if not isinstance(value, int):
        raise ValueError(f"the attribute {name} of {owner.name} is no whole number")
    return value


def short_text(owner: h5py.HLObject, name: str) -> str:
    """An attribute that is one text or number, as it may be printed."""
    value = _attribute(owner, name)
    text = value.decode(errors="replace") if isinstance(value, bytes) else str(value)
    return cut(printable(text), LONGEST_NAME)


def _attribute(owner: h5py.HLObject, name: str) -> int | float | str | bytes:
    stored = owner.attrs.get_id(name)
    of_text = h5py.check_string_dtype(stored.dtype) is not None
    if stored.dtype.kind not in "iufbS" and not of_text:
        raise ValueError(f"the attribute {name} of {owner.name} holds {stored.dtype} values")
    if stored.shape is None or prod(stored.shape) != 1 or stored.get_storage_size() > LARGEST_ATTRIBUTE:
        raise ValueError(f"the attribute {name} of {owner.name} is not one value")
    return np.asarray(owner.attrs[name]).reshape(-1)[0:1].tolist()[0]


def _filters(dataset: h5py.Dataset) -> list[int]:
    layout = dataset.id.get_create_plist()
    return [layout.get_filter(k)[0] for k in range(layout.get_nfilters())]
