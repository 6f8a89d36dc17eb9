"""Point sources and sinks of heat."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsph.core.field import Value
from warpsph.core.labels import Role
from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError, number, numbers, require
from warpsph.kernels.heat.sources import ADD_HEAT_OF_SOURCES, PARTS, WEIGH_PARTS, add_parts, count_heat_of_sources
from warpsph.terms.conduction import Conduction


@dataclass(frozen=True)
class PointSource:
    """Heat that comes from a place.

    Args:
        position: (3,) [m].
        strength: [W], or [W/m] in 2D; negative for a sink.
    """

    position: Sequence[float]
    strength: float

    def __post_init__(self) -> None:
        require(self, "position", bool(np.all(np.isfinite(numbers(self.position, 3)))), "three numbers [m]")
        require(self, "strength", bool(np.isfinite(number(self.strength))), "a number [W, or W/m in 2D]")


@dataclass(frozen=True, eq=False)
class HeatSources(Term):
    """Point sources and sinks, smoothed as the conduction is (Monaghan, Huppert & Worster 2005, section 2.2).

    Args:
        sources: one or more.

    ``strength`` (sources,) is a device array that may be changed during a run.
    """

    sources: Sequence[PointSource]

    def __post_init__(self) -> None:
        several = isinstance(self.sources, Sequence) and len(self.sources) > 0
        whole = several and all(isinstance(source, PointSource) for source in self.sources)
        require(self, "sources", whole, "a tuple of one PointSource or more")

    needs = ("conduction",)
    follows = ("conduction",)

    source_position = Value(
        wp.vec3, "m", "where the sources are", start=lambda term: [source.position for source in term.sources]
    )
    strength = Value(
        float, "W", "strength (per metre of depth in 2D)", start=lambda term: [s.strength for s in term.sources]
    )
    heat_given = Value(
        wp.float64, "J", "heat given so far (per metre of depth in 2D)", start=lambda term: np.zeros(len(term.sources))
    )
    source_weight = Value(
        float, "", "sum of V W around a source", start=lambda term: np.zeros(len(term.sources)), scratch=True
    )
    source_parts = Value(
        float, "", "pieces of that sum", start=lambda term: np.zeros(len(term.sources) * PARTS), scratch=True
    )

    def start(self, model: Model, particles: Particles, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        there = particles.position[particles.role != Role.RESERVOIR]
        support = model.the(Conduction).lattice(model).support
        for source in self.sources:
            way = there - np.asarray(source.position, float)
            if model.periodic is not None:
                way = model.periodic.nearest(way)
            if not np.any(np.linalg.norm(way, axis=1) < support):
                place = ", ".join(f"{x:g}" for x in source.position)
                raise InputError(f"HeatSources: no particle within {support:.4g} m of the source at ({place}) m")
        return {}

    def gains(self, state: State) -> dict[str, dict[str, float | np.ndarray]]:
        return {"heat": {"sources": float(np.sum(self.heat_given.numpy()))}}

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"support": model.the(Conduction).lattice(model).support, "smoothing": model.the(Conduction).smoothing}

    def sum_heat(self, launch: Launch) -> None:
        smoothing, sources = launch.find("smoothing"), len(self.sources)
        launch(WEIGH_PARTS[smoothing], sources * PARTS)
        launch(add_parts, sources)
        launch(ADD_HEAT_OF_SOURCES[smoothing])

    def add_heat(self, launch: Launch) -> None:
        launch(count_heat_of_sources, len(self.sources))
