"""Melt that freezes from a cold face: the problem of Stefan, against the solution of Neumann."""

from collections.abc import Callable, Iterable
from functools import partial

import numpy as np
from pydantic import model_validator

from warpsph.cases.case import preset_layer, resolve, settings_layer
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.freezing.neumann import Neumann
from warpsph.scenarios.freezing.numerics import SOURCE, Freezing, Phases, pure_substance
from warpsph.terms import Conduction, HeatWall, cut_cells

NEUMANN = "solution of Neumann, Carslaw & Jaeger (1959), chapter XI"
PUBLISHED_PLANE = 0.1906024  # of Monaghan (3.6) with the paper's numbers, printed there as 0.1906 [K]
PUBLISHED_LOST = 0.6  # heat that the mushy row has lost over the latent heat, read off figure 2


class StefanSlab(Freezing):
    """Melt between a cold face at y = 0 and a warm one at y = height, without ends along x."""

    name = "stefan_slab"
    summary = "melt freezes from a cold face (the problem of Stefan)"
    source = f"{SOURCE}, section 3.1; {NEUMANN}"
    presets = ("paper", "unequal", "water")

    duration: float = parameter(0.0568047337278, "s", "physical time to simulate", gt=0, le=1e9)
    output_interval: float = parameter(0.00284023668639, "s", "physical time between two frames", gt=0, le=1e9)
    height: float = parameter(1.0, "m", "from face to face", gt=1e-6, le=1e4)
    particles: int = parameter(40, "", "particles from face to face, one on each", ge=10, le=640)
    columns: int = parameter(40, "", "columns of particles along the faces", ge=4, le=640)
    planes: bool = parameter(True, "", "whether faces have images behind them, not only a held row")
    similarity: float = parameter(0.5, "", "lambda, from which the temperature of the cold face follows", gt=0, le=3)
    melting: float = parameter(1.0, "K", "melting point", gt=0, le=5e3)
    start: float = parameter(1.2, "K", "temperature of the melt at the start, and of the warm face", gt=0, le=5e3)
    density: float = parameter(1.0, "kg/m^3", "density of both phases", gt=0, le=1e5)
    latent_heat: float = parameter(1.0, "J/kg", "latent heat", gt=0, le=1e7)
    heat_capacity_solid: float = parameter(1.0, "J/(kg K)", "heat capacity of the solid", gt=0, le=1e5)
    heat_capacity_liquid: float = parameter(1.0, "J/(kg K)", "heat capacity of the liquid", gt=0, le=1e5)
    conductivity_solid: float = parameter(1.0, "W/(m K)", "thermal conductivity of the solid", gt=0, le=1e4)
    conductivity_liquid: float = parameter(1.0, "W/(m K)", "thermal conductivity of the liquid", gt=0, le=1e4)

    @model_validator(mode="after")
    def _check_temperatures(self) -> "StefanSlab":
        if not self.start > self.melting:
            raise ValueError(f"start = {self.start} K: must lie above melting, {self.melting} K")
        if not self.exact.plane > 0.0:
            cold = f"similarity = {self.similarity}: asks for a cold face of {self.exact.plane:.4g} K"
            raise ValueError(f"{cold}; a smaller one, or a smaller latent_heat, keeps it above 0 K")
        return self

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.height / (self.particles - 1)

    @property
    def exact(self) -> Neumann:
        """The exact solution for a slab without end."""
        return Neumann(self.similarity, self.melting, self.start, **self._properties)

    @property
    def _properties(self) -> dict[str, float]:
        names = ("density", "latent_heat", "heat_capacity_solid", "heat_capacity_liquid")
        return {name: getattr(self, name) for name in (*names, "conductivity_solid", "conductivity_liquid")}

    def build(self, executor: Executor) -> Simulation:
        dx, breadth, cold = self.spacing, self.columns * self.spacing, self.exact.plane
        points = lattice((0.0, -0.5 * dx), (breadth, self.height + 0.5 * dx), dx)
        along_x, along_y = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
        ends = (HeatWall.insulated(along_x, 0.0), HeatWall.insulated((-1.0, 0.0, 0.0), -breadth))
        faces = (
            HeatWall.at_temperature(along_y, 0.0, cold),
            HeatWall.at_temperature((0.0, -1.0, 0.0), -self.height, self.start),
        )
        on_cold, on_warm = (np.abs(face.height(points)) < 0.25 * dx for face in faces)
        walls = (*faces, *ends) if self.planes else ends
        diffusivity = max(self.conductivity_solid, self.conductivity_liquid) / (
            self.density * min(self.heat_capacity_solid, self.heat_capacity_liquid)
        )
        conduction, change = self.physics(self.longest_step(dx, diffusivity), walls=walls)
        particles = Particles()
        particles.add(
            points,
            Role.FREE,
            temperature=np.where(on_cold, cold, self.start),
            held=on_cold | on_warm,
            volume=cut_cells(points, walls, dx, 2),
            phase=np.where(on_cold, Phase.SOLID, Phase.LIQUID),
        )
        substance = pure_substance("substance", self.melting, SOURCE, **self._properties)
        model = Model(2, dx, (substance,), (conduction, change), gravity=(0.0, 0.0, 0.0))
        return Simulation(executor, model, particles, observe=partial(self._observe, conduction))

    def _observe(self, conduction: Conduction, state: Snapshot, time: float) -> Values:
        y = state["position"][:, 1].astype(float)
        low, held = y < 0.5 * self.height, state["heat_held"]
        cold, warm = np.sum(held[low]), np.sum(held[~low])
        if self.planes:
            cold, warm = np.array([cold, warm]) + conduction.heat_to_walls()[:2]
        heat = np.sum(state["mass"].astype(float) * state["enthalpy"])
        return {
            "front": Measured(self._front(y, state["solid_fraction"]), "m", "particles", panel="place of the front"),
            "exact_front": Measured(float(self.exact.front(time)), "m", "exact", panel="place of the front"),
            "temperature_error": Measured(self._error(y, state["temperature"], time), "", "RMS error of T"),
            "heat": Measured(float(heat), "J", "heat", per_depth=True),
            "heat_cold": Measured(float(cold), "J", "cold face", per_depth=True, panel="taken by faces"),
            "heat_warm": Measured(float(warm), "J", "warm face", per_depth=True, panel="taken by faces"),
        }

    def _front(self, y: np.ndarray, solid_fraction: np.ndarray) -> float:
        """Place [m] of the front by what has frozen, the rows on the faces with half their cells."""
        on_a_face = np.minimum(y, self.height - y) < 0.25 * self.spacing
        cells = np.where(on_a_face, 0.5, 1.0) * self.spacing
        return float(np.sum(cells * solid_fraction)) / self.columns

    def _error(self, y: np.ndarray, temperature: np.ndarray, time: float) -> float:
        """Root mean square of the temperature error over all particles, over the difference of the faces."""
        if time == 0.0:
            return 0.0
        error = temperature - self.exact.temperature(y, time)
        return float(np.sqrt(np.mean(error**2))) / (self.start - self.exact.plane)

    def checks(self, result: Result) -> list[Check]:
        series = result.diagnostics
        taken = series["heat_cold"][-1] + series["heat_warm"][-1]
        loss = series["heat"][0] - series["heat"][-1]
        alike = self.conductivity_solid == self.conductivity_liquid
        kind = f"{'equal' if alike else 'unequal'} phases, {self.method}"
        return [
            Check(
                self.name,
                f"front at {result.time:.4g} s ({kind})",
                "m",
                float(series["front"][-1]),
                float(self.exact.front(result.time)),
                0.5 * self.spacing,
                NEUMANN,
                relative=False,
                reason="half a spacing: one row freezes after the other",
            ),
            Check(
                self.name,
                f"RMS temperature error at {result.time:.4g} s, over the difference of the faces ({kind})",
                "",
                float(series["temperature_error"][-1]),
                None,
                0.006 * 40 / self.particles,
                NEUMANN,
                reason="what the paper's method gives with 40 particles, 0.5 %; first order, one row freezes at a time",
            ),
            Check(
                self.name,
                f"heat that is in no ledger, over the heat lost ({kind})",
                "",
                float((loss - taken) / loss),
                None,
                1e-5,
                "what faces take, the melt loses",
                reason="pairs exchange heat exactly; rounding of the enthalpies remains",
            ),
        ]

    def _checks_as_published(self, result: Result) -> Iterable[Check]:
        """What figures 1 and 2 say."""
        yield Check(
            self.name,
            "temperature of the cold face",
            "K",
            self.exact.plane,
            PUBLISHED_PLANE,
            1e-6,
            f"{SOURCE}, equation (3.6)",
            reason="the same formula",
        )
        f = result.fields["solid_fraction"]
        mushy = (f > 0.0) & (f < 1.0)
        yield Check(
            self.name,
            "rows that freeze, as published",
            "",
            float(np.sum(mushy)) / self.columns,
            1.0,
            1e-6,
            f"{SOURCE}, figure 2",
            reason="a count",
        )
        yield Check(
            self.name,
            "heat that this row has lost, over the latent heat",
            "",
            float(np.mean(f[mushy])),
            PUBLISHED_LOST,
            0.1,
            f"{SOURCE}, section 3.1: about 0.6",
            relative=False,
            reason="read off a figure",
        )

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The default, as published, with unequal phases, long steps, the curve alone; order of convergence."""
        paper, unequal = (preset_layer(cls, preset) for preset in ("paper", "unequal"))
        long = settings_layer(["integrator=crank_nicolson", "step=1.5"])  # ten times the explicit one
        for layers in ([], [paper], [unequal], [long], [unequal, long]):
            case = resolve(cls, layers)
            result = simulate(case)
            yield from case.checks(result)
            if case.phases is Phases.STORED:
                yield from case._checks_as_published(result)
        case = cls(phases=Phases.CURVE)
        yield from case.checks(simulate(case))
        for label, layers in (("", []), (", as published", [paper])):
            counts = np.array([20, 40, 80, 160])
            case = resolve(cls, layers)
            runs = [simulate(case.model_copy(update={"particles": int(n), "columns": 6})) for n in counts]
            errors = [float(run.diagnostics["temperature_error"][-1]) for run in runs]
            yield Check(
                cls.name,
                f"order of convergence{label}, " + ", ".join(f"{error:.2%}" for error in errors) + " with 20 to 160",
                "",
                float(-np.polyfit(np.log(counts - 1), np.log(errors), 1)[0]),
                1.5,
                0.5,
                "at least first order",
                relative=False,
                reason="from 1 to 2: one row freezes after the other, and the last one decides",
            )
