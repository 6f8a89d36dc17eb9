"""Elastic solids of bonded particles."""

from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Field, Value
from warpsph.core.guard import note_row
from warpsph.core.labels import Phase, Role
from warpsph.core.lattice import Lattice
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import number, require
from warpsph.kernels.basics.guard import BONDS
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.neighbours.cells import clear
from warpsph.kernels.neighbours.lists import clear_flag
from warpsph.kernels.neighbours.reorder import invert
from warpsph.kernels.solid.bonds import (
    BondList,
    copy_bonds,
    join_body,
    mark_bonded_neighbours,
    move_bonds,
    update_bonds,
)
from warpsph.kernels.solid.borne import fade_bond_forces, find_bond_forces, keep_bond_forces
from warpsph.kernels.solid.elasticity import add_elastic_forces, find_stress, settle_volume
from warpsph.kernels.solid.strain import ElasticConstants, keep_strain
from warpsph.terms.phase_change import PhaseChange
from warpsph.terms.weakly_compressible import WeaklyCompressible

BYTES_PER_BOND = 48  # partner, separation, slope, value, what it bears besides its stress, and its whole force

# In spacings. Where the pressure of the melt is zero particles may freeze almost on top of each other; a stiffness of
# the hourglass control that grows as the inverse square of such a length would be unstable at any time step.
SHORTEST_BOND = 0.65

# Angular frequency times the longest step at which one particle's strain may swing. At 2 it alone would be unstable;
# it swings together with those of its neighbours, and grows stiffer as it is stretched. The corner of a cube bonded to
# its three nearest has 1.
OWN_SWING = 1.01

# Times in which the elastic wave crosses a spacing, over which bonds forget what they bear besides their stress: long
# beside the swings of a skin one particle thick (some 25), short beside the growth of a shell.
FADING = 280.0
LONGEST_FADE = 0.1  # over that time, between two steps with heat
# Forces that a bond bears besides its stress, over E and the face of a cell: below the least one it forgets them, above
# the little one ends that are not well held do not bear them. The pressure of a melt is some thousandths.
LEAST_BORNE, LITTLE_BORNE = 1e-6, 0.01

WAVE_LIMIT = 5.0  # times the speed of the elastic wave, at which a run counts as diverged


