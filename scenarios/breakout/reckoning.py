"""Whether a shell remelts without water: the heat of the melt against the heat of the shell, in one dimension."""

import numpy as np

from warpsph.scenarios.casting.parameters import CastingParameters
from warpsph.scenarios.casting.travelling_slice import cool_slice, shell_thickness

CELL = 2.0e-3  # [m]
LAYERS = 2.5  # layers of particles that the thinnest shell must have to bear the melt between two rolls


def shell_of_slice(case: CastingParameters, start: float | None, times: np.ndarray) -> np.ndarray:
    """Thickness [m] of the shell of a slice of stagnant melt at some ``times`` [s].

    Args:
        case: the machine.
        start: height [m] at which the slice is when the sprays fail; none for sprays that stay on.
        times: since the failure, or else since the slice left the meniscus.
    """
    age = 0.0 if start is None else (case.level - start) / case.casting_speed

    def surface_flux(temperature: float, since_meniscus: float) -> float:
        height = case.level - case.casting_speed * since_meniscus
        failed = start is not None and since_meniscus >= age and case.zone_at(height) in case.spray_failing
        return 0.0 if failed else case.surface_flux(temperature, since_meniscus)

    profiles = cool_slice(case.steel, case.half_width, case.pouring_temperature, age + times, surface_flux, CELL)
    return np.array([shell_thickness(profile, case.steel, case.half_width, 0.5) for profile in profiles])


def thinnest_shell(case: CastingParameters) -> float:
    """Thinnest shell [m] between mould and outflow with all sprays on."""
    heights = np.linspace(case.mould_bottom, 0.0, 9)
    return float(np.min(shell_of_slice(case, None, (case.level - heights) / case.casting_speed)))


def remelting_delay(case: CastingParameters, longest: float = 15.0) -> float:
    """Time [s] from the failure until the first slice has less shell than a spacing; infinite if none has."""
    times = np.arange(0.0, longest, 0.25)
    first_failing = min(case.spray_failing, default=case.spray_zones + 1)
    top = case.mould_bottom * (1.0 - (first_failing - 1) / case.spray_zones)
    delay = np.inf
    for start in np.linspace(top + 0.02, max(top - 0.04, 0.02), 4):
        inside = times[case.casting_speed * times < start]
        gone = np.flatnonzero(shell_of_slice(case, start, inside) < case.spacing)
        if len(gone):
            delay = min(delay, float(inside[gone[0]]))
    return delay
