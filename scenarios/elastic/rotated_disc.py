"""A solid disc that has been turned: the turn must not be felt, and what is felt must keep momentum."""

import math
from collections.abc import Callable, Iterable

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.terms import Elasticity

DENSITY = 2100.0  # [kg/m^3]


class RotatedDisc(Scenario):
    """A disc is bonded at rest; then, at once, it is turned, and stretched more and more towards one side."""

    name = "rotated_disc"
    summary = "a solid disc that has been turned feels no force"
    source = "invariance of Vijaykumar (2012), chapter 4, under a turn"

    duration: float = parameter(0.02, "s", "physical time to simulate", gt=0, le=10.0)
    output_interval: float = parameter(1e-3, "s", "physical time between two frames and diagnostics", gt=0, le=10.0)
    spacing: float = parameter(2.0e-3, "m", "particle spacing", ge=5e-4, le=0.01)
    radius: float = parameter(0.05, "m", "radius of the disc", ge=0.02, le=0.5)
    angle: float = parameter(90.0, "degree", "angle by which the disc is turned", ge=-360.0, le=360.0)
    stretch: float = parameter(0.0, "", "strain that the turned disc has at its edge", ge=-0.1, le=0.1)
    drift: float = parameter(0.0, "m/s", "velocity of the whole disc", ge=-5.0, le=5.0)
    youngs_modulus: float = parameter(4.0e5, "Pa", "Young's modulus", ge=1.0, le=1e9)
    poisson_ratio: float = parameter(0.3, "", "Poisson's ratio", ge=0.0, lt=0.5)
    corrected: bool = parameter(True, "", "correct gradients by the moment matrix; false is the published form")

    def build(self, executor: Executor) -> Simulation:
        model = Model(
            dimension=2,
            spacing=self.spacing,
            materials=(solid_material("shell", DENSITY),),
            gravity=(0.0, 0.0, 0.0),
            terms=(Elasticity(self.youngs_modulus, self.poisson_ratio, corrected=self.corrected),),
        )
        square = lattice((-self.radius,) * 2, (self.radius,) * 2, self.spacing)
        particles = Particles()
        particles.add(
            square[np.linalg.norm(square, axis=1) < self.radius],
            Role.FREE,
            velocity=(self.drift, 0.5 * self.drift, 0.0),
            phase=Phase.SOLID,
        )
        margin = 4.0 * self.radius
        simulation = Simulation(
            executor, model, particles, lower=(-margin,) * 3, upper=(margin,) * 3, observe=self._observe
        )
        simulation.prepare()  # the bonds keep these positions
        self._deform(simulation)
        return simulation

    def _deform(self, simulation: Simulation) -> None:
        x = simulation.state.numpy("position").astype(float)
        x[:, 0] += 0.5 * self.stretch * x[:, 0] ** 2 / self.radius
        c, s = math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        simulation.state.position.assign(x @ turn.T)
        simulation.state.outdated.fill_(1)

    def _observe(self, state: Snapshot, time: float) -> Values:
        mass = state["mass"].astype(float)[:, None]
        force = float(np.linalg.norm(mass * state["acceleration"], axis=1).max())
        return {
            "momentum": Measured(np.sum(mass * state["velocity"], axis=0), "kg m/s", "momentum", per_depth=True),
            "largest_force": Measured(force, "N", "largest force on a particle", per_depth=True),
        }

    def checks(self, result: Result) -> list[Check]:
        checks = []
        if self.stretch == 0.0:
            scale = self.youngs_modulus * self.spacing  # of one particle: E dx^2 / dx
            checks.append(
                Check(
                    self.name,
                    f"largest force after a turn by {self.angle:g} degrees, over E times area over length",
                    "",
                    float(result.diagnostics["largest_force"].max() / scale),
                    None,
                    1e-4,
                    self.source,
                    reason="rounding of positions in single precision; area and spacing of a particle",
                )
            )
        if self.drift != 0.0:
            momentum = result.diagnostics["momentum"]
            change = np.linalg.norm(momentum - momentum[0], axis=1).max()
            checks.append(
                Check(
                    self.name,
                    f"change of momentum in {result.steps} steps, over the momentum",
                    "",
                    float(change / np.linalg.norm(momentum[0])),
                    None,
                    1e-6,
                    "Newton's third law, Vijaykumar (4.14)",
                    reason="pair forces are equal and opposite but for rounding",
                )
            )
        return checks

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """A turn by a right angle, a turn by another, and a turned, stretched, vibrating disc that flies."""
        for scenario in (cls(), cls(angle=33.0), cls(stretch=0.02, drift=1.0)):
            yield from scenario.checks(simulate(scenario))
