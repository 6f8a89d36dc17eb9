"""What all solids of particles share: the bond, the floor, the step, and how the paper's units become SI."""

from collections.abc import Sequence

import numpy as np
from pydantic import model_validator

from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import Snapshot
from warpsph.core.term import Term
from warpsph.run.measured import Measured, Values
from warpsph.run.recorder import Observe
from warpsph.run.simulation import Simulation
from warpsph.scenarios.bonded_solid.tables import Table
from warpsph.terms import PairPotential, PreciseMotion

SOURCE = "Greenspan (1976)"
FOOT = 0.3048  # [m]; the unit of mass of the paper is 1 kg here
WIDTH, HEIGHT = 40.0, 12.0  # half width and height of the box in which most particles stay [ft]


def in_space(values: np.ndarray) -> np.ndarray:
    """Values (n, 2) in the plane as (n, 3)."""
    return np.column_stack([values, np.zeros(len(values))])


def observe_each(state: Snapshot, time: float) -> Values:
    """Which particles are fluid, and how far the body reaches."""
    fluid = state["phase"] == Phase.LIQUID
    x, y = state["precise_position"][:, :2].T
    return {
        "fluid": Measured(float(np.sum(fluid)), "", "particles that are fluid"),
        "is_fluid": Measured(fluid, "", "which particles are fluid"),
        "left": Measured(float(x.min()), "m", "leftmost", panel="reach of the particles"),
        "right": Measured(float(x.max()), "m", "rightmost", panel="reach of the particles"),
        "top": Measured(float(y.max()), "m", "highest", panel="reach of the particles"),
        "hottest": Measured(float(state["mean_energy"].max()), "J", "highest mean kinetic energy of a particle"),
    }


class ParticleSolid(Scenario):
    """A solid of particles of 1 kg that stands on a floor.

    Parameters have the units of the paper, feet and seconds, so that its numbers can be given as they are printed;
    results are in SI units.
    """

    attraction: float = parameter(2500.0, "kg ft/s^2 at 1 ft", "attraction G of two particles", gt=0, le=1e6)
    repulsion: float = parameter(2900.0, "kg ft/s^2 at 1 ft", "repulsion H of two particles", gt=0, le=1e6)
    attraction_exponent: int = parameter(4, "", "exponent beta of the attraction", ge=2, le=24)
    repulsion_exponent: int = parameter(6, "", "exponent alpha of the repulsion", ge=3, le=48)
    cutoff: float = parameter(1.5, "ft", "distance beyond which there is no force, and no bond", gt=0, le=10.0)
    gravity: float = parameter(32.0, "ft/s^2", "gravity, downwards", ge=0, le=1e3)
    restitution: float = parameter(0.1, "", "share of the speed of fall that the floor gives back", ge=0, le=1)
    step: float = parameter(1e-4, "s", "time step", gt=0, le=1.0)
    averaged_steps: int = parameter(1000, "", "steps of a mean velocity, and from phases to phases", ge=1, le=10**6)
    perturbation: float = parameter(0.0, "ft", "largest change of each coordinate at the start", ge=0, le=0.1)
    seed: int = parameter(0, "", "seed of the perturbation", ge=0, le=2**31)

    @model_validator(mode="after")
    def _check_solid(self) -> "ParticleSolid":
        if not self.repulsion_exponent > self.attraction_exponent:
            raise ValueError(
                f"repulsion_exponent = {self.repulsion_exponent}: must be above attraction_exponent, "
                f"{self.attraction_exponent}; otherwise particles collapse"
            )
        rest = (self.repulsion / self.attraction) ** (1.0 / (self.repulsion_exponent - self.attraction_exponent))
        if not self.cutoff > rest:
            raise ValueError(f"cutoff = {self.cutoff} ft: must be above the length of a bond at rest, {rest:.4g} ft")
        for name in ("output_interval", "duration"):
            intervals = getattr(self, name) / self.interval
            if round(intervals) < 1 or abs(intervals - round(intervals)) > 1e-6:
                raise ValueError(
                    f"{name} = {getattr(self, name)} s: must be a multiple of {self.interval:g} s, the "
                    f"{self.averaged_steps} steps after which phases are found"
                )
        return self

    @property
    def interval(self) -> float:
        """Time [s] of a mean velocity, after which phases are found anew."""
        return self.averaged_steps * self.step

    @property
    def potential(self) -> PairPotential:
        """The bond, in SI units."""
        beta, alpha = self.attraction_exponent, self.repulsion_exponent
        return PairPotential(
            self.attraction * FOOT ** (beta + 1), self.repulsion * FOOT ** (alpha + 1), beta, alpha, self.cutoff * FOOT
        )

    def simulation(
        self,
        executor: Executor,
        table: Table,
        terms: Sequence[Term],
        box: tuple[float, float] = (WIDTH, HEIGHT),
        observe: Observe = observe_each,
    ) -> Simulation:
        """The particles of a table with their bonds, and the ``terms`` that go with them.

        Most particles stay within ``box``, half width and height [ft].
        """
        potential = self.potential
        model = Model(
            dimension=2,
            spacing=potential.rest_length,
            support_ratio=1.2,
            materials=(solid_material("particles", 1.0 / potential.rest_length**2),),
            terms=(PreciseMotion(), potential, *terms),
            gravity=(0.0, -self.gravity * FOOT, 0.0),
        )
        noise = np.random.default_rng(self.seed).uniform(-self.perturbation, self.perturbation, table.places.shape)
        particles = Particles()
        particles.add(
            FOOT * in_space(table.places + noise),
            Role.FREE,
            velocity=FOOT * in_space(table.velocities),
            phase=Phase.SOLID,
            mass=1.0,
        )
        lower, upper = FOOT * np.array([(-box[0], -1.0, -1.0), (box[0], box[1], 1.0)])
        return Simulation(executor, model, particles, lower=lower, upper=upper, dt=self.step, observe=observe)
