"""The physics: one file a term."""

from warpsph.terms.alloy import Alloy
from warpsph.terms.bonded_phase import BondedPhase
from warpsph.terms.buoyancy import Buoyancy
from warpsph.terms.colour_field_tension import ColourFieldTension
from warpsph.terms.conduction import Conduction
from warpsph.terms.contact import Contact
from warpsph.terms.continuity_density import ContinuityDensity
from warpsph.terms.corrected_conduction import CorrectedConduction
from warpsph.terms.corrected_fluid import CorrectedFluid
from warpsph.terms.damping import Damping
from warpsph.terms.delta_fluid import DeltaFluid
from warpsph.terms.driving_source import DrivingSource
from warpsph.terms.elasticity import Elasticity
from warpsph.terms.enclosed import Enclosed
from warpsph.terms.floor import Floor
from warpsph.terms.fluid import Fluid
from warpsph.terms.gradient_walls import GradientWalls
from warpsph.terms.heat_sources import HeatSources, PointSource
from warpsph.terms.heat_wall import HeatWall, cut_cells
from warpsph.terms.integrators import BackwardEuler, CrankNicolson, Explicit
from warpsph.terms.lamp import Lamp
from warpsph.terms.liquidus import Liquidus
from warpsph.terms.pair_potential import PairPotential
from warpsph.terms.phase_change import PhaseChange
from warpsph.terms.precise_motion import PreciseMotion
from warpsph.terms.profile import Profile
from warpsph.terms.solute import Solute
from warpsph.terms.summed_density import SummedDensity
from warpsph.terms.surface_tension import SurfaceTension
from warpsph.terms.thermal_viscosity import ThermalViscosity
from warpsph.terms.wall_friction import WallFriction
from warpsph.terms.whole_phases import WholePhases

__all__ = [
    "Alloy",
    "BackwardEuler",
    "BondedPhase",
    "Buoyancy",
    "ColourFieldTension",
    "Conduction",
    "Contact",
    "ContinuityDensity",
    "CorrectedConduction",
    "CorrectedFluid",
    "CrankNicolson",
    "Damping",
    "DeltaFluid",
    "DrivingSource",
    "Elasticity",
    "Enclosed",
    "Explicit",
    "Floor",
    "Fluid",
    "GradientWalls",
    "HeatSources",
    "HeatWall",
    "Lamp",
    "Liquidus",
    "PairPotential",
    "PhaseChange",
    "PointSource",
    "PreciseMotion",
    "Profile",
    "Solute",
    "SummedDensity",
    "SurfaceTension",
    "ThermalViscosity",
    "WallFriction",
    "WholePhases",
    "cut_cells",
]
