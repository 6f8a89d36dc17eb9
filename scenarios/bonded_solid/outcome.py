"""What has become of a solid of particles, in the units and by the numbers of the paper."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from warpsph.cases.check import Check
from warpsph.run.result import Result
from warpsph.scenarios.bonded_solid.particle_solid import FOOT
from warpsph.scenarios.bonded_solid.tables import Table


@dataclass(frozen=True)
class Outcome:
    """A finished run.

    Attributes:
        result: what the run left.
        table: the solid that it began with.
    """

    result: Result
    table: Table

    @property
    def places(self) -> np.ndarray:
        """Places (n, 2) at the end [ft]."""
        return self.result.fields["precise_position"][:, :2] / FOOT

    @property
    def most_fluid(self) -> float:
        """Largest number of particles that are fluid at a time."""
        return float(self.result.diagnostics["fluid"].max())

    @property
    def fluid_at_end(self) -> float:
        """Number of particles that are fluid at the end."""
        return float(self.result.diagnostics["fluid"][-1])

    @property
    def first_fluid_time(self) -> float:
        """Time [s] at which a particle is found to be fluid for the first time; not a number where none is."""
        frames = np.flatnonzero(self.result.diagnostics["fluid"] > 0)
        return float(self.result.diagnostics["time"][frames[0]]) if len(frames) else np.nan

    @property
    def first_fluid(self) -> list[int]:
        """Numbers of the particles that are fluid at that time, from 1 on."""
        frames = np.flatnonzero(self.result.diagnostics["fluid"] > 0)
        return list(np.flatnonzero(self.result.diagnostics["is_fluid"][frames[0]]) + 1) if len(frames) else []

    @property
    def asymmetry(self) -> float:
        """Largest distance [ft] between a particle and the mirror image of its partner at the end."""
        mirrored = self.places[self.table.partners] * (-1.0, 1.0)
        return float(np.linalg.norm(self.places - mirrored, axis=1).max())

    @property
    def kinetic_energy(self) -> np.ndarray:
        """Kinetic energy of all particles at all times [kg ft^2/s^2]."""
        return self.result.diagnostics["kinetic_energy"] / FOOT**2

    @property
    def hottest_at_end(self) -> float:
        """Highest mean kinetic energy of a particle at the end [kg ft^2/s^2]."""
        return float(self.result.diagnostics["hottest"][-1]) / FOOT**2

    def place(self, number: int) -> np.ndarray:
        """Place (2,) of a particle at the end [ft]; numbers begin with 1."""
        return self.places[number - 1]

    def bonded_to(self, number: int, bond: float) -> set[int]:
        """Numbers of the particles closer than ``bond`` [ft] to one at the end."""
        distance = np.linalg.norm(self.places - self.place(number), axis=1)
        return set((np.flatnonzero(distance < bond) + 1).tolist()) - {number}

    def flows_apart(self, distance: float) -> bool:
        """Whether particles have gone farther than ``distance`` [ft] to both sides at the end."""
        x = self.places[:, 0]
        return bool(x.min() < -distance and x.max() > distance)


def check_unheated(name: str, outcome: Outcome, steps: str) -> Iterable[Check]:
    """A solid without heat stays what it is."""
    for quantity, measured, tolerance, source, reason in (
        ("particles that are fluid at any time", outcome.most_fluid, 0.0, "the published solids are solid", "a count"),
        (
            "distance from mirror symmetry [ft]",
            outcome.asymmetry,
            1e-9,
            "mirror symmetry",
            "rounding at the 16th digit, which the solid hardly enlarges",
        ),
    ):
        what = f"{quantity}, {steps} steps without heat"
        yield Check(name, what, "", measured, None, tolerance, source, reason=reason)
