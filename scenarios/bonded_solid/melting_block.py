"""A large block of particles beside a lamp: the side that the lamp sees melts, the side in the shadow does not."""

from collections.abc import Callable, Iterable

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.recorder import Observe
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.bonded_solid.particle_solid import FOOT, SOURCE, ParticleSolid
from warpsph.scenarios.bonded_solid.tables import Table
from warpsph.terms import BondedPhase, Damping, Floor, Lamp

ENDS = 0.1  # share of the columns at each end of the block that diagnostics look at
ROOM = 1.5  # half width and height in which most particles stay, over those of the block


class MeltingBlock(ParticleSolid):
    """A close-packed block settles on the floor under friction; then a lamp at its left is switched on."""

    name = "melting_block"
    summary = "a block of 10 000 particles melts where a lamp shines on it"
    source = f"{SOURCE}, section 6, proposed there: radiant heat with shadows"

    duration: float = parameter(20.0, "s", "physical time to simulate", gt=0, le=1e4)
    output_interval: float = parameter(0.2, "s", "physical time between two frames and diagnostics", gt=0, le=1e4)
    gravity: float = parameter(6.0, "ft/s^2", "gravity, downwards", ge=0, le=1e3)
    step: float = parameter(1e-3, "s", "time step", gt=0, le=1.0)
    averaged_steps: int = parameter(100, "", "steps of a mean velocity, and from phases to phases", ge=1, le=10**6)
    perturbation: float = parameter(0.01, "ft", "largest change of each coordinate at the start", ge=0, le=0.1)
    highest_speed: float = parameter(7.5, "ft/s", "mean speed above which a particle is fluid", gt=0, le=1e6)
    columns: int = parameter(200, "", "particles across", ge=10, le=2000)
    rows: int = parameter(50, "", "particles from bottom to top", ge=10, le=2000)
    friction: float = parameter(2.0, "1/s", "rate at which velocities decay while the block settles", ge=0, le=100)
    settling: float = parameter(6.0, "s", "time until friction ends and the lamp is switched on", ge=0, le=1e4)
    lamp_distance: float = parameter(30.0, "ft", "distance of the lamp from the left side", gt=1, le=1e4)
    lamp_height: float = parameter(0.5, "", "height of the lamp over that of the block", ge=0, le=5)
    power: float = parameter(4.0e5, "kg ft^2/s^3", "power of the lamp, to all sides", ge=0, le=1e9)
    rays: int = parameter(8192, "", "rays of the lamp", ge=64, le=2**20)

    @property
    def spacing(self) -> float:
        """Length [ft] of a bond at rest."""
        return self.potential.rest_length / FOOT

    @property
    def size(self) -> tuple[float, float]:
        """Width and height [ft] of the block."""
        return (self.columns - 0.5) * self.spacing, (self.rows - 1) * self.spacing * np.sqrt(0.75)

    @property
    def lamp_place(self) -> tuple[float, float]:
        """Place of the lamp [ft]."""
        return -0.5 * self.size[0] - self.lamp_distance, self.lamp_height * self.size[1]

    def lattice(self) -> Table:
        """Close-packed rows at rest, the lowest on the floor."""
        column, row = (index.ravel() for index in np.meshgrid(np.arange(self.columns), np.arange(self.rows)))
        x = (column + 0.5 * (row % 2)) * self.spacing - 0.5 * self.size[0]
        places = np.column_stack([x, row * self.spacing * np.sqrt(0.75)])
        return Table(places, np.zeros_like(places))

    def build(self, executor: Executor) -> Simulation:
        table = self.lattice()
        lamp = Lamp(
            (FOOT * self.lamp_place[0], FOOT * self.lamp_place[1], 0.0),
            FOOT**2 * self.power,
            0.5 * FOOT * self.spacing,
            self.rays,
            self.settling,
        )
        terms = (
            Floor(self.restitution),
            Damping(self.friction, self.settling),
            lamp,
            BondedPhase(FOOT * self.cutoff, self.interval, highest_speed=FOOT * self.highest_speed),
        )
        box = (ROOM * max(0.5 * self.size[0], -self.lamp_place[0]), ROOM * self.size[1])
        return self.simulation(executor, table, terms, box, self._observer(table))

    @property
    def share_of_rays(self) -> float:
        """Share of the lamp's rays that meet the block before it melts: the angle under which its left side is seen."""
        x, y = self.lamp_place
        distance, radius = -0.5 * self.size[0] - x, 0.5 * self.spacing
        edges = ((distance, -radius - y), (distance, self.size[1] + radius - y))
        low, high = (np.arctan2(*edge[::-1]) for edge in edges)
        return float((high - low) / (2.0 * np.pi))

    def checks(self, result: Result) -> list[Check]:
        series, size = result.diagnostics, f"{self.columns} by {self.rows} particles"
        start = int(np.argmin(np.abs(series["time"] - self.settling)))
        before, dark = series["fluid"][: start + 1].max(), series["fluid_dark"].max()
        rows = [
            ("share that is fluid before the lamp is on", float(before), None, 0.0, "a count"),
            ("share of the dark end that is fluid at any time", float(dark), None, 0.0, "a count"),
            (
                "share of the lit end that is fluid at the end",
                float(series["fluid_lit"][-1]),
                1.0,
                0.7,
                "at least 0.3; how much melts by then follows from the power",
            ),
        ]
        if self.lamp_height <= 1.0 and start + 1 < len(series["time"]):
            found = float(series["heating"][start + 1] / (self.power * FOOT**2))
            reason = "the block has sunk a little, and its edge is as rough as particles are"
            rows.append(("share of the power that the block takes at first", found, self.share_of_rays, 0.02, reason))
        return [
            Check(
                self.name, f"{what}, {size}", "", found, reference, allowed, self.source, relative=False, reason=reason
            )
            for what, found, reference, allowed, reason in rows
        ]

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """A small block, and one of 10 000 particles."""
        small = cls(columns=60, rows=20, settling=2.0, duration=10.0, lamp_distance=15.0)
        cases = [small, cls()] if slow else [small]
        for case in cases:
            yield from case.checks(simulate(case))

    def _observer(self, table: Table) -> Observe:
        x = table.places[:, 0] / self.size[0]
        ends = {"lit": x < -0.5 + ENDS, "dark": x > 0.5 - ENDS}

        def observe(state: Snapshot, time: float) -> Values:
            fluid = state["phase"] == Phase.LIQUID
            energy = 0.5 * state["mass"] * np.sum(state["precise_velocity"] ** 2, axis=1)
            values: Values = {
                "fluid": Measured(float(np.mean(fluid)), "", "share of the particles that is fluid"),
                "seen": Measured(float(np.sum(state["light"] > 0.0)), "", "particles that the lamp sees"),
                "heating": Measured(float(np.sum(state["light"])), "W", "heat taken from the lamp", per_depth=True),
            }
            for name, chosen in ends.items():
                share, mean = float(np.mean(fluid[chosen])), float(np.mean(energy[chosen]))
                label = f"of the tenth that began at the {name} end"
                values[f"fluid_{name}"] = Measured(share, "", label, panel="share that is fluid")
                values[f"energy_{name}"] = Measured(mean, "J", label, panel="mean kinetic energy of a particle")
            return values

        return observe
