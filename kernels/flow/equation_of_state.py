"""Tait's equation of state."""

import warp as wp

wp.set_module_options({"enable_backward": False})

GAMMA = 7.0  # the power of the density, which tait_pressure multiplies out


@wp.func
def tait_pressure(density: float, reference_density: float, stiffness: float) -> float:
    """Pressure [Pa] of a density [kg/m^3]; ``stiffness`` is c_s^2 rho_0 / gamma [Pa]."""
    ratio = density / reference_density
    ratio_3 = ratio * ratio * ratio
    return stiffness * (ratio_3 * ratio_3 * ratio - 1.0)  # Vijaykumar (1.5)
