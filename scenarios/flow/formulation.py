"""The formulations of flow that a case can choose from, and what particles start with in each."""

from enum import StrEnum

import numpy as np

from warpsph.core.equation_of_state import density_of_pressure
from warpsph.core.state import Snapshot
from warpsph.core.term import Term
from warpsph.kernels.flow.equation_of_state import GAMMA
from warpsph.run.result import Result
from warpsph.terms import ContinuityDensity, CorrectedFluid, DeltaFluid, Fluid, SummedDensity


class Formulation(StrEnum):
    """By the names that a case gives."""

    CORRECTED = "corrected"
    DELTA = "delta"
    SUMMED = "summed"
    CONTINUITY = "continuity"

    def terms(self, density: float, sound_speed: float, free_surface: bool = False, viscous: bool = True) -> list[Term]:
        """The terms of the flow.

        Args:
            density: reference density [kg/m^3].
            sound_speed: [m/s].
            free_surface: whether there is one.
            viscous: whether the fluid has a viscosity; classic delta-SPH then needs no artificial one.
        """
        if self is Formulation.CORRECTED:
            return [CorrectedFluid(density, sound_speed, free_surface)]
        if self is Formulation.DELTA:
            return [DeltaFluid(density, sound_speed, free_surface, artificial_viscosity=0.0 if viscous else 0.02)]
        kind = ContinuityDensity if self is Formulation.CONTINUITY else SummedDensity
        return [Fluid(density, sound_speed, tension=not free_surface), kind()]

    def start(self, pressure: np.ndarray, density: float, sound_speed: float) -> dict[str, np.ndarray]:
        """Fields of particles that start at a pressure (n,) [Pa]; arguments as of :meth:`terms`."""
        if self in (Formulation.CORRECTED, Formulation.DELTA):
            return {"compression": pressure / (density * sound_speed**2), "pressure": pressure}
        return {"density": np.asarray(density_of_pressure(pressure, density, sound_speed))}

    def elastic_energy(self, state: Snapshot, density: float, sound_speed: float, free_surface: bool = False) -> float:
        """Work [J] of the pressure on the fluid, per metre of depth in the plane; arguments as of :meth:`terms`."""
        r = state["density"].astype(float) / density
        if self in (Formulation.CORRECTED, Formulation.DELTA):
            work = np.log(r) + 1.0 / r - 1.0
        else:
            r = np.maximum(r, 1.0) if free_surface else r  # without tension there is no pressure below
            work = ((r ** (GAMMA - 1.0) - 1.0) / (GAMMA - 1.0) + 1.0 / r - 1.0) / GAMMA
        return float(sound_speed**2 * np.sum(state["mass"] * work))


def disordered(points: np.ndarray, spacing: float, dimension: int, share: float = 0.1) -> np.ndarray:
    """Places (n, 3) [m] moved by up to ``share`` of the spacing along each axis, the same in every run.

    The centre of all stays where it is.
    """
    way = np.random.default_rng(1).uniform(-share, share, points.shape) * spacing
    way[:, dimension:] = 0.0
    return points + way - way.mean(axis=0)


def gained_momentum(result: Result) -> float:
    """Largest change of the momentum in the plane since the start, in the unit of its diagnostics."""
    momentum = np.column_stack([result.diagnostics["momentum_x"], result.diagnostics["momentum_y"]])
    return float(np.linalg.norm(momentum - momentum[0], axis=1).max())
