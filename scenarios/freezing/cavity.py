"""Water that freezes around two sinks in a cavity of irregular shape."""

from collections.abc import Callable, Iterable
from functools import partial

import numpy as np
from pydantic import model_validator
from scipy.interpolate import CubicSpline

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.freezing.numerics import SOURCE, Freezing, pure_substance
from warpsph.scenarios.freezing.point_sink import WATER
from warpsph.terms import HeatSources, PointSource

# The paper shows its cavity in a small picture only; this one is roughly alike. Corners (n, 2) [m] of a smooth curve.
OUTLINE = np.array([
    (-0.48, -0.10), (-0.41, -0.26), (-0.25, -0.31), (-0.09, -0.25), (0.06, -0.24), (0.22, -0.30), (0.39, -0.27),
    (0.49, -0.11), (0.45, 0.07), (0.32, 0.17), (0.20, 0.32), (0.03, 0.38), (-0.12, 0.33), (-0.23, 0.21), (-0.37, 0.18),
    (-0.47, 0.06),
])  # fmt: skip


def outline(points: int = 400) -> np.ndarray:
    """Corners (points, 2) [m] of the cavity as a polygon."""
    closed = np.vstack([OUTLINE, OUTLINE[:1]])
    return CubicSpline(np.arange(len(closed)), closed, bc_type="periodic")(np.linspace(0.0, len(OUTLINE), points + 1))[
        :-1
    ]


def inside(points: np.ndarray, polygon: np.ndarray) -> np.ndarray:
    """Which points (n, 2) lie in a polygon (m, 2): whose ray along x meets its sides an odd number of times."""
    x, y = points[:, 0, None], points[:, 1, None]
    x_a, y_a = polygon.T
    x_b, y_b = np.roll(polygon, -1, axis=0).T
    across = (y_a > y) != (y_b > y)
    meets = across & (x < x_a + (y - y_a) * (x_b - x_a) / np.where(y_a == y_b, 1.0, y_b - y_a))
    return np.sum(meets, axis=1) % 2 == 1


def area(polygon: np.ndarray) -> float:
    """Area [m^2] of a polygon (n, 2)."""
    x, y = polygon.T
    return float(0.5 * abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))))


