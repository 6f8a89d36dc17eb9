"""Materials: the enthalpy curve and its bounds."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from warpsph.core.materials import (
    COPPER,
    WATER,
    Material,
    fluid_material,
    melting_material,
    solid_material,
    thesis_steel,
)
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
        {"solidus": 401.0, "liquidus": 400.0},
        {"temperatures": (0.0, 400.0, 400.0)},
        {"temperatures": (400.0, 400.0, 400.0), "solidus": 400.0, "liquidus": 400.0},
        {"temperatures": (0.0, 400.0, 500.0), "solidus": 400.0, "liquidus": 400.0},
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
def test_a_plain_fluid_and_a_plain_solid_are_their_few_numbers(temperature):
    """A plate must not need an invented melting range, nor melt by it; nor may a plain fluid ever freeze."""
    heat = {"heat_capacity": 500.0, "conductivity": 40.0}
    for make, solid in ((fluid_material, 0.0), (solid_material, 1.0)):
        plain = make("plain", 2000.0, 0.5, **heat)
        assert (plain.density, plain.viscosity) == (2000.0, 0.5)
        assert plain.enthalpy(temperature) == pytest.approx(500.0 * temperature)
        assert plain.conductivity_solid == plain.conductivity_liquid == 40.0
        assert plain.solid_fraction(temperature) == solid
        assert make("plain", 2000.0).conductivity_solid == 0.0


NAN, INFINITE = float("nan"), float("inf")


@pytest.mark.parametrize("make", [fluid_material, solid_material])
@pytest.mark.parametrize(
    ("change", "words"),
    [
        *(({"density": value}, "oil: density") for value in (0.0, -1.0, NAN, INFINITE, "heavy", None)),
        *(({"viscosity": value}, "oil: viscosity") for value in (-1.0, NAN, "thick")),
        *(({"conductivity": value, "heat_capacity": 1.0}, "oil: conductivity") for value in (-1.0, NAN, [1.0])),
        *(({"heat_capacity": value}, "oil: heat_capacity") for value in (0.0, -1.0, NAN, "hot")),
        ({"conductivity": 1.0}, "oil: heat_capacity is missing"),
        ({"name": 3}, "name = 3"),
        ({"name": ""}, "name = ''"),
    ],
)
def test_numbers_without_meaning_are_refused(make, change, words):
    """If it failed, a material without mass, or one that is no number, would end as a run full of NaN."""
    with pytest.raises(InputError, match=words) as caught:
        make(**({"name": "oil", "density": 900.0} | change))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("argument", ["heat_capacity", "latent_heat", "solidus", "liquidus"])
@pytest.mark.parametrize("value", [-1.0, NAN, "much"])
def test_a_melting_material_names_the_argument_that_is_wrong(argument, value):
    """If it failed, one would be told of nodes of a curve that one has never given."""
    steel = {
        "density": 7000.0, "heat_capacity": 700.0, "latent_heat": 2.7e5, "solidus": 1700.0, "liquidus": 1750.0,
        "conductivity_solid": 30.0, "conductivity_liquid": 30.0, "viscosity": 6e-3, "source": "none",
    }  # fmt: skip
    with pytest.raises(InputError, match=f"steel: {argument} = "):
        melting_material("steel", **(steel | {argument: value}))


def test_a_pure_substance_takes_its_latent_heat_at_one_temperature():
    """Ice that had to warm while it melts would be no ice."""
    ice = melting_material(
        "water", density=1000.0, heat_capacity=2090.0, heat_capacity_liquid=4190.0, latent_heat=3.335e5, solidus=273.15,
        liquidus=273.15, conductivity_solid=2.2, conductivity_liquid=0.591, viscosity=0.0, source="round numbers",
    )  # fmt: skip
    frozen, molten = ice.melting_enthalpies
    assert molten - frozen == pytest.approx(3.335e5)
    assert ice.temperature(np.linspace(frozen, molten, 7)) == pytest.approx(np.full(7, 273.15))
    assert ice.temperature([frozen - 2090.0, molten + 4190.0]) == pytest.approx([272.15, 274.15])
    assert ice.enthalpy([272.15, 273.15, 274.15]) == pytest.approx([frozen - 2090.0, molten, molten + 4190.0])
    assert list(ice.solid_fraction([273.0, 273.15, 273.3])) == [1.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"density": 1e-300}, r"density = 1e-300: must be from 1e-06 to 1e\+09"),
        ({"density": 1e30}, r"density = 1e\+30: must be from"),
        ({"heat_capacity": 1e-300}, "single precision"),
        ({"heat_capacity": 1e-7, "latent_heat": 1e-3}, r"a heat capacity of 1e-07: must be from 1e-06 to 1e\+09"),
        ({"conductivity_liquid": 1e-300}, "conductivity_liquid = 1e-300: must be zero, or from"),
        ({"latent_heat": 1e-9}, "enthalpies need two or more nodes that rise strictly, in single precision"),
        (
            {"solidus": 273.149999, "latent_heat": 1e5},
            "temperatures need two or more nodes that rise strictly, in single",
        ),
    ],
)
def test_numbers_that_single_precision_would_lose_are_refused(change, words):
    """If it failed, a difference or a quotient of such numbers would be none at all."""
    numbers = {
        "density": 1000.0, "heat_capacity": 2000.0, "latent_heat": 3e5, "solidus": 273.15, "liquidus": 273.15,
        "conductivity_solid": 2.0, "conductivity_liquid": 0.6, "viscosity": 0.0, "source": "",
    }  # fmt: skip
    with pytest.raises(InputError, match=f"material ice: .*{words}") as caught:
        melting_material("ice", **(numbers | change))
    assert "\n" not in str(caught.value)
