"""A tank of liquid at rest, in 2D and 3D: how far its pressure scatters, and whether it calms down."""

from collections.abc import Callable, Iterable
from typing import Literal

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import GRAVITY, Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.core.state import Snapshot
from warpsph.core.term import Term
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.run.statistics import value_at_zero
from warpsph.terms import CorrectedFluid, Fluid, SummedDensity

DISORDER = 0.1  # of the spacing, the largest displacement of a disordered start
CALM = 0.2  # strength of the viscosity under the surface


class StillTank(Scenario):
    """A tank as wide as the liquid is high; sound runs ten times as fast as the liquid would fall."""

    name = "still_tank"
    summary = "a tank of liquid at rest: scatter of its pressure, in 2D or 3D, with two formulations"
    source = "p = rho g (h - y)"
    presets = ("space", "published")

    duration: float = parameter(10.0, "s", "physical time to simulate", gt=0, le=1e3)
    output_interval: float = parameter(0.25, "s", "physical time between two frames and diagnostics", gt=0, le=1e3)
    formulation: Literal["corrected", "published"] = parameter(
        "corrected", "", "the calm flow, or that of Vijaykumar (2012)"
    )
    dimension: Literal[2, 3] = parameter(2, "", "2 for the plane, 3 for a tank as deep as half its width")
    rows: int = parameter(24, "", "rows of particles over the height", ge=8, le=400)
    height: float = parameter(1.0, "m", "height h of the liquid", ge=0.01, le=10.0)
    density: float = parameter(1000.0, "kg/m^3", "density of the liquid", ge=1.0, le=2e4)
    viscosity: float = parameter(0.0, "Pa s", "dynamic viscosity of the liquid", ge=0.0, le=1e5)
    start: Literal["hydrostatic", "disordered", "unpressed"] = parameter(
        "hydrostatic", "", "at its pressure, the same with particles displaced by up to a tenth, or without pressure"
    )

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.height / self.rows

    @property
    def sound_speed(self) -> float:
        """Speed of sound [m/s]."""
        return float(10.0 * np.sqrt(2.0 * GRAVITY * self.height))

    def build(self, executor: Executor) -> Simulation:
        dx, h, dimension = self.spacing, self.height, self.dimension
        lower, upper = (0.0,) * dimension, (h, h, 0.5 * h)[:dimension]
        liquid, walls = lattice(lower, upper, dx), tank(lower, (h, 1.3 * h, 0.5 * h)[:dimension], dx)
        pressure = np.zeros(len(liquid))
        if self.start != "unpressed":
            pressure = self.exact_pressure(liquid[:, 1])
        if self.start == "disordered":
            shift = np.random.default_rng(1).uniform(-DISORDER * dx, DISORDER * dx, (len(liquid), dimension))
            liquid[:, :dimension] += shift
        particles = Particles()
        terms: tuple[Term, ...] = (Fluid(self.density, self.sound_speed), SummedDensity())
        if self.formulation == "corrected":
            compression = pressure / (self.density * self.sound_speed**2)
            particles.add(liquid, Role.FREE, "liquid", pressure=pressure, compression=compression)
            face = way_to_box(walls, (0.0, 0.0, 0.0), (h, np.inf, 0.5 * h if dimension == 3 else 0.0))
            particles.add(walls, Role.DUMMY, "wall", to_surface=face)
            terms = (CorrectedFluid(self.density, self.sound_speed, free_surface=True, surface_viscosity=CALM),)
        else:
            particles.add(liquid, Role.FREE, "liquid")
            particles.add(walls, Role.DUMMY, "wall")
        model = Model(
            dimension=dimension,
            spacing=dx,
            materials=(fluid_material("liquid", self.density, self.viscosity), solid_material("wall", self.density)),
            terms=terms,
        )
        return Simulation(executor, model, particles, observe=self._observe)

    def exact_pressure(self, y: np.ndarray) -> np.ndarray:
        """Pressure [Pa] at the height y [m]."""
        return self.density * GRAVITY * (self.height - y)

    def _observe(self, state: Snapshot, time: float) -> Values:
        liquid, load = state["role"] == Role.FREE, self.density * GRAVITY * self.height
        x = state["position"][liquid].astype(float)
        y, p = x[:, 1], state["pressure"][liquid].astype(float)
        error = (p - self.exact_pressure(y)) / load
        low = y < max(self.height / 8.0, 2.25 * self.spacing)
        bottom = value_at_zero(y[low], p[low]) / load - 1.0
        speed = np.sqrt(np.mean(np.sum(state["velocity"][liquid].astype(float) ** 2, axis=1)))
        outside = (y < 0.0) | (x[:, 0] < 0.0) | (x[:, 0] > self.height)
        if self.dimension == 3:
            outside |= (x[:, 2] < 0.0) | (x[:, 2] > 0.5 * self.height)
        panel = "over the pressure at the bottom"
        return {
            "pressure_error": Measured(float(np.sqrt(np.mean(error**2))), "", "RMS error of the pressure", panel=panel),
            "bottom_error": Measured(bottom, "", "error at the bottom", panel=panel),
            "speed": Measured(float(speed / np.sqrt(GRAVITY * self.height)), "", "RMS speed over sqrt(g h)"),
            "escaped": Measured(float(np.sum(outside)), "", "particles outside the tank"),
        }

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Without friction, and with little in a disordered tank; where there is time, from no pressure, and in 3D."""
        cases = [cls(), cls(start="disordered", viscosity=cls().viscosity_of_cell(10.0))]
        if slow:
            cases += [cls(start="unpressed", duration=30.0), cls(dimension=3)]
        for case in cases:
            yield from case.checks(simulate(case))

    def viscosity_of_cell(self, reynolds: float) -> float:
        """Viscosity [Pa s] at which c dx rho / mu is ``reynolds``."""
        return self.sound_speed * self.spacing * self.density / reynolds

    def checks(self, result: Result) -> list[Check]:
        """The last quarter of the run, in which waves of the start are gone."""
        series = result.diagnostics
        late = series["time"] >= 0.75 * result.time
        case = f"{self.dimension}D, {self.rows} rows, {self.start}, mu = {self.viscosity:.3g} Pa s"
        rms = float(np.sqrt(np.mean(series["pressure_error"][late] ** 2)))
        row = f"a twentieth of a row at the surface: {0.05 / self.rows:.1e}; and sound that the surface feeds"
        named = [
            ("RMS error of particle pressure over that at the bottom", rms, 0.01, row),
            ("error of the bottom pressure", float(series["bottom_error"][late].mean()), 0.005, row),
            ("RMS speed over sqrt(g h)", float(series["speed"][late].max()), 2e-3, "noise of the surface"),
            ("particles outside the tank", float(series["escaped"].max()), 0.0, "a tank is tight"),
        ]
        return [
            Check(self.name, f"{what} ({case})", "", value, None, allowed, self.source, reason=reason)
            for what, value, allowed, reason in named
        ]
