"""Parts of machines: small objects that act on the state at their moments of a step, on the device."""

from warpsph.machine.inlet import Inlet
from warpsph.machine.level import LevelGauge
from warpsph.machine.mould import OscillatingMould
from warpsph.machine.outflow import Outflow
from warpsph.machine.rolls import Rolls
from warpsph.machine.settling import Settling
from warpsph.machine.speed import ShellSpeedometer
from warpsph.machine.spray import Spray, SprayZone
from warpsph.machine.symmetry import SymmetryPlane

__all__ = [
    "Inlet",
    "LevelGauge",
    "OscillatingMould",
    "Outflow",
    "Rolls",
    "Settling",
    "ShellSpeedometer",
    "Spray",
    "SprayZone",
    "SymmetryPlane",
]
