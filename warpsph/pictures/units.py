"""Units as they are printed."""

import re

from warpsph.core.quantity import Quantity, with_unit

RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def plain(text: str) -> str:
    """A text in which matplotlib sees no formula: a dollar sign is one."""
    return text.replace("$", r"\$")


def printed(text: str, unit: str) -> str:
    """``text [unit]`` with raised exponents, kg/m³ for kg/m^3; a dollar sign in a text begins no formula."""
    return with_unit(plain(text), re.sub(r"\^(-?\d+)", lambda exponent: exponent[1].translate(RAISED), plain(unit)))


def title_of(quantity: Quantity) -> str:
    """The label of a quantity with its unit."""
    return printed(quantity.label, quantity.unit)
