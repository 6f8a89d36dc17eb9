"""Limits of the time step, each with its reason."""

import numpy as np

from warpsph.core.materials import Material
from warpsph.core.model import Model


def time_step_limits(model: Model, moving: tuple[int, ...]) -> dict[str, float]:
    """Largest stable steps [s] of the flow and of elastic solids by reason.

    ``moving`` are the indices of the materials that move. Vijaykumar (2012), equation (7.6) with h = H/2, because the
    formula comes from a kernel with support 2h; and the elastic wave, to which the sound of the melt adds, across
    half a spacing, because bonds may be shorter than the spacing. The shortest capillary wave as in Morris (2000).
    """
    limits = {}
    if model.fluid is not None:
        h = 0.5 * model.support
        viscosity = max((model.materials[m].viscosity for m in moving), default=0.0)
        drag = 2.0 * 4.9633 * viscosity / (h * model.fluid.reference_density)
        limits["sound and viscosity (7.6)"] = 0.5 * h / (model.fluid.sound_speed + drag)
        if model.surface_tension is not None:
            inertia = model.fluid.reference_density * h**3 / (2.0 * np.pi * model.surface_tension.coefficient)
            limits["surface tension"] = 0.25 * float(np.sqrt(inertia))
    if model.elasticity is not None:
        if model.fluid is not None:
            wave = np.hypot(model.elasticity.wave_speed(model.fluid.reference_density), model.fluid.sound_speed)
        else:
            wave = max(model.elasticity.wave_speed(model.materials[m].density) for m in moving)
        limits["elastic wave"] = 0.5 * model.spacing / wave
    return limits


def conduction_limits(model: Model) -> dict[str, float]:
    """Largest stable conduction steps [s] by pair of materials, and the longest interval asked for.

    Vijaykumar (2012), equation (7.7) with zeta = 0.1 and the support H, for the conductivity that the pair has.
    """
    limits = {"longest interval": model.conduction.longest_interval}
    for a, material in enumerate(model.materials):
        capacity = float(np.min(np.diff(material.enthalpies) / np.diff(material.temperatures)))
        for b, other in enumerate(model.materials):
            conductivity = model.conduction.contact.get((min(a, b), max(a, b)))
            if conductivity is None:
                conductivity = _harmonic(_highest_conductivity(material), _highest_conductivity(other))
            if conductivity > 0.0:
                limits[f"conduction {material.name}-{other.name} (7.7)"] = (
                    0.1 * material.density * capacity * model.support**2 / conductivity
                )
    return limits


def _highest_conductivity(material: Material) -> float:
    return max(material.conductivity_solid, material.conductivity_liquid)


def _harmonic(a: float, b: float) -> float:
    return 2.0 * a * b / (a + b) if a + b > 0.0 else 0.0
