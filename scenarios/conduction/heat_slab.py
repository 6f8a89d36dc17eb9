"""A slab between two walls of heat: fixed temperature, film, flux or insulation, against the exact series."""

from collections.abc import Callable, Iterable
from enum import StrEnum
from functools import partial

import numpy as np

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.conduction.slab_series import Face, Slab
from warpsph.scenarios.conduction.time_stepping import ConductingScenario
from warpsph.terms import Conduction, HeatWall, cut_cells

DENSITY = 1000.0  # [kg/m^3]
HEAT_CAPACITY = 1000.0  # [J/(kg K)]
SOURCE = "series of the modes of a slab, Carslaw & Jaeger (1959), chapter III"


class Wall(StrEnum):
    """What a wall prescribes."""

    TEMPERATURE = "temperature"
    FILM = "film"
    FLUX = "flux"
    INSULATED = "insulated"


class HeatSlab(ConductingScenario):
    """A slab of one temperature, between a wall at x = 0 and one at x = thickness; insulated all around."""

    name = "heat_slab"
    summary = "a slab between two walls: fixed temperature, film, flux or insulation"
    source = SOURCE
    presets = ("temperatures", "film", "flux", "insulated", "space")

    duration: float = parameter(200.0, "s", "physical time to simulate", gt=0, le=1e6)
    output_interval: float = parameter(20.0, "s", "physical time between two frames and diagnostics", gt=0, le=1e6)
    dimension: int = parameter(2, "", "2 in the plane, 3 in space", ge=2, le=3)
    rows: int = parameter(20, "", "rows of particles through the slab", ge=6, le=400)
    row_on_wall: bool = parameter(
        False, "", "whether rows stand on the walls, beside those counted, with their cells cut"
    )
    breadth: int = parameter(6, "", "rows along the walls", ge=4, le=400)
    thickness: float = parameter(0.1, "m", "thickness of the slab", gt=1e-3, le=10.0)
    conductivity: float = parameter(10.0, "W/(m K)", "thermal conductivity", gt=0, le=1e4)
    start: float = parameter(300.0, "K", "temperature at the start", gt=0, le=5e3)
    left: Wall = parameter(Wall.TEMPERATURE, "", "what the wall at x = 0 prescribes")
    left_temperature: float = parameter(400.0, "K", "of the left wall, or behind its film", gt=0, le=5e3)
    left_conductance: float = parameter(200.0, "W/(m^2 K)", "of the film on the left", ge=0, le=1e6)
    left_flux: float = parameter(-1.0e4, "W/m^2", "that leaves by the left wall", ge=-1e8, le=1e8)
    right: Wall = parameter(Wall.TEMPERATURE, "", "what the wall at x = thickness prescribes")
    right_temperature: float = parameter(300.0, "K", "of the right wall, or behind its film", gt=0, le=5e3)
    right_conductance: float = parameter(200.0, "W/(m^2 K)", "of the film on the right", ge=0, le=1e6)
    right_flux: float = parameter(0.0, "W/m^2", "that leaves by the right wall", ge=-1e8, le=1e8)

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.thickness / self.rows

    @property
    def exact(self) -> Slab:
        """The exact solution."""
        diffusivity = self.conductivity / (DENSITY * HEAT_CAPACITY)
        faces = [Face(wall.conductance, wall.outside, wall.flux) for wall in self._faces]
        return Slab(self.thickness, self.conductivity, diffusivity, self.start, *faces)

    @property
    def _faces(self) -> list[HeatWall]:
        """The walls at x = 0 and at x = thickness."""
        return [
            self._face((1.0, 0.0, 0.0), 0.0, self.left, self.left_temperature, self.left_conductance, self.left_flux),
            self._face(
                (-1.0, 0.0, 0.0),
                -self.thickness,
                self.right,
                self.right_temperature,
                self.right_conductance,
                self.right_flux,
            ),
        ]

    def _face(
        self, normal: tuple, offset: float, kind: Wall, temperature: float, conductance: float, flux: float
    ) -> HeatWall:
        if kind is Wall.TEMPERATURE:
            return HeatWall.at_temperature(normal, offset, temperature)
        if kind is Wall.FILM:
            return HeatWall.film(normal, offset, conductance, temperature)
        return HeatWall.given_flux(normal, offset, flux) if kind is Wall.FLUX else HeatWall.insulated(normal, offset)

    def build(self, executor: Executor) -> Simulation:
        dx, across = self.spacing, self.breadth * self.spacing
        faces, edges = self._faces, []
        for normal in np.eye(3)[1 : self.dimension]:
            edges += [HeatWall.insulated(normal, 0.0), HeatWall.insulated(-normal, -across)]
        beyond = 0.5 * dx if self.row_on_wall else 0.0
        lower, upper = (-beyond, 0.0, 0.0), (self.thickness + beyond, across, across)
        points = lattice(lower[: self.dimension], upper[: self.dimension], dx)
        temperature, held = np.full(len(points), self.start), np.zeros(len(points), bool)
        for face in faces:
            on_it = (np.abs(face.height(points)) < 1e-3 * dx) & np.isinf(face.conductance)
            temperature[on_it], held[on_it] = face.outside, True
        particles = Particles()
        volume = cut_cells(points, faces, dx, self.dimension)
        particles.add(points, Role.FREE, temperature=temperature, held=held, volume=volume)
        conduction = Conduction(longest_interval=self.step, walls=(*faces, *edges), integrator=self.stepping)
        slab = solid_material("slab", density=DENSITY, heat_capacity=HEAT_CAPACITY, conductivity=self.conductivity)
        model = Model(self.dimension, dx, (slab,), (conduction,), gravity=(0.0, 0.0, 0.0))
        return Simulation(executor, model, particles, observe=partial(self._observe, conduction))

    def _observe(self, conduction: Conduction, state: Snapshot, time: float) -> Values:
        left, right, *edges = conduction.heat_to_walls()
        near_left = state["position"][:, 0] < 0.5 * self.thickness
        left += np.sum(state["heat_held"][near_left])  # held rows on a wall
        right += np.sum(state["heat_held"][~near_left])
        mass = state["mass"].astype(float)
        return {
            "heat": Measured(float(np.sum(mass * state["enthalpy"])), "J", "heat of the slab", per_depth=True),
            "heat_left": Measured(left, "J", "left", per_depth=True, panel="taken by walls"),
            "heat_right": Measured(right, "J", "right", per_depth=True, panel="taken by walls"),
            "heat_edges": Measured(float(np.sum(edges)), "J", "edges", per_depth=True, panel="taken by walls"),
            "largest_error": Measured(self._largest_error(state["position"], state["temperature"], time), "K", "error"),
        }

    @property
    def _scale(self) -> float:
        """Difference of temperature [K] that errors are compared with."""
        ends = [self.start, *self.exact.temperature(np.array([0.0, self.thickness]), self.duration)]
        return float(np.ptp(ends)) or 1.0

    def _largest_error(self, position: np.ndarray, temperature: np.ndarray, time: float) -> float:
        """Largest difference to the exact temperature [K]; 0 at the start."""
        if time == 0.0:
            return 0.0
        exact = self.exact.temperature(position[:, 0].astype(float), time)
        return float(np.abs(temperature - exact).max())

    def checks(self, result: Result) -> list[Check]:
        series = result.diagnostics
        area = (self.breadth * self.spacing) ** (self.dimension - 1)
        span = series["time"][-1] - series["time"][-2]
        times = series["time"][-1] - span * np.array([0.0, 0.5, 1.0])
        mean_flux = np.array([1.0, 4.0, 1.0]) @ [self.exact.flux(time) for time in times] / 6.0  # Simpson
        scale = max(np.abs(mean_flux).max(), 1e-3 * self.conductivity * self._scale / self.thickness)
        checks = [
            Check(
                self.name,
                f"largest temperature error at {result.time:g} s, over the greatest difference",
                "",
                self._largest_error(result.positions, result.fields["temperature"], result.time) / self._scale,
                None,
                0.0015 * (20.0 / self.rows) ** 2,
                SOURCE,
                reason="second order in the spacing: smoothing error and a time step that goes with its square",
            )
        ]
        for side, exact in zip(("left", "right"), mean_flux, strict=True):
            flux = (series[f"heat_{side}"][-1] - series[f"heat_{side}"][-2]) / (span * area)
            checks.append(
                Check(
                    self.name,
                    f"error of the flux that leaves on the {side} in the last {span:g} s, over the greater flux",
                    "",
                    float(flux - exact) / scale,
                    None,
                    0.004 * (20.0 / self.rows) ** 2,
                    SOURCE,
                    reason="second order in the spacing; of rows on walls, half cells do not warm",
                )
            )
        taken = sum(series[name][-1] for name in ("heat_left", "heat_right", "heat_edges"))
        checks.append(
            Check(
                self.name,
                "heat that is in no ledger, over the heat of the slab",
                "",
                float((series["heat"][-1] - series["heat"][0] + taken) / series["heat"][0]),
                None,
                1e-6,
                "what a wall takes, the slab loses",
                reason="pairs exchange heat exactly; rounding of the enthalpies remains",
            )
        )
        return checks

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """All presets, rows on the walls, and the order of convergence over three spacings."""
        for preset in cls.presets:
            case = resolve(cls, [preset_layer(cls, preset)])
            yield from case.checks(simulate(case))
        case = cls(row_on_wall=True)
        yield from case.checks(simulate(case))
        rows = np.array([10, 20, 40])
        errors = [float(simulate(cls(rows=n)).diagnostics["largest_error"][-1]) for n in rows]
        yield Check(
            cls.name,
            "order of convergence, " + ", ".join(f"{error:.3g}" for error in errors) + " K with 10, 20, 40 rows",
            "",
            float(-np.polyfit(np.log(rows), np.log(errors), 1)[0]),
            2.0,
            0.3,
            "smoothing error of second order",
            relative=False,
            reason="at least 1.7; images continue a linear profile exactly, a bent one to second order",
        )
