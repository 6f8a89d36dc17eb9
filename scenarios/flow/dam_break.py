"""A column of hot liquid collapses, runs along the floor and heats a cold wall."""

import csv
from collections.abc import Callable, Iterable
from importlib.resources import files
from typing import Literal

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import GRAVITY, Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.core.state import Snapshot
from warpsph.machine import SymmetryPlane
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.run.statistics import highest
from warpsph.terms import Conduction, Fluid, SummedDensity

LIQUID, COLD_WALL, TANK, GLASS = "liquid", "cold wall", "tank", "glass"  # the materials


class DamBreak(Scenario):
    """A tank four columns long whose right wall is cold and conducts; front and back, in 3D, let it slip."""

    name = "dam_break"
    summary = "a column of hot liquid collapses and heats a cold wall, in 2D or 3D"
    source = "Vijaykumar (2012), section 3.1.3; Koshizuka & Oka (1996)"
    presets = ("space", "fine")

    duration: float = parameter(0.8, "s", "physical time to simulate", gt=0, le=100.0)
    output_interval: float = parameter(0.01, "s", "physical time between two frames and diagnostics", gt=0, le=100.0)
    dimension: Literal[2, 3] = parameter(2, "", "2 for the plane, 3 for a tank half a column deep")
    width: float = parameter(
        0.146, "m", "width L of the column; it is 2 L high and the tank 4 L long", ge=0.01, le=10.0
    )
    columns: int = parameter(36, "", "columns of particles over the width L", ge=6, le=400)
    density: float = parameter(1000.0, "kg/m^3", "density of the liquid", ge=1.0, le=2e4)
    viscosity: float = parameter(2.0, "Pa s", "dynamic viscosity of the liquid", ge=0.0, le=100.0)
    sound_ratio: float = parameter(10.0, "", "speed of sound over the fall speed sqrt(4 g L)", ge=5.0, le=100.0)
    liquid_temperature: float = parameter(2000.0, "K", "temperature of the liquid at the start", gt=0, le=1e4)
    wall_temperature: float = parameter(1500.0, "K", "temperature of the cold wall at the start", gt=0, le=1e4)
    conductivity: float = parameter(200.0, "W/(m K)", "thermal conductivity of liquid and cold wall", gt=0, le=1e4)
    heat_capacity: float = parameter(1000.0, "J/(kg K)", "heat capacity of liquid and cold wall", ge=10.0, le=1e5)

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.width / self.columns

    @property
    def sound_speed(self) -> float:
        """Speed of sound [m/s]."""
        return self.sound_ratio * np.sqrt(4.0 * GRAVITY * self.width)

    def build(self, executor: Executor) -> Simulation:
        L, dx = self.width, self.spacing
        depth = ((0.0, 0.5 * L),) if self.dimension == 3 else ()
        lower = (0.0, 0.0, *(low for low, _ in depth))
        column = lattice(lower, (L, 2.0 * L, *(high for _, high in depth)), dx)
        box = tank(lower, (4.0 * L, 3.0 * L, *(high for _, high in depth)), dx)
        glass = (box[:, 2] < 0.0) | (box[:, 2] > 0.5 * L) if self.dimension == 3 else np.zeros(len(box), bool)
        cold = (box[:, 0] > 4.0 * L) & (box[:, 1] > 0.0) & ~glass
        density, viscosity = self.density, self.viscosity
        k, c_p = self.conductivity, self.heat_capacity
        model = Model(
            dimension=self.dimension,
            spacing=dx,
            materials=(
                fluid_material(LIQUID, density, viscosity, conductivity=k, heat_capacity=c_p),
                solid_material(COLD_WALL, density, viscosity, conductivity=k, heat_capacity=c_p),
                solid_material(TANK, density, viscosity),
                solid_material(GLASS, density),
            ),
            terms=(Fluid(self.density, self.sound_speed), SummedDensity(), Conduction()),
        )
        particles = Particles()
        particles.add(column, Role.FREE, LIQUID, temperature=self.liquid_temperature)
        particles.add(box[cold], Role.WALL, COLD_WALL, temperature=self.wall_temperature)
        particles.add(box[~cold & ~glass], Role.DUMMY, TANK)
        particles.add(box[glass], Role.DUMMY, GLASS)
        return Simulation(executor, model, particles, parts=self._guards(), observe=self._observe)

    def _guards(self) -> list[SymmetryPlane]:
        """Mirrors at the faces of the tank, for single drops, which hit the wall particles too fast to be held."""
        length, depth = 4.0 * self.width, 0.5 * self.width
        faces = [((1, 0, 0), 0.0), ((-1, 0, 0), -length), ((0, 1, 0), 0.0)]
        if self.dimension == 3:
            faces += [((0, 0, 1), 0.0), ((0, 0, -1), -depth)]
        return [SymmetryPlane(normal, offset) for normal, offset in faces]

    def _observe(self, state: Snapshot, time: float) -> Values:
        liquid, wall = state["role"] == Role.FREE, state["role"] == Role.WALL
        position = state["position"][liquid].astype(float)
        heat = state["mass"].astype(float) * state["enthalpy"]
        floor = position[:, 1] < 0.5 * self.width
        front = (highest(position[floor, 0]) + 0.5 * self.spacing) / self.width
        height = (highest(position[:, 1]) + 0.5 * self.spacing) / (2.0 * self.width)
        of_liquid, of_wall = float(heat[liquid].sum()), float(heat[wall].sum())
        return {
            "front": Measured(front, "", "front over L"),
            "height": Measured(height, "", "height over 2 L"),
            "heat_of_liquid": Measured(of_liquid, "J", "in the liquid", per_depth=True, panel="heat"),
            "heat_of_wall": Measured(of_wall, "J", "in the cold wall", per_depth=True, panel="heat"),
        }

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """In the plane, and coarser in space."""
        for scenario in (cls(), cls(dimension=3, columns=12)):
            yield from scenario.checks(simulate(scenario))

    def checks(self, result: Result) -> list[Check]:
        series = result.diagnostics
        time = series["time"] * np.sqrt(2.0 * GRAVITY / self.width)
        rows = []
        for reference_time, reference in published_front():
            if 0.0 < reference_time <= time[-1]:
                rows.append(
                    Check(
                        self.name,
                        f"front over L at t sqrt(2 g / L) = {reference_time:g} ({self.dimension}D)",
                        "",
                        float(np.interp(reference_time, time, series["front"])),
                        reference,
                        0.1,
                        "Koshizuka & Oka (1996)",
                        reason="10 %; the experiments differ among each other by as much",
                    )
                )
        lost = series["heat_of_liquid"][0] - series["heat_of_liquid"][-1]
        gained = series["heat_of_wall"][-1] - series["heat_of_wall"][0]
        if lost == 0.0:  # the wall has not been reached
            return rows
        rows.append(
            Check(
                self.name,
                "heat gained by the wall and lost by the liquid",
                "J/m" if self.dimension == 2 else "J",
                float(gained),
                float(lost),
                1e-5,
                "conservation of energy",
                reason="pairs exchange heat exactly; rounding of the enthalpies remains",
            )
        )
        return rows


def published_front(dataset: str = "KoshizukaOka1996") -> list[tuple[float, float]]:
    """Place of the front over L at t sqrt(2 g / L), as published, from ``data/dambreak_front.csv``."""
    text = (files("warpsph.scenarios.flow") / "data" / "dambreak_front.csv").read_text()
    rows = csv.DictReader(text.splitlines())
    return [(float(row["t"]), float(row["value"])) for row in rows if row["dataset"] == dataset]
