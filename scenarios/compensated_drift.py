"""One slow particle far from the origin: single precision alone would never move it."""

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import inert
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.run.simulation import Result, Simulation


class CompensatedDrift(Scenario):
    """A free particle at a constant velocity, in steps smaller than single precision resolves at its place."""

    name = "compensated_drift"
    summary = "one slow particle, advanced in steps below single precision"
    source = "Kahan (1965), compensated summation"

    duration: float = parameter(1.0, "s", "physical time to simulate", gt=0, le=1e3)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e3)
    start: float = parameter(2.0, "m", "coordinate of the particle at the start", ge=-100.0, le=100.0)
    speed: float = parameter(1.0e-3, "m/s", "its velocity", ge=-1.0, le=1.0)
    time_step: float = parameter(1.0e-5, "s", "time step", ge=1e-7, le=0.1)

    def build(self, executor: Executor) -> Simulation:
        model = Model(dimension=2, spacing=0.01, materials=(inert("marker", density=1000.0),), gravity=(0.0, 0.0, 0.0))
        particles = Particles()
        particles.add(np.array([[self.start, 0.0, 0.0]]), Role.FREE, velocity=(self.speed, 0.0, 0.0))
        return Simulation(
            executor, model, particles, dt=self.time_step, observe=lambda state, time: {"x": state["position"][0, 0]}
        )

    def checks(self, result: Result) -> list[Check]:
        velocity = float(np.float32(self.speed))
        return [
            Check(
                self.name,
                f"place after {result.steps} steps",
                "m",
                float(result.positions[0, 0]),
                self.start + velocity * result.time,
                1e-6,
                "uniform motion",
                relative=False,
                reason="a few units in the last place of single precision, which are 2.4e-7 m at 2 m",
            )
        ]
