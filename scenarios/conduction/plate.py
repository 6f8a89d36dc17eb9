"""What the plates of Rook, Yildiz & Dost (2007) have in common: size, material, particles, errors against a series."""

from collections.abc import Sequence
from typing import ClassVar

import numpy as np
from pydantic import model_validator

from warpsph.cases.scenario import parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.core.term import Term
from warpsph.run.measured import Measured, Values
from warpsph.run.simulation import Simulation
from warpsph.scenarios.conduction.plate_series import Plate
from warpsph.scenarios.conduction.time_stepping import ConductingScenario
from warpsph.terms import Conduction, HeatWall

DENSITY = 1000.0  # [kg/m^3]
SOURCE = "Rook, Yildiz & Dost (2007)"
SMOOTHING_KERNEL = "cubic_spline"


class CoolingPlate(ConductingScenario):
    """A plate of one temperature that cools by its edges, with particles in rows along them.

    Class attributes: ``fouriers``, the times of the figures over the square of the length and the diffusivity.
    """

    fouriers: ClassVar[tuple[float, ...]]

    duration: float = parameter(8.0, "s", "physical time to simulate", gt=0, le=1e6)
    output_interval: float = parameter(0.25, "s", "physical time between two frames and diagnostics", gt=0, le=1e6)
    step: float = parameter(
        0.009, "s", "longest time step; explicit steps are shorter where stability asks for it", gt=0, le=1e6
    )
    across: int = parameter(40, "", "particles along x", ge=8, le=2000)
    length: float = parameter(0.1, "m", "length of the plate along x", gt=1e-3, le=10.0)
    height: float = parameter(0.1, "m", "length of the plate along y, in whole spacings", gt=1e-3, le=10.0)
    start: float = parameter(373.15, "K", "temperature at the start", gt=0, le=5e3)
    diffusivity: float = parameter(1.0e-4, "m^2/s", "thermal diffusivity", gt=0, le=1.0)
    conductivity: float = parameter(100.0, "W/(m K)", "thermal conductivity", gt=0, le=1e4)
    smoothing_length: float = parameter(
        1.0, "", "smoothing length h of the cubic spline over the spacing", ge=0.75, le=1.5
    )
    exact_on_lattice: bool = parameter(True, "", "whether conduction is divided by what the lattice makes of it")
    equal_shares: bool = parameter(
        False, "", "whether each particle has the plate's area over their number, as published, instead of its cell"
    )

    @property
    def row_on_walls(self) -> bool:
        """Whether particles stand on the edges; otherwise half a spacing before them."""
        raise NotImplementedError

    @property
    def exact(self) -> Plate:
        """The exact solution."""
        raise NotImplementedError

    @property
    def walls(self) -> list[HeatWall]:
        """What is given on the edges."""
        raise NotImplementedError

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.length / (self.across - self.row_on_walls)

    @property
    def points(self) -> np.ndarray:
        """Places (n, 3) [m] of the particles, row by row along y."""
        beyond = 0.5 * self.spacing if self.row_on_walls else 0.0
        return lattice((-beyond, -beyond), (self.length + beyond, self.height + beyond), self.spacing)

    @property
    def share(self) -> float:
        """The plate's area over the number of particles [m^2]."""
        return self.length * self.height / len(self.points)

    @model_validator(mode="after")
    def _whole_rows(self):
        rows = self.height / self.spacing
        if abs(rows - round(rows)) > 1e-6 * rows or round(rows) < 6:
            raise ValueError(
                f"height = {self.height:g} m is {rows:.6g} spacings of {self.spacing:.6g} m: must be a whole number, 6 "
                f"or more; {max(round(rows), 6) * self.spacing:.8g} would do"
            )
        if self.start == self.exact.outside:
            raise ValueError(f"start = {self.start:g} K is the temperature outside: nothing would happen")
        return self

    def conduction(self, walls: Sequence[HeatWall]) -> Conduction:
        """Conduction with ``walls`` that have images."""
        return Conduction(
            longest_interval=self.step,
            walls=walls,
            smoothing=SMOOTHING_KERNEL,
            support_ratio=2.0 * self.smoothing_length,
            exact_on_lattice=self.exact_on_lattice,
            integrator=self.stepping,
        )

    def simulation(self, executor: Executor, particles: Particles, conduction: Conduction, *others: Term) -> Simulation:
        """The plate at rest, with what conducts its heat."""
        plate = solid_material(
            "plate",
            density=DENSITY,
            heat_capacity=self.conductivity / (self.diffusivity * DENSITY),
            conductivity=self.conductivity,
        )
        model = Model(2, self.spacing, (plate,), (conduction, *others), gravity=(0.0, 0.0, 0.0))

        def observe(state: Snapshot, time: float) -> Values:
            error = self.errors(state["position"], state["temperature"], time)
            heat = np.sum((state["mass"].astype(float) * state["enthalpy"])[state["held"] == 0])
            taken = np.sum(conduction.heat_to_walls()) + np.sum(state["heat_held"])
            return {
                "rms_error": Measured(rms(error), "K", "root mean square", panel="error of T"),
                "largest_error": Measured(float(np.abs(error).max()), "K", "largest", panel="error of T"),
                "heat": Measured(float(heat), "J", "of the particles that are not held", per_depth=True, panel="heat"),
                "heat_taken": Measured(float(taken), "J", "taken by the edges", per_depth=True, panel="heat"),
            }

        return Simulation(executor, model, particles, observe=observe)

    def placed(self, volume: np.ndarray | float, **fields: np.ndarray) -> Particles:
        """All particles; ``volume`` [m^2] is that of each where they do not have equal shares."""
        particles = Particles()
        values = {"temperature": np.full(len(self.points), self.start)} | fields
        particles.add(self.points, Role.FREE, volume=self.share if self.equal_shares else volume, **values)
        return particles

    def errors(self, position: np.ndarray, temperature: np.ndarray, time: float) -> np.ndarray:
        """Difference (n,) [K] to the series; 0 at the start."""
        if time == 0.0:
            return np.zeros(len(position))
        return temperature - self.exact.temperature(position, time)


def rms(error: np.ndarray) -> float:
    """Root mean square."""
    return float(np.sqrt(np.mean(error**2)))
