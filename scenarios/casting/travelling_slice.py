"""Heat of a thin horizontal slice that travels down with the strand: one-dimensional conduction from the wall."""

from collections.abc import Callable

import numpy as np

from warpsph.core.materials import Material
from warpsph.errors import InputError

STABLE = 0.4  # step over the square of a cell's edge, times the diffusivity
MOST_STEPS = 100_000  # some ten seconds
FEWEST_CELLS = 10


def cool_slice(
    steel: Material,
    width: float,
    temperature: float,
    ages: np.ndarray,
    surface_flux: Callable[[float, float], float],
    spacing: float,
) -> np.ndarray:
    """Temperature of slices of stagnant melt at several ages, by explicit conduction in enthalpy.

    Args:
        steel: material; its conductivity is interpolated in the solid fraction.
        width: from the insulated axis to the cooled surface [m].
        temperature: of the melt at age 0 [K].
        ages: (k,) times since the meniscus [s], rising.
        surface_flux: heat flux [W/m^2] out of the surface from its temperature [K] and the age [s].
        spacing: of the cells [m]; they are larger where so small ones would need more than ``MOST_STEPS``.

    Returns:
        (k, cells) temperatures [K], the first cell at the axis.

    Raises:
        InputError: heat passes through the whole slice long before the last age.
    """
    capacity = np.min(np.diff(steel.enthalpies) / np.diff(steel.temperatures))
    diffusivity = max(steel.conductivity_solid, steel.conductivity_liquid) / (steel.density * capacity)
    finest = float(np.sqrt(np.max(ages) * diffusivity / (STABLE * MOST_STEPS)))
    if finest > width / FEWEST_CELLS:
        raise InputError(
            f"casting_speed: in {np.max(ages):.3g} s on its way through the machine a strand of half_width {width:g} m "
            f"loses all its heat, by a diffusivity up to {diffusivity:.3g} m^2/s; cast faster, or take a lower "
            "melt_conductivity or a higher density"
        )
    cells = max(round(width / max(spacing, finest)), 2)
    dx = width / cells
    enthalpy = np.full(cells, float(steel.enthalpy(temperature)))
    dt = STABLE * dx**2 / diffusivity
    profiles, age = np.empty((len(ages), cells)), 0.0
    for k, target in enumerate(ages):
        steps = max(int(np.ceil((target - age) / dt)), 1)
        step = (target - age) / steps
        for _ in range(steps):
            T = steel.temperature(enthalpy)
            solid = steel.solid_fraction(T)
            kappa = solid * steel.conductivity_solid + (1.0 - solid) * steel.conductivity_liquid
            between = 2.0 * kappa[1:] * kappa[:-1] / (kappa[1:] + kappa[:-1])
            flux = np.zeros(cells + 1)
            flux[1:-1] = -between * np.diff(T) / dx
            flux[-1] = surface_flux(T[-1], age)
            enthalpy -= step * np.diff(flux) / (steel.density * dx)
            age += step
        profiles[k] = steel.temperature(enthalpy)
    return profiles


def shell_thickness(profile: np.ndarray, steel: Material, width: float, threshold: float) -> float:
    """Thickness [m] of the layer at the surface whose solid fraction is above ``threshold``, interpolated."""
    solid = steel.solid_fraction(profile)
    cells = len(profile)
    dx = width / cells
    centres = (np.arange(cells) + 0.5) * dx
    liquid = np.flatnonzero(solid <= threshold)
    if len(liquid) == 0:
        return width
    last = liquid[-1]
    if last == cells - 1:
        return 0.0
    share = (threshold - solid[last]) / (solid[last + 1] - solid[last])
    return width - (centres[last] + share * dx)
