"""A rectangle of particles on a hot floor."""

from collections.abc import Callable, Iterable
from typing import Literal

import numpy as np
from pydantic import model_validator

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.bonded_solid.outcome import Outcome, check_unheated
from warpsph.scenarios.bonded_solid.particle_solid import FOOT, SOURCE, ParticleSolid
from warpsph.scenarios.bonded_solid.tables import published
from warpsph.terms import BondedPhase, Floor

MEMBERS = 40
NOISE = 1.0e-12  # [ft], which grows to the size of a bond within 25 000 steps


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

    @model_validator(mode="after")
    def _check_floor(self) -> "MeltingRectangle":
        least = self.hot - 2.0 * self.hot_slope * self.hot_half_width
        if least < 0.0:
            raise ValueError(
                f"hot_slope = {self.hot_slope} 1/ft: the right end of the hot floor would give back {least:.4g} of the "
                f"speed, less than nothing, with hot = {self.hot} and hot_half_width = {self.hot_half_width} ft"
            )
        return self

    def build(self, executor: Executor) -> Simulation:
        floor = Floor(self.restitution, self.hot, self.hot_slope / FOOT, FOOT * self.hot_half_width)
        phases = BondedPhase(FOOT * self.cutoff, self.interval, highest_energy=FOOT**2 * self.highest_energy)
        return self.simulation(executor, published("rectangle", self.table == "corrected"), (floor, phases))

    @classmethod
    def member(cls, preset: str, seed: int) -> "MeltingRectangle":
        """A preset whose start is changed by as little as double precision can tell."""
        case = resolve(cls, [preset_layer(cls, preset)])
        return case.model_copy(update={"perturbation": NOISE, "seed": seed})

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Without heat; the table as printed on the hot floor; and 40 starts that differ by next to nothing."""
        symmetric, printed = published("rectangle", corrected=True), resolve(cls, [preset_layer(cls, "printed")])
        unheated = Outcome(simulate(cls()), symmetric)
        yield from check_unheated(cls.name, unheated, "50 000")
        yield Check(
            cls.name,
            "highest mean kinetic energy of a particle [kg ft^2/s^2], 50 000 steps without heat",
            "",
            unheated.hottest_at_end,
            None,
            9.0,
            "the same equations by another program: below 9",
            reason="far from the 25 at which particles are fluid",
        )
        run = Outcome(simulate(printed), symmetric)
        yield Check(
            cls.name,
            "step of the first fluid particle, table as printed",
            "",
            round(run.first_fluid_time / printed.step),
            25000.0,
            1000.0,
            "the same equations by another program",
            relative=False,
            reason="phases are found every 1000 steps; rounding has not grown to the size of a bond before",
        )
        if not slow:
            return
        runs = [Outcome(simulate(cls.member("printed", seed)), symmetric) for seed in range(MEMBERS)]
        yield from cls._of_ensemble("printed", runs)

    @classmethod
    def _of_ensemble(cls, preset: str, runs: list[Outcome]) -> Iterable[Check]:
        fluid = np.array([run.fluid_at_end for run in runs])
        published_count = len(runs[0].table.places)
        where = f"{len(runs)} starts, {preset}"
        for quantity, found, reference, tolerance, reason in (
            ("fewest particles fluid at step 50 000", fluid.min(), published_count, 16, "30 or more of 46"),
            ("most particles fluid at step 50 000", fluid.max(), published_count, 0, "the paper has all 46"),
            ("runs in which both waves have gone 5 ft or farther", sum(run.flows_apart(5.0) for run in runs),
             len(runs), 0, "two portions flow outward, the body reached 3.3 ft to each side"),
        ):  # fmt: skip
            what, source = f"{quantity} ({where})", f"{SOURCE}, figure 5.2"
            yield Check(cls.name, what, "", float(found), reference, tolerance, source, relative=False, reason=reason)
