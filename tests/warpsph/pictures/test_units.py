"""Units as they are printed."""

import pytest

from warpsph.core.quantity import Quantity
from warpsph.pictures.units import title_of


@pytest.mark.parametrize(
    ("unit", "title"),
    [
        ("kg/m^3", "dye [kg/m³]"),
        ("kg m^2/s", "dye [kg m²/s]"),
        ("m s^-12", "dye [m s⁻¹²]"),
        ("W/(m K)", "dye [W/(m K)]"),
        ("", "dye"),
    ],
)
def test_exponents_are_raised(unit, title):
    """If it failed, pictures would print units as programs write them."""
    assert title_of(Quantity("dye", unit)) == title
