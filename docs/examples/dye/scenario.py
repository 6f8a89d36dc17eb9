"""The scenario: dye in one half of a strip of water spreads into the other half."""

import numpy as np
from scipy.special import erfc

from dye.term import Dye
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation


class DyedWater(Scenario):
    """A strip of water at rest, 1 m long, with dye where x < 0."""

    name = "dyed_water"
    summary = "dye spreads in water at rest"
    source = "error function, the exact solution of the diffusion equation"

    duration: float = parameter(2.0, "s", "physical time to simulate", gt=0, le=1e3)
    output_interval: float = parameter(0.5, "s", "physical time between two frames", gt=0, le=1e3)
    spacing: float = parameter(0.02, "m", "particle spacing", ge=1e-3, le=0.1)
    diffusivity: float = parameter(2.0e-3, "m^2/s", "diffusivity of the dye", gt=0, le=1.0)

    def build(self, executor: Executor) -> Simulation:
        water = fluid_material("water", 1000.0)
        model = Model(2, self.spacing, (water,), (Dye(self.diffusivity),), gravity=(0.0, 0.0, 0.0))
        x = lattice((-0.5, 0.0), (0.5, 0.2), self.spacing)
        particles = Particles()
        particles.add(x, Role.FREE, dye=np.where(x[:, 0] < 0.0, 1.0, 0.0))
        return Simulation(executor, model, particles, observe=self._observe)

    def _observe(self, state: Snapshot, time: float) -> Values:
        return {"dye_in_all": Measured(float(state["dye"].astype(float).mean()), "", "mean of the dye")}

    def checks(self, result: Result) -> list[Check]:
        exact = 0.5 * erfc(result.positions[:, 0] / np.sqrt(4.0 * self.diffusivity * result.time))
        error = float(np.sqrt(np.mean((result.fields["dye"] - exact) ** 2)))
        reason = "second order in the spacing over the width of the front, 9 cm"
        return [Check(self.name, "RMS error of the dye", "", error, None, 0.01, self.source, reason=reason)]
