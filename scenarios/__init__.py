"""What is simulated: one file per case. Importing this package registers them all."""

from warpsph.scenarios.breakout import Breakout
from warpsph.scenarios.cantilever import Cantilever
from warpsph.scenarios.casting import Casting
from warpsph.scenarios.compensated_drift import CompensatedDrift
from warpsph.scenarios.dam_break import DamBreak
from warpsph.scenarios.drop import Drop
from warpsph.scenarios.heat_gaussian import HeatGaussian
from warpsph.scenarios.hydrostatic import Hydrostatic
from warpsph.scenarios.neighbour_search import NeighbourSearch
from warpsph.scenarios.rotated_disc import RotatedDisc
from warpsph.scenarios.rubber_rings import RubberRings

__all__ = [
    "Breakout",
    "Cantilever",
    "Casting",
    "CompensatedDrift",
    "DamBreak",
    "Drop",
    "HeatGaussian",
    "Hydrostatic",
    "NeighbourSearch",
    "RotatedDisc",
    "RubberRings",
]
