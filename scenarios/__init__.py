"""What is simulated: one file per case. Importing this package registers them all."""

from warpsph.scenarios.bonded_solid.melting_block import MeltingBlock
from warpsph.scenarios.bonded_solid.melting_rectangle import MeltingRectangle
from warpsph.scenarios.bonded_solid.melting_triangle import MeltingTriangle
from warpsph.scenarios.breakout.breakout import Breakout
from warpsph.scenarios.casting.casting import Casting
from warpsph.scenarios.conduction.heat_gaussian import HeatGaussian
from warpsph.scenarios.conduction.heat_slab import HeatSlab
from warpsph.scenarios.conduction.plate_convective import PlateConvective
from warpsph.scenarios.conduction.plate_fixed import PlateFixed
from warpsph.scenarios.crystal.crystal_growth import CrystalGrowth
from warpsph.scenarios.elastic.cantilever import Cantilever
from warpsph.scenarios.elastic.rotated_disc import RotatedDisc
from warpsph.scenarios.elastic.rubber_rings import RubberRings
from warpsph.scenarios.flow.cavity_flow import CavityFlow
from warpsph.scenarios.flow.couette import Couette
from warpsph.scenarios.flow.dam_break import DamBreak
from warpsph.scenarios.flow.dam_impact import DamImpact
from warpsph.scenarios.flow.drop import Drop
from warpsph.scenarios.flow.free_patch import FreePatch
from warpsph.scenarios.flow.hydrostatic import Hydrostatic
from warpsph.scenarios.flow.natural_convection import NaturalConvection
from warpsph.scenarios.flow.poiseuille import Poiseuille
from warpsph.scenarios.flow.still_tank import StillTank
from warpsph.scenarios.flow.taylor_green import TaylorGreen
from warpsph.scenarios.freezing.cavity import Cavity
from warpsph.scenarios.freezing.point_sink import PointSink
from warpsph.scenarios.freezing.sodium_nitrate import SodiumNitrate
from warpsph.scenarios.freezing.stefan_slab import StefanSlab

__all__ = [
    "Breakout",
    "Cantilever",
    "Casting",
    "Cavity",
    "CavityFlow",
    "Couette",
    "CrystalGrowth",
    "DamBreak",
    "DamImpact",
    "Drop",
    "FreePatch",
    "HeatGaussian",
    "HeatSlab",
    "Hydrostatic",
    "MeltingBlock",
    "MeltingRectangle",
    "MeltingTriangle",
    "NaturalConvection",
    "PlateConvective",
    "PlateFixed",
    "PointSink",
    "Poiseuille",
    "RotatedDisc",
    "RubberRings",
    "SodiumNitrate",
    "StefanSlab",
    "StillTank",
    "TaylorGreen",
]
