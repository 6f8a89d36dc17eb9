"""The published solids: places and velocities of their particles."""

import csv
from dataclasses import dataclass
from importlib.resources import files

import numpy as np


@dataclass(frozen=True)
class Table:
    """Particles of a solid, in the order of the publication.

    Attributes:
        places: (n, 2) [ft].
        velocities: (n, 2) [ft/s].
    """

    places: np.ndarray
    velocities: np.ndarray

    @property
    def partners(self) -> np.ndarray:
        """Index (n,) of the particle that stands where the mirror image about x = 0 of each one is."""
        mirrored = self.places * (-1.0, 1.0)
        return np.array([np.argmin(np.linalg.norm(self.places - place, axis=1)) for place in mirrored])


def published(name: str, corrected: bool = False) -> Table:
    """The table ``data/<name>.csv``, as printed, or with what restores its symmetry."""
    text = (files("warpsph.scenarios.bonded_solid") / "data" / f"{name}.csv").read_text()
    rows = list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))
    if corrected:
        for row in rows:
            if change := row.get("correction"):
                key, _, value = change.partition("=")
                row[key] = value
    numbers = np.array([[float(row[key]) for key in ("x", "y", "vx", "vy")] for row in rows])
    return Table(numbers[:, :2], numbers[:, 2:])
