"""What a dataset is called for people, in which unit and how it is drawn: attributes beside its numbers."""

from dataclasses import fields

import h5py

from warpsph.core.quantity import Quantity, undeclared
from warpsph.files.guarded import short_text, whole_number

PLACE = "place"  # among its like, in the order in which they were declared


def attributes_of(quantity: Quantity, place: int = 0) -> dict[str, str | int]:
    """The attributes of a dataset that holds a quantity."""
    return {field.name: getattr(quantity, field.name) for field in fields(Quantity)} | {PLACE: place}


def read_quantity(dataset: h5py.Dataset, name: str) -> Quantity:
    """What the attributes of a dataset say; in files of others, its name."""
    if "label" not in dataset.attrs:
        return undeclared(name)
    known = [field.name for field in fields(Quantity) if field.name in dataset.attrs]
    return Quantity(**{key: short_text(dataset, key) for key in known})


def place_of(dataset: h5py.Dataset) -> int:
    """Its place among its like."""
    return whole_number(dataset, PLACE) if PLACE in dataset.attrs else 0
