"""What is simulated: one file per case. Importing this package registers them all."""

from warpsph.scenarios import casting

__all__ = ["casting"]