@dataclass(frozen=True, eq=False)
class Elasticity(Term):
    """Elastic solid of bonded particles (Vijaykumar 2012, chapter 4).

    Bonds join neighbours of the same ``body``; melt that freezes joins the body of the nearest particle that is solid.

    Args:
        youngs_modulus: E [Pa].
        poisson_ratio: nu.
        corrected: correct the displacement gradient by the moment matrix; False is the published form.
        hourglass: strength of the control of zero-energy modes (Ganzenmueller 2015), 0 for none.
        support_ratio: length of the longest bonds over the spacing; None for the support of the model.
    """

    youngs_modulus: float
    poisson_ratio: float
    corrected: bool = True
    hourglass: float = 0.1
    support_ratio: float | None = None

    def __post_init__(self) -> None:
        require(self, "youngs_modulus", 0.0 < number(self.youngs_modulus) < np.inf, "positive [Pa]")
        require(
            self,
            "poisson_ratio",
            -1.0 < number(self.poisson_ratio) < 0.5,
            "between -1 and 0.5 (an incompressible solid)",
        )
        ratio = self.support_ratio
        require(
            self, "support_ratio", ratio is None or 1.2 <= number(ratio) <= 10.0, "None, or from 1.2 to 10 spacings"
        )
        require(self, "hourglass", 0.0 <= number(self.hourglass) < np.inf, "zero or positive")

    keeps_momentum = True
    provides = ("elasticity",)
    needs = ("forces",)
    follows = ("fluid", "density", "a change of phase", "surface tension")

    froze = PhaseChange.froze
    body = Field(int, "", "to which body it belongs")
    body_volume = Field(float, "m^3", "volume when it turned solid (area in 2D)")
    correction = Field(wp.mat33, "", "inverse moment matrix of the bonds")
    settled = Field(wp.mat33, "", "from the shape without stress to the one that the bonds count from")
    was_held = Field(int, "", "whether its bonds held it well before they came or went", kept=False)
    rebonded = Field(int, "", "whether bonds have come or gone just now", kept=False)
    deformation = Field(wp.mat33, "", "deformation gradient since the bonds were made")
    stress = Field(wp.mat33, "Pa", "first Piola-Kirchhoff stress, times the correction")
    bond_events = Value(int, "", "how often bonds have been made and cut")
    longest_bond_row = Value(int, "", "not zero when a row of bonds was too short")

    @property
    def lame(self) -> tuple[float, float]:
        """lambda and mu [Pa] of Hooke's law (4.5)."""
        E, nu = self.youngs_modulus, self.poisson_ratio
        return E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), E / (2.0 * (1.0 + nu))

    def wave_speed(self, density: float) -> float:
        """Speed of the elastic compression wave [m/s]."""
        lame_lambda, lame_mu = self.lame
        return float(np.sqrt((lame_lambda + 2.0 * lame_mu) / density))

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        densities = np.array([material.density for material in model.materials])
        volume = fields["mass"] / densities[fields["material"]]
        unstrained = np.tile(np.eye(3), (len(particles), 1, 1))
        return {
            "froze": fields["phase"] == Phase.SOLID,
            "body_volume": volume,
            "deformation": unstrained,
            "settled": unstrained,
        }

    def allocate(self, model: Model, state: State) -> None:
        capacity = self._bonds_each(model)
        state.hold_list("bonds", _empty_bonds(capacity, state))
        state.hold_list("spare_bonds", _empty_bonds(capacity, state), scratch=True)

    def bytes_each(self, model: Model) -> float:
        return 2.0 * (BYTES_PER_BOND * self._bonds_each(model) + 4)

    def _bonds_each(self, model: Model) -> int:
        lattice = Lattice(model.dimension, model.spacing, self.reach(model) / model.spacing)
        return int(1.6 * len(lattice.offsets)) + 4

    def constants(self, model: Model, state: State) -> dict[str, object]:
        reach = self.reach(model)
        scale = normalisation("sine", model.dimension, reach)
        planar = int(model.dimension == 2)
        constants = {"elastic": self._constants(model, state), "reach": reach, "scale": scale, "planar": planar}
        constants["fading_time"] = max(self.fading_time(model, m) for m in _free_materials(model, state))
        force = self.youngs_modulus * model.spacing ** (model.dimension - 1)
        constants |= {"least_force": LEAST_BORNE * force, "little_force": LITTLE_BORNE * force}
        fluid = model.find(WeaklyCompressible)
        if fluid is None:
            return constants
        frozen = {"frozen_from": fluid, "reference_density": fluid.reference_density}
        return constants | frozen | fluid.device_constants(model)

    def fading_time(self, model: Model, material: int) -> float:
        """How long bonds of a ``material``, by its index, remember what they bear besides their stress [s]."""
        return FADING * model.spacing / self.wave_speed(model.materials[material].density)

    def longest_intervals(self, model: Model) -> dict[str, float]:
        """Where something freezes: what bonds bear fades in steps with heat, and is not to fall in one."""
        if not any("a change of phase" in term.provides for term in model.terms):
            return {}
        melting = [m for m, material in enumerate(model.materials) if material.melts]
        fading = min((self.fading_time(model, m) for m in melting), default=np.inf)
        return {"fading of what bonds bear": LONGEST_FADE * fading} if melting else {}

    def reach(self, model: Model) -> float:
        return model.support if self.support_ratio is None else self.support_ratio * model.spacing

    def longest_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        return {} if _in_small_steps(model) else self._longest(model, moving)

    def longest_small_steps(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        return self._longest(model, moving) if _in_small_steps(model) else {}

    def _longest(self, model: Model, moving: tuple[int, ...]) -> dict[str, float]:
        """The elastic wave, and the melt's sound with it, across half a spacing: bonds may be shorter than one."""
        wave = max((self.wave_speed(model.materials[m].density) for m in moving), default=0.0)
        if fluid := model.find(WeaklyCompressible):
            wave = float(np.hypot(wave, fluid.sound_speed))
        return {"elastic wave": 0.5 * model.spacing / wave} if wave > 0.0 else {}

    def speed_limit(self, model: Model) -> float:
        """Where nothing flows: a fluid may be faster than the waves of a soft solid, and has a limit of its own."""
        if any("fluid" in term.provides for term in model.terms):
            return np.inf
        return WAVE_LIMIT * max(self.wave_speed(material.density) for material in model.materials)

    def initialise(self, launch: Launch) -> None:
        launch.when("phase_changed", lambda: self._bond_solids(launch))
        launch(clear, values=launch.find("froze"))

    def sum_forces(self, launch: Launch) -> None:
        if "fast_acceleration" not in launch:
            launch(find_stress)

    def add_forces(self, launch: Launch) -> None:
        if "fast_acceleration" not in launch:
            launch(add_elastic_forces)

    def sum_fast_forces(self, launch: Launch) -> None:
        launch(find_stress)

    def add_fast_forces(self, launch: Launch) -> None:
        launch(add_elastic_forces, acceleration=launch.find("fast_acceleration"))

    def change_phases(self, launch: Launch) -> None:
        launch(fade_bond_forces)
        launch.when("phase_changed", lambda: self._renew_bonds(launch))

    def follow_sorting(self, launch: Launch) -> None:
        bonds, spare = launch.find("bonds"), launch.find("spare_bonds")
        launch(invert)
        launch(move_bonds, target=spare)
        launch(copy_bonds, bonds=spare, target=bonds)

    def follow_listing(self, launch: Launch) -> None:
        launch(mark_bonded_neighbours)

    def _renew_bonds(self, launch: Launch) -> None:
        launch(find_stress)
        if "frozen_from" in launch:
            launch(settle_volume)
        launch(find_bond_forces)
        launch(join_body)
        self._bond_solids(launch)
        launch(find_stress)
        if "frozen_from" in launch:
            launch.find("frozen_from").keep_pressure(launch)
        launch(keep_bond_forces)

    def _bond_solids(self, launch: Launch) -> None:
        launch(update_bonds)
        note_row(launch, BONDS, self.longest_bond_row, launch.find("bonds").capacity)
        if "frozen_from" in launch:
            launch.find("frozen_from").keep_density(launch)
        launch(keep_strain)
        launch(mark_bonded_neighbours)
        launch.whole(clear_flag, flag=launch.find("phase_changed"), counter=self.bond_events)

    def _constants(self, model: Model, state: State) -> ElasticConstants:
        step = min(self._longest(model, _free_materials(model, state)).values(), default=np.inf)
        constants = ElasticConstants()
        constants.lame_lambda, constants.lame_mu = self.lame
        constants.youngs_modulus = self.youngs_modulus
        constants.hourglass = self.hourglass
        constants.shortest_squared = (SHORTEST_BOND * model.spacing) ** 2
        constants.highest_frequency_squared = (OWN_SWING / step) ** 2 if np.isfinite(step) else np.inf
        constants.corrected = int(self.corrected)
        constants.planar = int(model.dimension == 2)
        return constants


def _free_materials(model: Model, state: State) -> tuple[int, ...]:
    """Indices of the materials of free particles, of all materials where there are none."""
    free = state.numpy("material")[state.numpy("role") == Role.FREE]
    return tuple(int(material) for material in np.unique(free)) or tuple(range(len(model.materials)))


def _in_small_steps(model: Model) -> bool:
    return any("small steps" in term.provides for term in model.terms)


def _empty_bonds(capacity: int, state: State) -> BondList:
    bonds = BondList()
    bonds.capacity = capacity
    entries = state.count * bonds.capacity
    bonds.count = wp.zeros(state.count, dtype=int, device=state.device)
    bonds.partner = wp.zeros(entries, dtype=int, device=state.device)
    bonds.separation = wp.zeros(entries, dtype=wp.vec3, device=state.device)
    bonds.slope = wp.zeros(entries, dtype=float, device=state.device)
    bonds.value = wp.zeros(entries, dtype=float, device=state.device)
    bonds.borne = wp.zeros(entries, dtype=wp.vec3, device=state.device)
    bonds.whole = wp.zeros(entries, dtype=wp.vec3, device=state.device)
    return bonds
