"""The constants of the weakly compressible fluid, and its pressure."""

import warp as wp

from warpsph.kernels.flow.equation_of_state import tait_pressure

wp.set_module_options({"enable_backward": False})


@wp.struct
class FluidConstants:
    """Constants of the weakly compressible fluid.

    ``support`` H [m]; ``density_scale`` normalisation of the density's smoothing kernel; ``reference_density`` rho_0
    [kg/m^3]; ``stiffness`` c_s^2 rho_0 / gamma [Pa]; ``lowest_pressure`` [Pa], 0 where tension is forbidden;
    ``pressure_scale`` and ``viscosity_scale`` normalisations of the pressure and viscosity sums; ``bond_damping``, by
    which viscosity along the line of two particles alone damps shear as much as all of it does.
    """

    support: float
    density_scale: float
    reference_density: float
    stiffness: float
    lowest_pressure: float
    pressure_scale: float
    viscosity_scale: float
    bond_damping: float


@wp.func
def pressure_of(fluid: FluidConstants, density: float) -> float:
    """Pressure [Pa] of a density [kg/m^3], not below the lowest one."""
    return wp.max(tait_pressure(density, fluid.reference_density, fluid.stiffness), fluid.lowest_pressure)
