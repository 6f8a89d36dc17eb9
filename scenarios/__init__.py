"""What is simulated: one file per case. Importing this package registers them all."""

from warpsph.scenarios import casting, compensated_drift, heat_gaussian, neighbour_search, rotated_disc

__all__ = ["casting", "compensated_drift", "heat_gaussian", "neighbour_search", "rotated_disc"]
