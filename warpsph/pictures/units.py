"""Units as they are printed."""

import re

from warpsph.core.quantity import Quantity, with_unit

RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def printed(text: str, unit: str) -> str:
    """``text [unit]`` with raised exponents, kg/m³ for kg/m^3; a dollar sign in a text begins no formula."""
    return with_unit(
        text.replace("$", r"\$"), re.sub(r"\^(-?\d+)", lambda exponent: exponent[1].translate(RAISED), unit)
    )


def title_of(quantity: Quantity) -> str:
    """The label of a quantity with its unit."""
    return printed(quantity.label, quantity.unit)
