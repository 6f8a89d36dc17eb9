"""Boundary devices: small objects that act on the state during a step, on the device."""

from warpsph.boundary.inlet import Inlet
from warpsph.boundary.level import LevelGauge
from warpsph.boundary.mould import OscillatingMould
from warpsph.boundary.outflow import Outflow
from warpsph.boundary.spray import Spray, SprayZone
from warpsph.boundary.symmetry import SymmetryPlane

__all__ = ["Inlet", "LevelGauge", "OscillatingMould", "Outflow", "Spray", "SprayZone", "SymmetryPlane"]
