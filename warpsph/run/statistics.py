"""Numbers of particles that may have leaked, frozen or gone: not a number where there is nothing to measure."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

MOST_SLICES = 100_000  # of what has flown far away


@contextmanager
def undefined_is_no_number() -> Iterator[None]:
    """What is undefined, such as the mean of nothing or 0 / 0, is not a number, and nobody is warned of it."""
    with np.errstate(all="ignore"), warnings.catch_warnings():
        for kind in (RuntimeWarning, np.exceptions.RankWarning):
            warnings.simplefilter("ignore", kind)
        yield


def highest(values: np.ndarray) -> float:
    """The largest of ``values`` (n,), NaN where there is none."""
    return float(np.max(values)) if len(values) else np.nan


def value_at_zero(x: np.ndarray, y: np.ndarray) -> float:
    """Where the line through the points ``x`` (n,), ``y`` (n,) is at x = 0; NaN where no line goes through them."""
    there = np.isfinite(x) & np.isfinite(y)
    return float(np.polyfit(x[there], y[there], 1)[1]) if len(np.unique(x[there])) > 1 else np.nan


def means_of_slices(index: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mean of the ``values`` (n,) in each slice, and how many are there, from an ``index`` (n,) of real numbers.

    A slice has the whole part of the index as its number; what is below them all, or is no number, is left out.
    """
    there = np.isfinite(index) & np.isfinite(values) & (index > -1.0) & (index < MOST_SLICES)
    slices = index[there].astype(int)
    count = np.bincount(slices)
    return np.bincount(slices, values[there]) / np.maximum(count, 1), count
