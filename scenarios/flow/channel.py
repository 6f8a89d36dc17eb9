"""Fluid between two parallel plates, without ends: what poiseuille and couette share."""

from collections.abc import Callable, Iterable
from typing import Literal

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.faces import velocity_of_faces, way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.run.statistics import highest
from warpsph.scenarios.flow.channel_series import Channel
from warpsph.terms import CorrectedFluid, Enclosed

SOURCE = "Morris, Fox & Zhu (1997)"
LAYERS = 3
SHORTEST = 10  # cells along a periodic axis
FOURIERS = (0.02, 0.05, 0.1, 0.2, 1.0)  # times nu t / H^2 at which profiles are compared


class ParallelFlow(Scenario):
    """Fluid at rest between two plates, which a push along them or their own motion sets in motion."""

    duration: float = parameter(10.0, "s", "physical time to simulate", gt=0, le=1e6)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e6)
    dimension: Literal[2, 3] = parameter(2, "", "2 for the plane, 3 for a channel that is periodic across as well")
    rows: int = parameter(20, "", "rows of particles between the plates", ge=6, le=1000)
    height: float = parameter(1.0, "m", "distance H of the plates", ge=1e-5, le=100.0)
    speed: float = parameter(1.0, "m/s", "highest speed U of the fluid when it is steady", ge=1e-6, le=100.0)
    reynolds: float = parameter(10.0, "", "Reynolds number U H / nu", ge=1e-3, le=1e4)
    density: float = parameter(1000.0, "kg/m^3", "density of the fluid", ge=1e-3, le=2e4)
    sound_ratio: float = parameter(10.0, "", "speed of sound over U", ge=5.0, le=1e4)
    slip: Literal["none", "lower", "upper"] = parameter("none", "", "plate along which the fluid slips")

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.height / self.rows

    @property
    def kinematic_viscosity(self) -> float:
        """nu [m^2/s]."""
        return self.speed * self.height / self.reynolds

    @property
    def push(self) -> float:
        """Acceleration along the plates [m/s^2]."""
        return 0.0

    @property
    def plate_speeds(self) -> tuple[float, float]:
        """Of the lower and of the upper plate [m/s]."""
        return 0.0, 0.0

    @property
    def exact(self) -> Channel:
        """The series."""
        lower, upper = self.plate_speeds
        return Channel(
            self.height,
            self.kinematic_viscosity,
            self.push,
            None if self.slip == "lower" else lower,
            None if self.slip == "upper" else upper,
        )

    def build(self, executor: Executor) -> Simulation:
        H, dx = self.height, self.spacing
        along = max(self.rows // 2, SHORTEST) * dx
        across = SHORTEST * dx if self.dimension == 3 else 0.0
        viscosity = self.density * self.kinematic_viscosity
        model = Model(
            dimension=self.dimension,
            spacing=dx,
            materials=(
                fluid_material("fluid", self.density, viscosity),
                solid_material("plate", self.density, viscosity),
                solid_material("slippery plate", self.density),
            ),
            terms=(CorrectedFluid(self.density, self.sound_ratio * self.speed), Enclosed()),
            gravity=(self.push, 0.0, 0.0),
            periodic=PeriodicBox((0.0, 0.0, 0.0), (along, 0.0, across)),
        )
        lower, upper = (0.0, -LAYERS * dx, 0.0), (along, H + LAYERS * dx, across)
        points = lattice(lower[: self.dimension], upper[: self.dimension], dx)
        way = way_to_box(points, (-np.inf, 0.0, -np.inf), (np.inf, H, np.inf))
        speeds = {face: (speed, 0.0, 0.0) for face, speed in zip(("-y", "+y"), self.plate_speeds, strict=True)}
        velocity = velocity_of_faces(way, speeds)
        particles = Particles()
        particles.add(points[way[:, 1] == 0.0], Role.FREE, "fluid")
        for name, behind in (("lower", way[:, 1] > 0.0), ("upper", way[:, 1] < 0.0)):
            material = "slippery plate" if self.slip == name else "plate"
            particles.add(points[behind], Role.DUMMY, material, velocity=velocity[behind], to_surface=way[behind])
        return Simulation(executor, model, particles, observe=self._observe)

    def _observe(self, state: Snapshot, time: float) -> Values:
        fluid = state["role"] == Role.FREE
        y, u = state["position"][fluid, 1].astype(float), state["velocity"][fluid].astype(float)
        exact = self.exact.velocity(y, time)
        error = float(np.sqrt(np.mean((u[:, 0] - exact) ** 2)))
        row = np.clip(np.nan_to_num(y / self.spacing), 0, self.rows - 1).astype(int)
        count = np.maximum(np.bincount(row, minlength=self.rows), 1)
        places, means = (np.bincount(row, values, self.rows) / count for values in (y, u[:, 0]))
        return {
            "rms_error": Measured(error / self.speed, "", "RMS error of the velocity over U"),
            "cross_flow": Measured(highest(np.abs(u[:, 1:]).ravel()) / self.speed, "", "highest speed across over U"),
            "velocity": Measured(means / self.speed, "", "velocity over U", over="place"),
            "place": Measured(places / self.height, "", "height over H"),
        }

    @property
    def label(self) -> str:
        """What is said of the case in the names of checks."""
        slip = f", slip along the {self.slip} plate" if self.slip != "none" else ""
        return f"{self.dimension}D, {self.rows} rows{slip}"

    def checks(self, result: Result) -> list[Check]:
        """The profile at five times, the last of them when the flow between plates that rub is steady."""
        series, checks = result.diagnostics, []
        for fourier in FOURIERS:
            frame = int(np.argmin(np.abs(series["time"] - fourier * self.height**2 / self.kinematic_viscosity)))
            reached = self.kinematic_viscosity * series["time"][frame] / self.height**2
            if abs(reached / fourier - 1.0) < 1e-3:
                checks.append(
                    Check(
                        self.name,
                        f"RMS error of the velocity over U at nu t / H^2 = {fourier:g} ({self.label})",
                        "",
                        float(series["rms_error"][frame]),
                        None,
                        0.01 * (20.0 / self.rows) ** 2,
                        f"{SOURCE}, series",
                        reason="second order in the spacing: 0.4 % of U for a parabola of 20 rows, 0.15 % for a front",
                    )
                )
        return checks

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """In the plane and in space, plates that slip, and the order of convergence over three spacings."""
        for case in (cls(), cls(dimension=3), *cls.variations()):
            yield from case.checks(simulate(case))
        yield order_check(cls, simulate)

    @classmethod
    def variations(cls) -> tuple["ParallelFlow", ...]:
        """Further cases with checks of their own."""
        return (cls(slip="upper"),)


def order_check(kind: type[ParallelFlow], simulate: Callable[[Scenario], Result]) -> Check:
    """Order of convergence of the error over U, on average over the five times, from 10 to 40 rows."""
    counts, errors = np.array([10, 20, 40]), []
    for rows in counts:
        checks = kind(rows=int(rows)).checks(simulate(kind(rows=int(rows))))
        errors.append(np.mean([check.measured for check in checks]))
    return Check(
        kind.name,
        "order of convergence, " + ", ".join(f"{error:.2%}" for error in errors) + " of U with 10, 20, 40 rows",
        "",
        float(-np.polyfit(np.log(counts), np.log(errors), 1)[0]),
        2.0,
        0.3,
        f"{SOURCE}, series",
        relative=False,
        reason="linear velocities are exact at walls, bent ones of second order",
    )
