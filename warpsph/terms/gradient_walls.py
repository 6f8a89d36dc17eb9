"""Walls of heat without images: particles on them take the temperature that their gradient asks for."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsph.core.content import Content
from warpsph.core.field import Field
from warpsph.core.labels import Role
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.periodic import axes_across
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, require
from warpsph.kernels.heat.gradient_walls import BIND_SURFACE, FIND_SURFACE, GradientPlanes, set_surface
from warpsph.terms.conduction import MOST_WALLS, Conduction
from warpsph.terms.heat_wall import SLACK, HeatWall

SWEEPS = 4  # where walls meet, particles on them see each other: what is left of a change falls to a fifth in each


@dataclass(frozen=True, eq=False)
class GradientWalls(Term):
    """Films, fluxes and insulation by the gradient on one side (Rook, Yildiz & Dost 2007, section 4.2).

    Particles that stand on the walls have no heat of their own. After each step with heat they take the temperature at
    which twice their one-sided gradient along the normal, equation (9), is that of the flux that leaves; in a corner
    the sum of the gradients is that of the sum of the fluxes. To the particles before them they are neighbours like
    others, with whole cells, and behind them is nothing. First order in the spacing: the walls of
    :class:`~warpsph.terms.Conduction`, with images, are second order.

    An implicit integrator of the conduction has these conditions among its rows, which makes them unsymmetric.

    The particles on the walls are ``held``; what their neighbours give them has left the body and stands in
    ``heat_held``. One that is held already, in a corner with a given temperature, stays so.

    Args:
        walls: of films, given flux or insulation; a row stands on each. Walls of the conduction that have images stay a
            support away.
    """

    walls: Sequence[HeatWall]

    def __post_init__(self) -> None:
        several = isinstance(self.walls, Sequence) and 0 < len(self.walls) <= MOST_WALLS
        whole = several and all(isinstance(wall, HeatWall) for wall in self.walls)
        require(self, "walls", whole, f"a tuple of one HeatWall or more, up to {MOST_WALLS}")
        if any(np.isinf(wall.conductance) for wall in self.walls):
            raise InputError("GradientWalls: walls: one gives the temperature; hold the particles on it instead")
        if any(wall.profiles for wall in self.walls):
            raise InputError("GradientWalls: walls: one has a profile, which only the walls of Conduction follow")

    needs = ("conduction",)

    held = Conduction.held
    on_gradient_walls = Field(int, "", "on which walls without images a particle stands, a bit each")
    surface_temperature = Field(float, "K", "temperature by the gradient on a wall", kept=False)

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        x = particles.position
        there = (particles.role != Role.RESERVOIR) & (fields["held"] == 0)
        on = np.zeros(len(x), int)
        for p, wall in enumerate(self.walls):
            standing = there & (np.abs(wall.height(x)) < SLACK * model.spacing)
            if not np.any(standing):
                raise InputError(f"GradientWalls: no particle stands on wall {p}; a row must, and none that is held")
            on[standing] |= 1 << p
        conduction = model.the(Conduction)
        support = conduction.lattice(model).support
        for wall in conduction.walls:
            if np.any(np.abs(wall.height(x[on != 0])) < support):
                raise InputError(
                    f"GradientWalls: a wall of Conduction is nearer than the support, {support:.4g} m; walls that meet "
                    "are all of one kind"
                )
        return {"on_gradient_walls": on, "held": (fields["held"] != 0) | (on != 0)}

    def bounded_axes(self, model: Model) -> tuple[int, ...]:
        return axes_across(*(wall.normal for wall in self.walls))

    def contents(self, model: Model, state: State) -> dict[str, Content]:
        """The heat of the body, without the particles on the walls, which have none of their own."""
        body = (state.numpy("role") != Role.RESERVOIR) & (state.numpy("on_gradient_walls") == 0)
        return {"heat": model.the(Conduction).heat_of(state, body)}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        conduction = model.the(Conduction)
        table, smoothing = conduction.constants(model, state)["table"], conduction.smoothing
        planes: Any = GradientPlanes()
        planes.normal = wp.array([wall.normal for wall in self.walls], dtype=wp.vec3, device=state.device)
        for name in ("conductance", "outside", "flux"):
            given = [getattr(wall, name) for wall in self.walls]
            setattr(planes, name, wp.array(given, dtype=float, device=state.device))
        if conduction.implicit is not None:
            conduction.implicit.bind(lambda launch: launch(BIND_SURFACE[smoothing], gradient_planes=planes))
        return {"gradient_planes": planes, "table": table, "smoothing": smoothing}

    def find_temperature(self, launch: Launch) -> None:
        for _ in range(SWEEPS):
            launch(FIND_SURFACE[launch.find("smoothing")])
            launch(set_surface)
