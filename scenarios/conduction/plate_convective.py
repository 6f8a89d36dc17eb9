"""A plate that is insulated on two sides and cooled through films on two: the second of Rook, Yildiz & Dost (2007)."""

from collections.abc import Callable, Iterable
from enum import StrEnum

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
from warpsph.scenarios.conduction.plate_series import ConvectivePlate
from warpsph.scenarios.conduction.time_stepping import Stepping
from warpsph.terms import GradientWalls, HeatWall


class Boundary(StrEnum):
    """How the edges pass heat."""

    IMAGES = "images"  # rows half a spacing before them, images behind them
    GRADIENT = "gradient"  # particles on them, whose one-sided gradient is that of the flux: as published


class PlateConvective(CoolingPlate):
    """A plate of one temperature, insulated at x = 0 and y = 0; films before a medium of another at the other edges."""

    name = "plate_convective"
    summary = "a plate cools through films on two edges, the others are insulated"
    source = f"{SOURCE}, section 4.2, figures 7 and 8"
    presets = ("paper",)
    fouriers = (0.005, 0.01, 0.04, 0.08)  # 0.5, 1, 4 and 8 s

    outside: float = parameter(273.15, "K", "temperature of the medium", gt=0, le=5e3)
    conductance: float = parameter(1000.0, "W/(m^2 K)", "of the films", gt=0, le=1e6)
    boundary: Boundary = parameter(Boundary.IMAGES, "", "how the edges pass heat: images, gradient")

    @property
    def row_on_walls(self) -> bool:
        return self.boundary is Boundary.GRADIENT

    @property
    def exact(self) -> ConvectivePlate:
        ratio = self.conductance / self.conductivity
        return ConvectivePlate(self.length, self.height, self.diffusivity, self.start, self.outside, ratio)

    @property
    def walls(self) -> list[HeatWall]:
        ends = (((-1, 0, 0), -self.length), ((0, -1, 0), -self.height))
        films = [HeatWall.film(normal, offset, self.conductance, self.outside) for normal, offset in ends]
        return [HeatWall.insulated((1, 0, 0), 0.0), HeatWall.insulated((0, 1, 0), 0.0), *films]

    def build(self, executor: Executor) -> Simulation:
        particles = self.placed(self.spacing**2)
        if self.boundary is Boundary.GRADIENT:
            return self.simulation(executor, particles, self.conduction(()), GradientWalls(self.walls))
        return self.simulation(executor, particles, self.conduction(self.walls))

    def checks(self, result: Result) -> list[Check]:
        coarser, stronger = coarseness(self), max(self.exact.ratio * self.length, 1.0)
        if self.boundary is Boundary.IMAGES:
            method, tolerance = "", min(stronger, 5.0) * allowed(self, 0.02 * coarser**2, 80.0, 1.6e4)
            reason = "second order in the spacing, at the edges too; and the steps"
        else:
            method, tolerance = "gradient on one side", min(stronger, 2.5) * allowed(self, 0.8 * coarser, 80.0, 1.6e4)
            reason = "first order in the spacing: the gradient is found half a spacing from the edge"
        checks = [
            error_check(self, result, time, method, tolerance, "(20)", reason) for time in figure_times(self, result)
        ]
        return [*checks, ledger_check(self, result)]

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The default, as published, the published edges with an exact sum; both orders of convergence."""
        published = cls(boundary=Boundary.GRADIENT)
        paper = resolve(cls, [preset_layer(cls, "paper")])
        implicit = {"integrator": Stepping.CRANK_NICOLSON, "step": 0.05}
        for case in (cls(), paper, published, *(one.model_copy(update=implicit) for one in (cls(), paper))):
            yield from case.checks(simulate(case))
        yield order_check(
            cls(), simulate, "", 2.0, "images continue a linear profile exactly, a bent one to second order"
        )
        yield order_check(published, simulate, ", gradient on one side", 1.0, "found half a spacing from the edge")
