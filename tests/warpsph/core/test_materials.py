"""Materials: the enthalpy curve and its bounds."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from warpsph.core.materials import COPPER, WATER, Material, conductor, thesis_steel
from warpsph.errors import InputError


@given(st.floats(200.0, 2500.0))
def test_temperature_and_enthalpy_are_inverse(temperature):
    """A particle must not change its temperature by being described by its enthalpy."""
    for material in (thesis_steel(), COPPER, WATER):
        assert material.temperature(material.enthalpy(temperature)) == pytest.approx(temperature, abs=1e-6)


def test_latent_heat_lies_between_solidus_and_liquidus():
    """The shell grows at the rate at which this heat is taken away."""
    steel = thesis_steel()
    gained = steel.enthalpy(steel.liquidus) - steel.enthalpy(steel.solidus)
    assert gained == pytest.approx(272e3 + 700.0 * 50.0)
    assert steel.solid_fraction(steel.solidus) == 1.0
    assert steel.solid_fraction(0.5 * (steel.solidus + steel.liquidus)) == pytest.approx(0.5)
    assert steel.solid_fraction(steel.liquidus) == 0.0


def test_water_boils_away():
    """Spray cools by the heat from its temperature to steam: 2.57 MJ/kg from 25 C."""
    assert WATER.enthalpy(374.15) - WATER.enthalpy(298.15) == pytest.approx(2.571e6, rel=1e-3)


@pytest.mark.parametrize(
    "change",
    [
        {"temperatures": (0.0, 500.0, 400.0)},
        {"enthalpies": (0.0, 1.0, 1.0)},
        {"enthalpies": (0.0, 1.0)},
        {"solidus": 1000.0, "liquidus": 1000.0},
    ],
)
def test_a_curve_that_cannot_be_inverted_is_refused(change):
    """Temperature from enthalpy would divide by zero on the device."""
    values = {
        "name": "x", "density": 1.0, "temperatures": (0.0, 400.0, 500.0), "enthalpies": (0.0, 1.0, 2.0),
        "conductivity_solid": 1.0, "conductivity_liquid": 1.0, "viscosity": 0.0, "solidus": 400.0, "liquidus": 500.0,
        "source": "none",
    }  # fmt: skip
    with pytest.raises(InputError, match="material x"):
        Material(**(values | change))


def test_curve_values_are_linear_beyond_the_nodes():
    """Melt hotter than the last node must not stop warming."""
    assert np.diff(COPPER.enthalpy(np.array([1500.0, 1600.0])))[0] == pytest.approx(387.0 * 100.0)


@given(st.floats(10.0, 2500.0))
def test_a_conductor_is_its_few_numbers(temperature):
    """A plain plate must not need an invented melting range, nor ever melt or freeze by it."""
    plate = conductor("plate", density=2000.0, heat_capacity=500.0, conductivity=40.0)
    assert plate.enthalpy(temperature) == pytest.approx(500.0 * temperature)
    assert plate.conductivity_solid == plate.conductivity_liquid == 40.0
    assert plate.solid_fraction(temperature) == 0.0
