"""A solute that diffuses in a liquid."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.content import Content
from warpsph.core.field import Field
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.periodic import axes_across
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, require
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.heat.solute import add_solute, find_solute, sum_solute
from warpsph.kernels.heat.walls import HeatWalls
from warpsph.terms.conduction import Conduction
from warpsph.terms.heat_wall import SLACK, HeatWall, refuse_misfits

SMOOTHING_KERNEL = "cubic_spline"
LOST = 1.0e-6  # relative: pairs exchange exactly, but for the rounding of their rates in single precision


@dataclass(frozen=True, eq=False)
class Solute(Term):
    """Diffusion of a solute (Monaghan, Huppert & Worster 2005, section 2.3).

    Args:
        diffusivity: D [kg/(m s)], the density times the diffusion coefficient; one for all materials, or one each by
            name, 0 for those that are not named. A pair has the harmonic mean.
        walls: planes that bound the liquid, as those of heat; nothing passes them. Without them nothing leaves the
            particles either, but those at an edge see half their neighbours.
    """

    diffusivity: float | Mapping[str, float] = 0.0
    walls: Sequence[HeatWall] = ()

    def __post_init__(self) -> None:
        given = self.diffusivity.values() if isinstance(self.diffusivity, Mapping) else [self.diffusivity]
        bounded = all(0.0 <= number(value) < np.inf for value in given)
        require(self, "diffusivity", bounded, "zero or positive [kg/(m s)], one for all or one each by material")
        several = isinstance(self.walls, Sequence) and all(isinstance(wall, HeatWall) for wall in self.walls)
        require(self, "walls", several, "a tuple of HeatWall")

    provides = ("solute",)

    solute = Field(float, "", "mass fraction of solute in the liquid", written=True)
    solute_mass = Field(wp.float64, "kg", "mass of solute (per metre of depth in 2D)", least=0.0)
    solute_rate = Field(float, "kg/s", "solute gained in unit time (per metre of depth in 2D)", kept=False)
    liquid_mass = Field(wp.float64, "kg", "mass of liquid (per metre of depth in 2D)", least=0.0)
    liquid_fraction = Field(float, "", "volume fraction of liquid", start=1.0)
    thermal_volume = Conduction.thermal_volume

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        fraction = fields["solute"]
        if np.any((fraction < 0.0) | (fraction >= 1.0)):
            raise InputError("particles: 'solute' must be a mass fraction, from 0 to less than 1")
        refuse_behind(self.walls, model, particles.position)
        volume = np.where(particles.volume > 0.0, particles.volume, model.cell_volume)
        liquid = fields["liquid_mass"] if "liquid_mass" in particles.given else fields["mass"]
        return {"thermal_volume": volume, "liquid_mass": liquid, "solute_mass": fraction * liquid}

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return axes_across(*(wall.normal for wall in self.walls))

    def contents(self, model: Model, state: State) -> dict[str, Content]:
        solute = float(np.sum(state.numpy("solute_mass")))
        return {"solute": Content(solute, solute, "kg", LOST)}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        scale = normalisation(SMOOTHING_KERNEL, model.dimension, model.support)
        return {
            "solute_diffusivity": wp.array(self._diffusivities(model), dtype=float, device=state.device),
            "solute_support": model.support,
            "solute_scale": scale / model.lattice.slope(SMOOTHING_KERNEL),
            "solute_walls": planes(self.walls, model, state.device),
        }

    def reach(self, model: Model) -> float:
        return model.support

    def longest_intervals(self, model: Model) -> dict[str, float]:
        """By material: 0.15 of Monaghan et al. (2005), equation (2.20), with h half the support."""
        return {
            f"solute in {material.name} (2.20)": 0.15 * material.density * (0.5 * model.support) ** 2 / diffusivity
            for material, diffusivity in zip(model.materials, self._diffusivities(model), strict=True)
            if diffusivity > 0.0
        }

    def sum_heat(self, launch: Launch) -> None:
        launch(sum_solute)

    def add_heat(self, launch: Launch) -> None:
        launch(add_solute)

    def find_temperature(self, launch: Launch) -> None:
        launch(find_solute)

    def _diffusivities(self, model: Model) -> list[float]:
        """D of each material [kg/(m s)]."""
        if not isinstance(self.diffusivity, Mapping):
            return [self.diffusivity] * len(model.materials)
        for name in self.diffusivity:
            model.index_of(name)
        return [self.diffusivity.get(material.name, 0.0) for material in model.materials]


def planes(walls: Sequence[HeatWall], model: Model, device: wp.Device) -> HeatWalls:
    """The walls on the device, as mirrors that take nothing."""
    mirrors = HeatWalls()
    if walls:
        mirrors.normal = wp.array([wall.normal for wall in walls], dtype=wp.vec3d, device=device)
        mirrors.offset = wp.array([wall.offset for wall in walls], dtype=wp.float64, device=device)
        for name in ("conductance", "outside", "flux"):
            setattr(mirrors, name, wp.array([getattr(w, name) for w in walls], dtype=float, device=device))
        mirrors.slack = SLACK * model.spacing
    return mirrors


def refuse_behind(walls: Sequence[HeatWall], model: Model, points: np.ndarray) -> None:
    """Refuse walls whose images would be wrong, and particles behind one of them.

    Raises:
        InputError: it is so.
    """
    refuse_misfits(walls, model.lattice, points)
    for number_of, wall in enumerate(walls):
        if behind := int(np.sum(wall.height(points) < -SLACK * model.spacing)):
            raise InputError(f"wall {number_of}: {behind} particles are behind it; turn its normal towards the body")
