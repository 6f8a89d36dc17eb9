"""Tait's equation of state on the host: Vijaykumar (1.5), as the kernels have it."""

import numpy as np

from warpsph.kernels.flow.equation_of_state import GAMMA

Number = float | np.ndarray


def stiffness(reference_density: float, sound_speed: float) -> float:
    """c_s^2 rho_0 / gamma [Pa]."""
    return sound_speed**2 * reference_density / GAMMA


def pressure_of_density(density: Number, reference_density: float, sound_speed: float) -> Number:
    """Pressure [Pa] of a density [kg/m^3]."""
    return stiffness(reference_density, sound_speed) * ((density / reference_density) ** GAMMA - 1.0)


def density_of_pressure(pressure: Number, reference_density: float, sound_speed: float) -> Number:
    """Density [kg/m^3] at a pressure [Pa]."""
    excess = pressure / stiffness(reference_density, sound_speed)
    return reference_density * (1.0 + excess) ** (1.0 / GAMMA)
