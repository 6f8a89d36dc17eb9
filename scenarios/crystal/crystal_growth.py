"""Growth of a silicon-germanium crystal by liquid phase diffusion: the temperature in its crucible."""

from collections.abc import Callable, Iterable
from functools import partial

import numpy as np

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.conduction.time_stepping import ConductingScenario, Stepping
from warpsph.scenarios.crystal.ampoule import Ampoule
from warpsph.scenarios.crystal.finite_volumes import SquareCells
from warpsph.scenarios.crystal.isotherm import isotherm
from warpsph.terms import Conduction

SOURCE = "finite volumes on the cells of the particles"


class CrystalGrowth(Ampoule, ConductingScenario):
    """Conduction in a crucible that starts at the temperatures of the furnace beside it."""

    name = "crystal_growth"
    summary = "temperature in a crucible in which a silicon-germanium crystal grows"
    source = "Rook, Yildiz & Dost (2007), section 5, figures 10 to 12"
    presets = ("coarse", "fine")

    duration: float = parameter(1800.0, "s", "physical time to simulate", gt=0, le=1e6)
    output_interval: float = parameter(60.0, "s", "physical time between two frames and diagnostics", gt=0, le=1e6)
    integrator: Stepping = parameter(
        Stepping.CRANK_NICOLSON, "", "how steps of conduction are made: explicit, backward_euler, crank_nicolson"
    )
    step: float = parameter(0.5, "s", "longest step of conduction; an explicit one is shorter by itself", gt=0, le=1e3)
    support_ratio: float = parameter(2.0, "", "support of the smoothing kernel over the spacing", ge=2.0, le=4.0)
    melting_point: float = parameter(1211.45, "K", "of germanium: the interface", gt=0, le=1e4)

    def build(self, executor: Executor) -> Simulation:
        points = self.points
        conduction = Conduction(
            longest_interval=self.step,
            walls=self.walls,
            smoothing="cubic_spline",
            integrator=self.stepping,
        )
        model = Model(
            2, self.spacing, self.materials, (conduction,), support_ratio=self.support_ratio, gravity=(0.0, 0.0, 0.0)
        )
        particles = Particles()
        start = self.furnace.at(points, 0.0)
        particles.add(points, Role.FREE, material=self.material_at(points), temperature=start)
        return Simulation(executor, model, particles, observe=partial(self._observe, conduction))

    def finite_volumes(self, time: float) -> np.ndarray:
        """Temperature (columns, rows) [K] at a ``time`` [s] by finite volumes, one for each particle."""
        points, shape = self.points, self.shape
        _, bottom, top, _ = self.walls
        materials = {material.name: material for material in self.materials}
        of_cells = [materials[name] for name in self.material_at(points)]
        capacity = [m.density * float(m.enthalpy(1000.0) - m.enthalpy(0.0)) / 1000.0 for m in of_cells]
        last, along = points[-shape[1] :], np.ones(shape[0])
        cells = SquareCells(
            self.spacing,
            np.reshape([m.conductivity_solid for m in of_cells], shape),
            np.reshape(capacity, shape),
            (self.film.at(last, 0.0), bottom.conductance * along, top.conductance * along),
            (self.furnace.at(last, 0.0), bottom.outside * along, top.outside * along),
        )
        return cells.temperature(self.furnace.at(points, 0.0).reshape(shape), time)

    def interface(self, temperature: np.ndarray) -> np.ndarray:
        """Height (columns,) [m] of the melting point in the columns of the charge."""
        rows = (np.arange(self.shape[1]) + 0.5) * self.spacing
        return isotherm(rows, temperature[: self.charge_columns], self.melting_point)

    def across(self, temperature: np.ndarray, height: float) -> float:
        """How much hotter [K] the charge is beside the crucible than on the axis, at a height [m]."""
        row = int(height / self.spacing)
        return float(temperature[self.charge_columns - 1, row] - temperature[0, row])

    def _observe(self, conduction: Conduction, state: Snapshot, time: float) -> Values:
        field = state["temperature"].astype(float).reshape(self.shape)
        interface = self.interface(field)
        side, bottom, top, _ = conduction.heat_to_walls()
        mass = state["mass"].astype(float)
        columns = (np.arange(len(interface)) + 0.5) * self.spacing
        return {
            "heat": Measured(float(np.sum(mass * state["enthalpy"])), "J", "heat of all", per_depth=True),
            "heat_side": Measured(side, "J", "side", per_depth=True, panel="taken by the furnace"),
            "heat_bottom": Measured(bottom, "J", "bottom", per_depth=True, panel="taken by the furnace"),
            "heat_top": Measured(top, "J", "top", per_depth=True, panel="taken by the furnace"),
            "interface_axis": Measured(interface[0], "m", "on the axis", panel="interface"),
            "interface_wall": Measured(interface[-1], "m", "beside the crucible", panel="interface"),
            "interface": Measured(interface, "m", "height of the interface", over="column"),
            "column": Measured(columns, "m", "distance from the axis"),
        }

    def checks(self, result: Result) -> list[Check]:
        exact = self.finite_volumes(result.time)
        field = result.fields["temperature"].astype(float).reshape(self.shape)
        interface, expected = self.interface(field), self.interface(exact)
        contact = "perfect contact of two conductivities is first order in the spacing"
        rows: list[tuple[str, str, float, float | None, float, str]] = [
            ("RMS difference of the temperature", "K", _rms(field - exact), None, 2.0, contact),
            (
                "largest difference of the interface, over the spacing",
                "",
                float(np.abs(interface - expected).max()) / self.spacing,
                None,
                0.5,
                contact,
            ),
            (
                "interface beside the crucible above that on the axis: it is concave",
                "m",
                interface[-1] - interface[0],
                expected[-1] - expected[0],
                0.5 * self.spacing,
                "half a spacing",
            ),
        ]
        for where, height in (
            ("the middle of the solution", self.substrate_top + 0.5 * self.solution_height),
            ("the middle of the source", self.source_bottom + 0.5 * self.source_height),
        ):
            quantity = f"temperature beside the crucible less that on the axis, in {where}"
            rows.append((quantity, "K", self.across(field, height), self.across(exact, height), 1.0, contact))
        checks = [
            Check(self.name, quantity, unit, float(measured), reference, tolerance, SOURCE, False, reason)
            for quantity, unit, measured, reference, tolerance, reason in rows
        ]
        series = result.diagnostics
        taken = sum(series[name][-1] for name in ("heat_side", "heat_bottom", "heat_top"))
        checks.append(
            Check(
                self.name,
                "heat that is in no ledger, over the heat of all",
                "",
                float((series["heat"][-1] - series["heat"][0] + taken) / series["heat"][0]),
                None,
                1e-6,
                "what the furnace takes, crucible and charge lose",
                reason="pairs exchange heat exactly; rounding of the enthalpies remains",
            )
        )
        return checks

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """With rows of 1 mm, as published, and with rows of 0.25 mm where there is time."""
        for preset in ("coarse", None, "fine") if slow else ("coarse", None):
            case = resolve(cls, [preset_layer(cls, preset)] if preset else [])
            yield from case.checks(simulate(case))


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))
