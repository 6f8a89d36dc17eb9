"""Freezing of a solution of sodium nitrate from below: a mush of ice grows into it."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import cached_property, partial
from itertools import pairwise

import numpy as np
from pydantic import model_validator

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.conduction.time_stepping import ConductingScenario, Stepping
from warpsph.scenarios.freezing.mush import Mush
from warpsph.terms import Alloy, HeatWall, Liquidus, Solute

SOURCE = "similarity solution of an ideal mush of fixed mass, after Worster (1986)"
EARLY, LATE = 13200.0, 91800.0  # 3 h 40 min and 25 h 30 min: figures 12 to 14
LONG = 600.0  # [s], of implicit steps; the explicit one is 46 s
THICK = 0.1  # volume fraction of ice from which fractions are compared


class SodiumNitrate(ConductingScenario):
    """A box of solution on a wall that is colder than its liquidus; insulated at the sides and above."""

    name = "sodium_nitrate"
    summary = "a solution of sodium nitrate freezes from below to a mush"
    source = "Monaghan, Huppert & Worster (2005), section 5, figures 12 to 14"
    presets = ("printed",)

    duration: float = parameter(LATE, "s", "physical time to simulate", gt=0, le=1e6)
    output_interval: float = parameter(1200.0, "s", "physical time between two frames and diagnostics", gt=0, le=1e6)
    rows: int = parameter(30, "", "rows of particles over the height", ge=8, le=400)
    columns: int = parameter(
        30, "", "particles in a row, which decide on the width: nothing changes along it", ge=4, le=400
    )
    smoothing: float = parameter(1.0, "", "smoothing length h over the spacing; the source has 1.3", ge=1.0, le=1.5)
    height: float = parameter(0.5, "m", "height of the box", gt=1e-3, le=10.0)
    concentration: float = parameter(0.14, "", "mass fraction of the salt at the start", gt=0, lt=0.9)
    cold: float = parameter(256.65, "K", "temperature of the wall below", gt=0, le=1e3)
    warm: float = parameter(287.85, "K", "temperature of the solution at the start", gt=0, le=1e3)
    melting_point: float = parameter(273.15, "K", "of the pure solvent", gt=0, le=1e3)
    liquidus_slope: float = parameter(
        42.28, "K", "Gamma: fall of the liquidus over a unit of mass fraction", gt=0, le=1e3
    )
    eutectic: float = parameter(255.65, "K", "temperature at which the salt would freeze, too", gt=0, le=1e3)
    latent_heat: float = parameter(334.4e3, "J/kg", "of freezing", gt=0, le=1e7)
    density: float = parameter(1097.0, "kg/m^3", "of the solution at the start", gt=0, le=2e4)
    density_ice: float = parameter(917.0, "kg/m^3", "of ice", gt=0, le=2e4)
    heat_capacity: float = parameter(4180.0, "J/(kg K)", "of the liquid", gt=0, le=1e5)
    heat_capacity_ice: float = parameter(2006.0, "J/(kg K)", "of ice", gt=0, le=1e5)
    conductivity: float = parameter(0.498, "W/(m K)", "of the liquid", gt=0, le=1e3)
    conductivity_ice: float = parameter(2.408, "W/(m K)", "of ice", gt=0, le=1e3)
    diffusivity: float = parameter(6.8e-7, "kg/(m s)", "of the salt, times the density", ge=0, le=1.0)
    literal: bool = parameter(False, "", "conduct as printed in (4.2), twice within the mush")

    @model_validator(mode="after")
    def _refuse_what_is_left_out(self) -> "SodiumNitrate":
        liquidus = self.melting_point - self.liquidus_slope * self.concentration
        rising = {"eutectic": self.eutectic, "cold": self.cold, "liquidus of the solution": liquidus, "warm": self.warm}
        left_out = {
            "cold": "a wall below the eutectic would freeze the salt, too, which the model leaves out",
            "liquidus of the solution": "a wall that is not below the liquidus freezes nothing",
            "warm": "ice that is there at the start is left out",
        }
        for (low, lower), (high, higher) in pairwise(rising.items()):
            if not lower < higher:
                raise ValueError(f"{high} ({higher:g} K) must be above {low} ({lower:g} K): {left_out[high]}")
        if (self.melting_point - self.eutectic) / self.liquidus_slope >= 1.0:
            raise ValueError("liquidus_slope: too small for the eutectic, there would be nothing left but salt")
        brine = (self.melting_point - self.cold) / self.liquidus_slope
        room = (1.0 - self.concentration / brine) * self.density / self.density_ice
        if room >= 1.0:
            raise ValueError(
                f"cold = {self.cold:g} K: ice would fill {room:.2f} of the room at the wall; the model leaves out that "
                "ice pushes liquid away, so the wall must be warmer or the concentration higher"
            )
        return self

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.height / self.rows

    @cached_property
    def exact(self) -> Mush:
        """The exact solution of a box without an upper end."""
        return Mush(
            self.concentration,
            self.cold,
            self.warm,
            self.melting_point,
            self.liquidus_slope,
            self.latent_heat,
            self.density,
            self.density_ice,
            self.heat_capacity,
            self.heat_capacity_ice,
            self.conductivity,
            self.conductivity_ice,
            self.diffusivity,
        )

    def build(self, executor: Executor) -> Simulation:
        width = self.columns * self.spacing
        walls = (
            HeatWall.at_temperature((0.0, 1.0, 0.0), 0.0, self.cold),
            HeatWall.insulated((0.0, -1.0, 0.0), -self.height),
            HeatWall.insulated((1.0, 0.0, 0.0), 0.0),
            HeatWall.insulated((-1.0, 0.0, 0.0), -width),
        )
        alloy = Alloy(
            solid_material(
                "ice", self.density_ice, conductivity=self.conductivity_ice, heat_capacity=self.heat_capacity_ice
            ),
            self.latent_heat,
            Liquidus.straight(self.melting_point, self.liquidus_slope, self.eutectic),
            walls,
            self.literal,
            longest_interval=self.step,
            integrator=self.stepping,
        )
        solution = fluid_material(
            "solution", self.density, conductivity=self.conductivity, heat_capacity=self.heat_capacity
        )
        particles = Particles()
        points = lattice((0.0, 0.0), (width, self.height), self.spacing)
        particles.add(points, Role.FREE, temperature=self.warm, solute=self.concentration)
        terms = (Solute(self.diffusivity, walls), alloy)
        model = Model(2, self.spacing, (solution,), terms, 2.0 * self.smoothing, gravity=(0.0, 0.0, 0.0))
        return Simulation(executor, model, particles, observe=partial(self._observe, alloy))

    def _observe(self, alloy: Alloy, state: Snapshot, time: float) -> Values:
        height = state["position"][:, 1].astype(float).reshape(self.columns, self.rows)[0]
        profiles = {
            name: state[name].astype(float).reshape(self.columns, self.rows).mean(axis=0)
            for name in ("temperature", "solid_fraction", "solute")
        }
        heat = float(np.sum(state["liquid_heat"] + state["ice_heat"] - state["heat_freed"]))
        taken = float(np.sum(alloy.heat_to_walls()))
        mass = float(np.sum(state["liquid_mass"] + state["ice_mass"]))
        ice = float(np.sum(state["ice_mass"]))
        thickness = self.front(height, profiles["temperature"]) if ice > 0.0 else 0.0
        return {
            "mush": Measured(thickness, "m", "warpsph", panel="thickness of the mush"),
            "mush_exact": Measured(
                self.exact.front(time), "m", "exact, in an endless box", panel="thickness of the mush"
            ),
            "heat": Measured(heat, "J", "of the box", per_depth=True, panel="heat"),
            "heat_taken": Measured(taken, "J", "taken by the wall", per_depth=True, panel="heat"),
            "mass": Measured(mass, "kg", "mass of liquid and ice", per_depth=True),
            "ice_mass": Measured(ice, "kg", "mass of ice", per_depth=True),
            "salt": Measured(float(np.sum(state["solute_mass"])), "kg", "mass of salt", per_depth=True),
            "temperature": Measured(profiles["temperature"], "K", "temperature", over="height"),
            "ice": Measured(profiles["solid_fraction"], "", "volume fraction of ice", over="height"),
            "brine": Measured(profiles["solute"], "", "mass fraction of salt in the liquid", over="height"),
            "height": Measured(height, "m", "height"),
        }

    def front(self, height: np.ndarray, temperature: np.ndarray) -> float:
        """Thickness [m] of the mush: where the particles have the temperature of the front of the exact solution."""
        heights, temperatures = np.append(0.0, height), np.append(self.cold, temperature)
        edge = self.exact.front_temperature
        above = int(np.argmax(temperatures > edge))
        if temperatures[above] <= edge:
            return self.height
        between = slice(max(above - 1, 0), above + 1)
        return float(np.interp(edge, temperatures[between], heights[between]))

    def errors(self, result: Result, time: float) -> tuple[float, float, float]:
        """At the frame nearest to a time: RMS errors of temperature [K] and of ice, and the error of the front [m].

        The ice is compared where there is more than ``THICK`` of it.
        """
        series = result.diagnostics
        frame = int(np.argmin(np.abs(series["time"] - time)))
        height, time = series["height"][frame], float(series["time"][frame])
        exact = self.exact.temperature(height, time)
        thick = (ice := self.exact.ice(height, time)) > THICK
        missing = series["ice"][frame] - ice
        return (
            _rms(series["temperature"][frame] - exact),
            _rms(missing[thick]),
            float(series["mush"][frame]) - self.exact.front(time),
        )

    def checks(self, result: Result) -> list[Check]:
        series = result.diagnostics
        checks = []
        for time in (EARLY, LATE):
            if result.time < time - 1.0:
                continue
            temperature, ice, front = self.errors(result, time)
            checks += [
                self._check(f"RMS error of the temperature after {time / 3600:.3g} h", "K", temperature, 0.4),
                self._check(f"error of the front after {time / 3600:.3g} h", "m", front, self.spacing),
            ]
            if time == LATE:
                checks.append(self._check(f"RMS error of the ice after {time / 3600:.3g} h", "", ice, 0.05))
        for name, tolerance in (("salt", 1e-6), ("mass", 1e-6)):
            change = series[name][-1] / series[name][0] - 1.0
            checks.append(
                Check(
                    self.name,
                    f"change of the {name}, over all of it{self._stepped}",
                    "",
                    float(change),
                    None,
                    tolerance,
                    "nothing passes the walls",
                    reason="pairs exchange exactly; rounding remains",
                )
            )
        lost = (series["heat"][-1] - series["heat"][0] + series["heat_taken"][-1]) / series["heat_taken"][-1]
        checks.append(
            Check(
                self.name,
                f"heat that is in no ledger, over what the wall has taken{self._stepped}",
                "",
                float(lost),
                None,
                1e-5,
                "what the wall takes, the box loses",
                reason="liquid and ice exchange heat exactly; rounding remains",
            )
        )
        return checks

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The box, also with long steps; narrow ones with more and more rows; and heat conducted as printed."""
        box = cls()
        for case in (box, cls(integrator=Stepping.CRANK_NICOLSON, step=LONG)):
            yield from case.checks(simulate(case))
        rows = (30, 60, 120) if slow else (15, 30, 60)
        counts = ", ".join(map(str, rows))
        narrow = [cls(rows=n, columns=4) for n in rows]
        runs = [simulate(case) for case in narrow]
        found = zip(*(case.errors(run, LATE) for case, run in zip(narrow, runs, strict=True)), strict=True)
        for what, unit, errors in zip(
            ("temperature", "ice", "front"), (" K", "", " m"), np.abs(list(found)), strict=True
        ):
            listed = ", ".join(f"{error:.2g}{unit}" for error in errors)
            yield Check(
                cls.name,
                f"{what}: largest ratio of an error to that with half the rows ({listed} with {counts} rows)",
                "",
                float(np.max(errors[1:] / errors[:-1])),
                None,
                0.9,
                SOURCE,
                reason="errors fall with the spacing",
            )
        printed = cls(rows=60, columns=4, literal=True)
        thicker = float(simulate(printed).diagnostics["mush"][-1] / runs[rows.index(60)].diagnostics["mush"][-1])
        yield Check(
            cls.name,
            "thickness of the mush with (4.2) as printed, over that without counting twice",
            "",
            thicker,
            replace(box.exact, literal=True).front(LATE) / box.exact.front(LATE),
            0.02,
            "similarity solutions with and without the conductivity that (4.2) adds up to",
            reason="60 rows: errors of both fronts are below 1 %",
        )

    def _check(self, quantity: str, unit: str, error: float, tolerance: float) -> Check:
        reason = "with 30 rows the mush is two of them thick at first, six at the end"
        return Check(self.name, quantity + self._stepped, unit, error, None, tolerance, SOURCE, reason=reason)

    @property
    def _stepped(self) -> str:
        """What is said of implicit steps in the names of checks."""
        if self.integrator is Stepping.EXPLICIT:
            return ""
        return f" ({self.integrator.value}, steps of {self.step:g} s)"


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2))) if len(values) else 0.0
