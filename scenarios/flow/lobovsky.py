"""The dam break of Lobovsky et al. (2014): where they measured, and one run of it, from a public copy of the data."""

from importlib.resources import files

import numpy as np

EXPERIMENT = "Lobovsky, Botia-Vera, Castellana, Mas-Soler & Souto-Iglesias (2014), H = 300 mm"
SENSORS = {"p1": 3e-3, "p2": 15e-3, "p3": 30e-3, "p4": 80e-3}  # heights on the end wall [m]
GAUGES = {"h1": 0.3, "h2": 0.865, "h3": 1.114, "h4": 1.3625}  # distances from the back wall [m]
_COLUMNS = {"p1": 1, "p2": 2, "p3": 4, "p4": 5}  # the third is a second sensor beside the second


def published_pressure(sensor: str) -> tuple[np.ndarray, np.ndarray]:
    """Time (n,) over sqrt(H / g) and pressure (n,) over rho g H of one run, not of the median of a hundred."""
    table = _table("dambreak_lobovsky_pressure_H300.csv")
    return table[:, 0], table[:, _COLUMNS[sensor]]


def published_level(gauge: str) -> tuple[np.ndarray, np.ndarray]:
    """Time (n,) over sqrt(H / g) and level (n,) over H."""
    table = _table(f"dambreak_lobovsky_level_{gauge.upper()}_H300.csv")
    return table[:, 0], table[:, 1]


def _table(name: str) -> np.ndarray:
    text = (files("warpsph.scenarios.flow") / "data" / name).read_text()
    return np.loadtxt(text.splitlines(), delimiter=",", skiprows=1)