class Cavity(Freezing):
    """A cavity full of water, about 1 m wide, without heat from outside, with two sinks in its lower half."""

    name = "cavity"
    summary = "water freezes around two sinks in an irregular cavity"
    source = f"{SOURCE}, section 3.2, figure 11"
    presets = ("paper",)

    duration: float = parameter(600000.0, "s", "physical time to simulate", gt=0, le=1e8)
    output_interval: float = parameter(10000.0, "s", "physical time between two frames and diagnostics", gt=0, le=1e8)
    across: int = parameter(40, "", "particles over a width of 1 m", ge=16, le=640)
    strength: float = parameter(148.451, "W/m", "heat that each sink takes; the published q' 0.033651", gt=0, le=1e6)
    sink_x: float = parameter(0.25, "m", "distance of the sinks from the middle", ge=0, le=0.4)
    sink_y: float = parameter(-0.1, "m", "height of the sinks", ge=-0.2, le=0.3)
    melting: float = parameter(273.15, "K", "melting point", gt=0, le=5e3)
    start: float = parameter(283.15, "K", "temperature of the water at the start", gt=0, le=5e3)

    @model_validator(mode="after")
    def _check_case(self) -> "Cavity":
        if not self.start > self.melting:
            raise ValueError(f"start = {self.start} K: must lie above melting, {self.melting} K")
        if not np.all(inside(np.array([[self.sink_x, self.sink_y], [-self.sink_x, self.sink_y]]), outline())):
            raise ValueError(f"sink_x, sink_y = {self.sink_x}, {self.sink_y} m: a sink must lie in the cavity")
        to_zero = WATER["latent_heat"] + WATER["heat_capacity_solid"] * self.melting
        to_zero += WATER["heat_capacity_liquid"] * (self.start - self.melting)
        most = 0.5 * area(outline()) * WATER["density"] * to_zero / self.duration
        if self.strength > most:
            raise ValueError(
                f"strength = {self.strength:g} W/m: by the end both sinks have taken more heat than the water holds "
                f"above 0 K; {most:.4g} W/m at most, or a shorter duration"
            )
        return self

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return 1.0 / self.across

    def build(self, executor: Executor) -> Simulation:
        dx = self.spacing
        points = lattice((-0.6, -0.6), (0.6, 0.6), dx)
        particles = Particles()
        particles.add(points[inside(points[:, :2], outline())], Role.FREE, temperature=self.start)
        sinks = [PointSource((x, self.sink_y, 0.0), -self.strength) for x in (-self.sink_x, self.sink_x)]
        sources = HeatSources(sinks)
        diffusivity = WATER["conductivity_solid"] / (WATER["density"] * WATER["heat_capacity_solid"])
        physics = self.physics(self.longest_step(dx, diffusivity))
        water = pure_substance("water", self.melting, SOURCE, **WATER)
        model = Model(2, dx, (water,), (*physics, sources), gravity=(0.0, 0.0, 0.0))
        return Simulation(executor, model, particles, observe=partial(self._observe, sources))

    def _observe(self, sources: HeatSources, state: Snapshot, time: float) -> Values:
        f, y = state["solid_fraction"].astype(float), state["position"][:, 1].astype(float)
        liquid = np.sum(1.0 - f)
        height = float(np.sum((1.0 - f) * y) / liquid) if liquid > 0.0 else np.nan
        heat = np.sum(state["mass"].astype(float) * state["enthalpy"])
        return {
            "frozen": Measured(float(np.mean(f)), "", "share that has frozen"),
            "height_of_water": Measured(height, "m", "mean height of the water"),
            "heat": Measured(float(heat), "J", "heat", per_depth=True),
            "heat_given": Measured(float(sources.heat_given.numpy().sum()), "J", "heat given by sinks", per_depth=True),
        }

    def checks(self, result: Result) -> list[Check]:
        series = result.diagnostics
        loss = series["heat"][0] - series["heat"][-1]
        return [
            Check(
                self.name,
                f"heat that is in no ledger, over the heat lost ({self.method})",
                "",
                float((loss + series["heat_given"][-1]) / loss),
                None,
                1e-5,
                f"{SOURCE}, equation (2.12)",
                reason="pairs exchange heat exactly; rounding of the enthalpies remains",
            ),
            Check(
                self.name,
                f"heat that the sinks have taken ({self.method})",
                "J/m",
                -float(series["heat_given"][-1]),
                2.0 * self.strength * result.time,
                1e-5,
                "two sinks",
                reason="all of it, rounding left aside",
            ),
        ]

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The default, twice as fine, and with the published conduction; where the last water is."""
        case = cls()
        coarse, fine = simulate(case), simulate(cls(across=2 * case.across))
        yield from case.checks(coarse)
        yield cls._same_share("80 particles a metre", coarse, fine)
        paper = resolve(cls, [preset_layer(cls, "paper")])
        published = simulate(paper)
        yield from paper.checks(published)
        yield cls._same_share("the published conduction", published, fine)
        yield Check(
            cls.name,
            "mean height of the last water",
            "m",
            float(fine.diagnostics["height_of_water"][-1]),
            0.25,
            0.1,
            f"{SOURCE}, section 3.2: a small region near the upper boundary",
            relative=False,
            reason="the cavity reaches from -0.31 to 0.38 m",
        )

    @classmethod
    def _same_share(cls, what: str, result: Result, fine: Result) -> Check:
        difference = result.diagnostics["frozen"] - fine.diagnostics["frozen"]
        return Check(
            cls.name,
            f"largest difference of the share that has frozen to {what}, over the share at the end",
            "",
            float(np.abs(difference).max() / fine.diagnostics["frozen"][-1]),
            None,
            0.02,
            "the same case, twice as fine",
            reason="first order; an irregular edge of particles holds up to 1 % more or less water",
        )
