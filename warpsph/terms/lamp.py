"""A lamp that heats what it can see."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Field, Value
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, numbers, require
from warpsph.kernels.particles.radiation import LampConstants, clear_rays, meet_particles, own_rays, take_light, warm_up


@dataclass(frozen=True, eq=False)
class Lamp(Term):
    """Rays to all sides of the plane, each of which heats the first particle that it meets.

    Args:
        position: (3,) [m].
        power: of all rays [W/m].
        radius: of a particle, as rays see it [m].
        rays: their number; enough of them meet the farthest particle that matters.
        begin: when it is switched on [s].
    """

    position: Sequence[float]
    power: float
    radius: float
    rays: int = 8192
    begin: float = 0.0

    def __post_init__(self) -> None:
        require(self, "position", bool(np.all(np.isfinite(numbers(self.position, 3)))), "three numbers [m]")
        for name in ("power", "begin"):
            require(self, name, 0.0 <= number(getattr(self, name)) < np.inf, "zero or positive")
        require(self, "radius", 0.0 < number(self.radius) < np.inf, "positive [m]")
        require(self, "rays", isinstance(self.rays, int) and 8 <= self.rays <= 2**24, "a whole number from 8 to 2^24")

    provides = ("the light that particles take",)  # of one lamp; a second one would overwrite it
    needs = ("precise motion",)

    light = Field(float, "W", "heat taken from the lamp", written=True, colours="inferno")
    met = Value(
        wp.float64,
        "m",
        "distance at which each ray meets something",
        start=lambda term: np.zeros(term.rays),
        scratch=True,
    )

    owner = Value(
        int, "", "id of the particle that each ray meets", start=lambda term: np.zeros(term.rays), scratch=True
    )

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        if model.dimension != 2:
            raise InputError("Lamp: its rays lie in the plane; give it to a model of two dimensions")
        return {}

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return (0, 1, 2)

    def constants(self, model: Model, state: State) -> dict[str, object]:
        lamp = LampConstants()
        lamp.place = wp.vec3d(*self.position)
        lamp.rays, lamp.radius = self.rays, wp.float64(self.radius)
        lamp.power, lamp.begin = wp.float64(self.power / self.rays), wp.float64(self.begin)
        return {"lamp": lamp}

    def find_density(self, launch: Launch) -> None:
        """Where the rays end; one thread of a CPU does it, because several particles are in the way of a ray."""
        launch.whole(clear_rays, self.rays)
        launch.whole(meet_particles, launch.count)
        launch.whole(own_rays, launch.count)

    def sum_forces(self, launch: Launch) -> None:
        launch(take_light)

    def kick(self, launch: Launch) -> None:
        launch(warm_up)
