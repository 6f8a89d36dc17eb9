"""Numbers that every run keeps over time, taken from a copy of the state on the host."""

import numpy as np

from warpsph.core.labels import Phase, Role
from warpsph.core.model import Elasticity

Snapshot = dict[str, np.ndarray]


def common_diagnostics(state: Snapshot) -> dict[str, float]:
    """Kinetic energy [J], highest speed [m/s], over particles that move, and with a fluid the range of density
    [kg/m^3] over those that are not solid. Per metre of depth in 2D.
    """
    moving = np.isin(state["role"], (Role.FREE, Role.INFLOW, Role.OUTFLOW))
    if not np.any(moving):
        return {}
    speed_squared = np.sum(state["velocity"][moving].astype(float) ** 2, axis=1)
    values = {
        "kinetic_energy": 0.5 * float(np.sum(state["mass"][moving] * speed_squared)),
        "highest_speed": float(np.sqrt(np.max(speed_squared))),
    }
    flowing = moving & (state["phase"] != Phase.SOLID)
    if "density" in state and np.any(flowing):
        values["density_min"] = float(np.min(state["density"][flowing]))
        values["density_max"] = float(np.max(state["density"][flowing]))
    return values


def strain_energy(state: Snapshot, elasticity: Elasticity) -> float:
    """Elastic energy [J] of all solid particles, without that of the hourglass control (Vijaykumar 2012, (4.12)).

    Per metre of depth in 2D.
    """
    lame_lambda, lame_mu = elasticity.lame
    solid = state["phase"] == Phase.SOLID
    F = state["deformation"][solid].astype(float)
    strain = 0.5 * (np.einsum("nki,nkj->nij", F, F) - np.eye(3))
    density = lame_mu * np.sum(strain**2, axis=(1, 2)) + 0.5 * lame_lambda * np.trace(strain, axis1=1, axis2=2) ** 2
    return float(np.sum(state["body_volume"][solid] * density))


def enthalpy_by_material(state: Snapshot, materials: int) -> np.ndarray:
    """Enthalpy [J] of the particles that take part, by material (per metre of depth in 2D)."""
    taking_part = state["role"] != Role.RESERVOIR
    content = state["mass"].astype(float) * state["enthalpy"]
    return np.bincount(state["material"][taking_part], content[taking_part], materials)
