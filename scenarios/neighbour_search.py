"""Drifting particles whose neighbour list is compared with all pairs."""

from collections.abc import Callable, Iterable
from typing import Literal

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import inert
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.kernels.neighbours.pairs import NeighbourList
from warpsph.run.simulation import Result, Simulation

SPACING = 0.01  # [m]


class NeighbourSearch(Scenario):
    """Free particles with random velocities in a square or a cube; the list is renewed many times on the way."""

    name = "neighbour_search"
    summary = "drifting particles whose neighbour list is compared with all pairs"
    source = "brute force over all pairs"

    duration: float = parameter(1.0, "s", "physical time to simulate", gt=0, le=100.0)
    output_interval: float = parameter(0.1, "s", "physical time between two comparisons", gt=0, le=100.0)
    dimension: Literal[2, 3] = parameter(2, "", "2 for the plane, 3 for space")
    arrangement: Literal["random", "lattice", "coincident"] = parameter(
        "random", "", "places at the start; coincident: every tenth particle sits on another"
    )
    count: int = parameter(2000, "", "number of particles, about", ge=2, le=4000)
    centre: float = parameter(-3.0, "m", "coordinate of the centre, on each axis", ge=-100.0, le=100.0)
    speed: float = parameter(0.01, "m/s", "standard deviation of the velocities, on each axis", ge=0.0, le=1.0)
    seed: int = parameter(1, "", "of the random numbers", ge=0)

    def build(self, executor: Executor) -> Simulation:
        model = Model(
            dimension=self.dimension,
            spacing=SPACING,
            materials=(inert("marker", density=1000.0),),
            gravity=(0.0, 0.0, 0.0),
        )
        random = np.random.default_rng(self.seed)
        position = self._places(random)
        velocity = self.speed * random.standard_normal(position.shape)
        velocity[:, self.dimension :] = 0.0
        particles = Particles()
        particles.add(position, Role.FREE, velocity=velocity)
        simulation = Simulation(executor, model, particles, dt=0.01, observe=lambda state, time: compare(simulation))
        return simulation

    def _places(self, random: np.random.Generator) -> np.ndarray:
        cells = max(round(self.count ** (1.0 / self.dimension)), 1)
        low, high = self.centre - 0.5 * cells * SPACING, self.centre + 0.5 * cells * SPACING
        places = lattice((low,) * self.dimension, (high,) * self.dimension, SPACING)
        if self.arrangement == "random":
            places[:, : self.dimension] = random.uniform(low, high, (len(places), self.dimension))
        if self.arrangement == "coincident":
            doubled = places[1::10]
            doubled[:] = places[:-1:10][: len(doubled)]
        return places

    def checks(self, result: Result) -> list[Check]:
        series = result.diagnostics
        where = f"{self.arrangement}, {self.dimension}D, {len(result.positions)} particles"
        return [
            Check(
                self.name,
                f"{quantity} in {len(series['time'])} comparisons ({where})",
                "",
                float(series[key].sum()),
                None,
                0.0,
                self.source,
                reason="a list is right or wrong",
            )
            for key, quantity in (("missing", "pairs missing"), ("wrong", "entries twice or of no neighbour"))
        ]

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Every arrangement in the plane and in space, far on the negative side; and random across the origin."""
        for dimension in (2, 3):
            for arrangement in ("random", "lattice", "coincident"):
                scenario = cls(dimension=dimension, arrangement=arrangement)
                yield from scenario.checks(simulate(scenario))
        scenario = cls(centre=0.0)
        yield from scenario.checks(simulate(scenario))


def compare(simulation: Simulation) -> dict[str, float]:
    """Count pairs inside the support that the list misses, and entries that are not as brute force finds them.

    A list holds the pairs that were closer than its radius when it was made; it must hold each of them once, and until
    it is renewed, every pair inside the support.
    """
    neighbours = simulation.solver.neighbours
    neighbours.renew_if_outdated()
    listed = as_matrix(neighbours.list)
    oneself = np.eye(len(listed), dtype=bool)
    now = _distances(simulation.state.numpy("position"))
    then = _distances(neighbours.reference.numpy())
    rounding = 4.0 * np.spacing(np.abs(neighbours.reference.numpy()).max())
    needed = (now < simulation.model.support - rounding) & ~oneself
    surely_in = (then < neighbours.radius - rounding) & ~oneself
    surely_out = (then > neighbours.radius + rounding) | oneself
    return {
        "pairs": float(np.sum(needed)),
        "missing": float(np.sum((needed | surely_in) & (listed == 0))),
        "wrong": float(np.sum(listed > 1) + np.sum(surely_out & (listed > 0))),
        "renewals": float(neighbours.renewals.numpy()[0]),
    }


def as_matrix(rows: NeighbourList) -> np.ndarray:
    """How often each particle (row) lists each other one (column)."""
    count = rows.count.numpy()
    i = np.repeat(np.arange(len(count)), count)
    k = np.concatenate([np.arange(m) for m in count])
    listed = np.zeros((len(count),) * 2, int)
    np.add.at(listed, (i, rows.entry.numpy()[i * rows.row_stride + k * rows.entry_stride]), 1)
    return listed


def _distances(x: np.ndarray) -> np.ndarray:
    x = x.astype(float)
    return np.sqrt(sum((x[:, None, axis] - x[None, :, axis]) ** 2 for axis in range(3)))
