"""Numbers that every run keeps over time, taken from a copy of the state on the host."""

import numpy as np

from warpsph.core.labels import Phase, Role
from warpsph.core.state import Snapshot
from warpsph.kernels.basics.roles import FLUID_ROLES
from warpsph.run.measured import Measured, Values
from warpsph.terms.elasticity import Elasticity


def common_diagnostics(state: Snapshot) -> Values:
    """Kinetic energy, highest speed, over particles that move, and with a fluid the range of density over those that
    are not solid; not a number where there are none.
    """
    moving = np.isin(state["role"], FLUID_ROLES)
    speed_squared = np.sum(state["velocity"][moving].astype(float) ** 2, axis=1)
    energy = 0.5 * float(np.sum(state["mass"][moving] * speed_squared))
    values: Values = {
        "kinetic_energy": Measured(energy, "J", "kinetic energy", per_depth=True),
        "highest_speed": Measured(float(np.sqrt(np.max(speed_squared, initial=0.0))), "m/s", "highest speed"),
    }
    if "density" in state:
        flowing = state["density"][moving & (state["phase"] != Phase.SOLID)]
        lowest, highest = (float(flowing.min()), float(flowing.max())) if len(flowing) else (np.nan, np.nan)
        values["density_min"] = Measured(lowest, "kg/m^3", "lowest", panel="density")
        values["density_max"] = Measured(highest, "kg/m^3", "highest", panel="density")
    return values


def strain_energy(state: Snapshot, elasticity: Elasticity) -> Measured:
    """Elastic energy of all solid particles, without that of the hourglass control (Vijaykumar 2012, (4.12))."""
    lame_lambda, lame_mu = elasticity.lame
    solid = state["phase"] == Phase.SOLID
    F = state["deformation"][solid].astype(float)
    strain = 0.5 * (np.einsum("nki,nkj->nij", F, F) - np.eye(3))
    density = lame_mu * np.sum(strain**2, axis=(1, 2)) + 0.5 * lame_lambda * np.trace(strain, axis1=1, axis2=2) ** 2
    energy = float(np.sum(state["body_volume"][solid] * density))
    return Measured(energy, "J", "elastic energy", per_depth=True)


def enthalpy_by_material(state: Snapshot, materials: int) -> np.ndarray:
    """Enthalpy [J] of the particles that take part, by material (per metre of depth in 2D)."""
    taking_part = state["role"] != Role.RESERVOIR
    content = state["mass"].astype(float) * state["enthalpy"]
    return np.bincount(state["material"][taking_part], content[taking_part], materials)
