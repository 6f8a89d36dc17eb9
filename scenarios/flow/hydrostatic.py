"""A column of melt at rest: its pressure, density and stillness against the exact weakly compressible column."""

from collections.abc import Callable, Iterable
from typing import Any, Literal

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.hydrostatics import column_density, column_pressure, depth_of_pressure
from warpsph.core.labels import Role
from warpsph.core.lattice import Lattice
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import GRAVITY, Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.core.state import Snapshot
from warpsph.machine import Settling
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.run.statistics import highest, means_of_slices, value_at_zero
from warpsph.terms import Fluid, SummedDensity

THESIS_PRESSURE = 43.8e3  # Vijaykumar (7.1) [Pa]
COARSE: dict[str, Any] = {"rows": 80, "columns": 40}
VARIATIONS: tuple[dict[str, Any], ...] = (
    {"support_ratio": 2.6},
    {"support_ratio": 3.5},
    {"viscosity": 200.0},
    {"viscosity": 1800.0},
    {"step_factor": 4.0},
)


class Hydrostatic(Scenario):
    """A tall narrow column between walls without friction, filled so that it stands ``height`` high at rest."""

    name = "hydrostatic"
    summary = "a column of melt at rest: pressure and density over its height"
    source = "Vijaykumar (2012), section 7.1; exact column of (1.3) and (1.5)"
    presets = ("coarse", "regular")

    duration: float = parameter(1.0, "s", "physical time to simulate", gt=0, le=1e3)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e3)
    height: float = parameter(2.05, "m", "height of the column at rest", ge=0.05, le=10.0)
    rows: int = parameter(160, "", "rows of particles over the height", ge=10, le=1000)
    columns: int = parameter(60, "", "columns of particles over the width", ge=6, le=1000)
    density: float = parameter(2100.0, "kg/m^3", "reference density", ge=1.0, le=2e4)
    sound_speed: float = parameter(22.4, "m/s", "speed of sound", ge=1.0, le=1e4)
    viscosity: float = parameter(600.0, "Pa s", "dynamic viscosity", ge=0.0, le=1e5)
    start: Literal["hydrostatic", "regular"] = parameter(
        "hydrostatic", "", "arrangement at the start: by the exact pressure, or a regular grid that sinks"
    )

    support_ratio: float = parameter(3.0, "", "support of the smoothing kernels over the spacing", ge=2.0, le=6.0)
    step_factor: float = parameter(1.0, "", "time step over the stable one (7.6)", gt=0, le=10)
    settling: float = parameter(0.5, "s", "time for which a drag calms the start", ge=0.0, le=1e3)

    @property
    def column_mass(self) -> float:
        """Mass over a unit of area [kg/m^2]."""
        return float(self.exact_pressure(0.0)) / GRAVITY

    @property
    def spacing(self) -> float:
        """Spacing of the lattice [m] whose rows, with the mass that particles have, weigh as much as the column."""
        density = Lattice(dimension=2, spacing=1.0, support_ratio=self.support_ratio).density()
        return self.column_mass * density / (self.density * self.rows)

    def exact_density(self, y: float | np.ndarray) -> float | np.ndarray:
        """Density [kg/m^3] at the height y [m]."""
        return column_density(self.height - np.asarray(y), self.density, GRAVITY, self.sound_speed)

    def exact_pressure(self, y: float | np.ndarray) -> float | np.ndarray:
        """Pressure [Pa] at the height y [m]."""
        return column_pressure(self.height - np.asarray(y), self.density, GRAVITY, self.sound_speed)

    def settled(self, y: np.ndarray) -> np.ndarray:
        """Height [m] at rest of what stands at the height y [m] of the lattice."""
        top = self.rows * self.spacing
        load = GRAVITY * self.column_mass * np.maximum(1.0 - y / top, 0.0)
        depth = depth_of_pressure(load, self.density, GRAVITY, self.sound_speed)
        return self.height - depth + np.maximum(y - top, 0.0)

    def build(self, executor: Executor) -> Simulation:
        dx = self.spacing
        width, top = self.columns * dx, self.rows * dx
        model = Model(
            dimension=2,
            spacing=dx,
            support_ratio=self.support_ratio,
            materials=(fluid_material("melt", self.density, self.viscosity), solid_material("wall", self.density)),
            terms=(Fluid(self.density, self.sound_speed), SummedDensity()),
        )
        melt = lattice((0.0, 0.0), (width, top), dx)
        walls = tank((0.0, 0.0), (width, top + 4.0 * dx), dx)
        if self.start == "hydrostatic":
            for points in (melt, walls):
                points[:, 1] = self.settled(points[:, 1])
        particles = Particles()
        particles.add(melt, Role.FREE, "melt")
        particles.add(walls, Role.DUMMY, "wall")
        drag = Settling(rate=2.0 * self.sound_speed / self.height, until=self.settling)
        return Simulation(executor, model, particles, parts=[drag], step_factor=self.step_factor, observe=self._observe)

    def _observe(self, state: Snapshot, time: float) -> Values:
        melt = state["role"] == Role.FREE
        y, p = state["position"][melt, 1].astype(float), state["pressure"][melt].astype(float)
        error = (p - self.exact_pressure(y)) / self.exact_pressure(0.0)
        low = y < max(self.height / 8.0, 2.0 * self.spacing)  # a line needs two rows
        bottom_pressure = value_at_zero(y[low], p[low])
        profile_error = highest(np.abs(self._slice_means(y, error)))
        mean_speed = float(np.linalg.norm(state["velocity"][melt], axis=1).mean())
        over = "over that at the bottom"
        return {
            "bottom_pressure": Measured(bottom_pressure, "Pa", "pressure at the bottom"),
            "profile_error": Measured(profile_error, "", f"largest error of the pressure, {over}"),
            "pressure_scatter": Measured(float(error.std()), "", f"scatter of the pressure, {over}"),
            "mean_speed": Measured(mean_speed, "m/s", "mean speed"),
            "level": Measured(highest(y) + 0.5 * self.spacing, "m", "melt level"),
        }

    def _slice_means(self, y: np.ndarray, values: np.ndarray) -> np.ndarray:
        """Means of ``values`` over slices of the column one smoothing length high, the incomplete top one left out."""
        means, count = means_of_slices(y / (self.support_ratio * self.spacing), values)
        return means[count > self.columns]

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The column; and, where there is time, a coarser one with one numerical parameter after the other changed."""
        yield from cls().checks(simulate(cls()))
        for change in VARIATIONS if slow else ():
            case = cls(**COARSE | change)
            name, value = next(iter(change.items()))
            yield Check(
                cls.name, f"pressure at the bottom, {case.rows} rows, {name} {value:g}", "Pa",
                float(simulate(case).diagnostics["bottom_pressure"][-1]), float(case.exact_pressure(0.0)), 0.03,
                "exact weakly compressible column; parameters of Vijaykumar (2012), section 7.5",
                reason="2.5 cm rows: 1 % by the topmost row and the walls, the rest by the smoothing kernels' sums",
            )  # fmt: skip

    def checks(self, result: Result) -> list[Check]:
        last = {name: float(values[-1]) for name, values in result.diagnostics.items()}
        exact = float(self.exact_pressure(0.0))
        rows = [
            Check(
                self.name,
                "pressure at the bottom (line through the lowest eighth)",
                "Pa",
                last["bottom_pressure"],
                exact,
                0.02,
                "exact weakly compressible column",
                reason="the topmost row lacks the pressure of half a row, 0.3 %; walls carry some 0.5 %",
            ),
            Check(
                self.name,
                "largest error of the pressure, in slices one support high, over the bottom pressure",
                "",
                last["profile_error"],
                None,
                0.03,
                "exact weakly compressible column",
                reason="rows of particles order themselves along the floor within one support",
            ),
            Check(
                self.name,
                "largest excess of density",
                "",
                last["density_max"] / self.density - 1.0,
                float(self.exact_density(0.0)) / self.density - 1.0,
                0.0034,
                "exact weakly compressible column",
                relative=False,
                reason="the range stays under 4 %, as in the thesis",
            ),
            Check(
                self.name,
                "mean speed over sqrt(g H0)",
                "",
                last["mean_speed"] / np.sqrt(GRAVITY * self.height),
                None,
                1e-3,
                "a column at rest",
                reason="waves of the start are damped by then",
            ),
        ]
        if self.height == type(self).model_fields["height"].default:
            rows.insert(
                1,
                Check(
                    self.name,
                    "pressure at the bottom",
                    "Pa",
                    last["bottom_pressure"],
                    THESIS_PRESSURE,
                    0.02,
                    "Vijaykumar (7.1)",
                    reason="depth times the density at the bottom: 1.8 % more than the column has",
                ),
            )
        return rows
