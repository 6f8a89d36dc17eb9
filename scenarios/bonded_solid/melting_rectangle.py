"""A rectangle of particles on a hot floor."""

from typing import Literal

from warpsph.cases.scenario import parameter
from warpsph.core.executor import Executor
from warpsph.run.simulation import Simulation
from warpsph.scenarios.bonded_solid.particle_solid import FOOT, SOURCE, ParticleSolid
from warpsph.scenarios.bonded_solid.tables import published
from warpsph.terms import BondedPhase, Floor


class MeltingRectangle(ParticleSolid):
    """46 particles on a floor that throws them back faster than they came; those of high mean energy are fluid."""

    name = "melting_rectangle"
    summary = "a solid of 46 particles melts on a hot floor and flows apart"
    source = f"{SOURCE}, section 5, figure 5.2"
    presets = ("printed", "corrected")
    default_preset = "printed"

    duration: float = parameter(5.0, "s", "physical time to simulate", gt=0, le=1e4)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e4)
    attraction: float = parameter(2540.0, "kg ft/s^2 at 1 ft", "attraction G of two particles", gt=0, le=1e6)
    repulsion: float = parameter(2940.0, "kg ft/s^2 at 1 ft", "repulsion H of two particles", gt=0, le=1e6)
    attraction_exponent: int = parameter(7, "", "exponent beta of the attraction", ge=2, le=24)
    repulsion_exponent: int = parameter(10, "", "exponent alpha of the repulsion", ge=3, le=48)
    table: Literal["printed", "corrected"] = parameter("corrected", "", "table 2 as printed, or symmetric")
    hot_half_width: float = parameter(0.0, "ft", "half the width of the hot part of the floor", ge=0, le=100)
    hot: float = parameter(1.5, "", "share of the speed that its left end gives back", ge=0, le=10)
    hot_slope: float = parameter(0.025, "1/ft", "by how much that falls in a foot to the right", ge=-1, le=1)
    highest_energy: float = parameter(
        25.0, "kg ft^2/s^2", "mean kinetic energy from which on a particle is fluid", gt=0, le=1e6
    )

    def build(self, executor: Executor) -> Simulation:
        floor = Floor(self.restitution, self.hot, self.hot_slope / FOOT, FOOT * self.hot_half_width)
        phases = BondedPhase(FOOT * self.cutoff, self.interval, highest_energy=FOOT**2 * self.highest_energy)
        return self.simulation(executor, published("rectangle", self.table == "corrected"), floor, phases)
