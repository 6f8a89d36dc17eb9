"""A plate whose edges are kept cold: the first plate of Rook, Yildiz & Dost (2007)."""

from collections.abc import Callable, Iterable

import numpy as np

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.conduction.plate import SOURCE, CoolingPlate
from warpsph.scenarios.conduction.plate_checks import (
    allowed,
    coarseness,
    error_check,
    figure_times,
    ledger_check,
    order_check,
)
from warpsph.scenarios.conduction.plate_series import FixedPlate
from warpsph.scenarios.conduction.plate_steps import step_checks
from warpsph.scenarios.conduction.time_stepping import Stepping
from warpsph.terms import HeatWall, cut_cells

IMPLICIT_STEPS = (  # [s]
    (Stepping.CRANK_NICOLSON, 0.009),
    (Stepping.CRANK_NICOLSON, 0.05),
    (Stepping.BACKWARD_EULER, 0.05),
)


class PlateFixed(CoolingPlate):
    """A plate of one temperature whose four edges are kept at another from the start, by particles on them."""

    name = "plate_fixed"
    summary = "a plate between four edges of given temperature cools"
    source = f"{SOURCE}, section 4.1, figures 4 and 5"
    presets = ("paper", "implicit")
    fouriers = (0.0025, 0.01, 0.04, 0.08)  # 0.25, 1, 4 and 8 s

    edge: float = parameter(273.15, "K", "temperature of the edges", gt=0, le=5e3)
    planes: bool = parameter(True, "", "whether the edges have images; otherwise the particles on them do alone")

    @property
    def row_on_walls(self) -> bool:
        return True

    @property
    def exact(self) -> FixedPlate:
        return FixedPlate(self.length, self.height, self.diffusivity, self.start, self.edge)

    @property
    def walls(self) -> list[HeatWall]:
        ends = (((1, 0, 0), 0.0), ((-1, 0, 0), -self.length), ((0, 1, 0), 0.0), ((0, -1, 0), -self.height))
        return [HeatWall.at_temperature(normal, offset, self.edge) for normal, offset in ends]

    def build(self, executor: Executor) -> Simulation:
        points, walls = self.points, self.walls
        on_edge = np.any([np.abs(wall.height(points)) < 0.25 * self.spacing for wall in walls], axis=0)
        cells = cut_cells(points, walls, self.spacing, 2) if self.planes else np.full(len(points), self.spacing**2)
        temperature = np.where(on_edge, self.edge, self.start)
        particles = self.placed(cells, temperature=temperature, held=on_edge)
        return self.simulation(executor, particles, self.conduction(walls if self.planes else ()))

    def checks(self, result: Result) -> list[Check]:
        reason = "second order in the spacing, over the depth to which the edges have cooled the plate; and the steps"
        coarser, checks = coarseness(self) ** 2, []
        for time in figure_times(self, result):
            early = time < 0.005 * self.length**2 / self.diffusivity
            numbers = (0.35 * coarser, 2.5e3, 5.6e5) if early else (0.1 * coarser, 1e3, 8e4)
            checks.append(error_check(self, result, time, "", allowed(self, *numbers), "(19)", reason))
        return [*checks, ledger_check(self, result)]

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The default, as published with both figures' steps, implicit steps; orders in the spacing and in the step."""
        cases = [cls(), *(resolve(cls, [preset_layer(cls, preset)]) for preset in cls.presets)]
        cases += [cls(integrator=integrator, step=step) for integrator, step in IMPLICIT_STEPS]
        for case in cases:
            yield from case.checks(simulate(case))
        yield order_check(
            cls(), simulate, "", 2.0, "smoothing error of second order, and steps that go with its square"
        )
        yield from step_checks(cls, simulate, slow)
