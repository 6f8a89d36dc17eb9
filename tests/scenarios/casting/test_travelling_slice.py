"""The one-dimensional reference of the casting checks, against exact solutions."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import erf

from warpsph.core.materials import melting_material
from warpsph.scenarios.casting.travelling_slice import cool_slice, shell_thickness


def steel(narrow: float):
    return melting_material(
        "steel", density=7300.0, heat_capacity=700.0, latent_heat=270e3, solidus=1793.15 - narrow, liquidus=1793.15,
        conductivity_solid=30.0, conductivity_liquid=30.0, viscosity=0.006, source="round numbers",
    )  # fmt: skip


def test_growth_is_the_stefan_solution():
    """The casting check compares the shell with this slice: it must know the square-root law itself."""
    material, wall, ages = steel(2.0), 1000.0, np.array([5.0, 10.0, 20.0])
    stefan = 700.0 * (1793.15 - wall) / 270e3
    root = brentq(lambda x: np.sqrt(np.pi) * x * np.exp(x * x) * erf(x) - stefan, 0.1, 2.0)
    exact = 2.0 * root * np.sqrt(30.0 / (7300.0 * 700.0) * ages)
    flux = lambda temperature, age: 2.0 * 30.0 * (temperature - wall) / 0.0005  # noqa: E731
    profiles = cool_slice(material, 0.1, 1793.15, ages, flux, 0.0005)
    measured = [shell_thickness(profile, material, 0.1, 0.5) for profile in profiles]
    assert measured == pytest.approx(exact, rel=0.03)


def test_heat_taken_is_heat_missing():
    """A slice that loses more or less than flows out would shift the reference."""
    material = steel(50.0)
    profile = cool_slice(material, 0.1, 1850.0, np.array([10.0]), lambda temperature, age: 5.0e5, 0.001)[0]
    missing = np.sum(material.enthalpy(1850.0) - material.enthalpy(profile)) * 7300.0 * 0.001
    assert missing == pytest.approx(5.0e5 * 10.0, rel=1e-6)


def test_no_shell_and_all_shell():
    """The ends of the range must not be read as something between."""
    material = steel(50.0)
    assert shell_thickness(np.full(10, 1900.0), material, 0.1, 0.5) == 0.0
    assert shell_thickness(np.full(10, 1500.0), material, 0.1, 0.5) == 0.1
