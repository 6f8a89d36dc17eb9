"""Ends and ticks of colour bars."""

import numpy as np
from matplotlib.ticker import MaxNLocator

LARGEST = 1.0e100  # number that has a colour; sums and squares of larger ones are none


def usable(values: np.ndarray) -> np.ndarray:
    """Those of some values (n,) that are numbers and not absurd, in double precision."""
    values = values.astype(float)
    return values[np.abs(values) <= LARGEST]


def colour_range(values: np.ndarray, whole: bool) -> tuple[float, float, str]:
    """Lowest and highest colour and the ends that lie beyond; the outermost half percent may, unless ``whole``."""
    values = usable(values)
    if len(values) == 0:
        return 0.0, 1.0, "neither"
    lowest, highest = float(values.min()), float(values.max())
    low, high = (lowest, highest) if whole else map(float, np.quantile(values, (0.005, 0.995)))
    # an end is cut only where this gains something: colours for the many instead of the few
    low = lowest if low - lowest < 0.1 * (high - low) else low
    high = highest if highest - high < 0.1 * (high - low) else high
    if high - low <= 1e-6 * max(abs(low), abs(high)):
        low, high = low - 0.5 * (abs(low) or 1.0), high + 0.5 * (abs(high) or 1.0)
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}
    return low, high, extend[low > lowest, high < highest]


def ticks_around(low: float, middle: float, high: float) -> list[float]:
    """Round values on both sides of ``middle`` and ``middle`` itself."""
    locator = MaxNLocator(4, steps=[1, 2, 2.5, 5, 10])
    ticks: list[float] = [round(middle, 0 if high - low >= 10.0 else 2)]
    for start, end in ((low, middle), (middle, high)):
        margin = 0.12 * (end - start)
        ticks += [
            tick for tick in locator.tick_values(start, end) if start <= tick <= end and abs(tick - middle) > margin
        ]
    return sorted(ticks)
