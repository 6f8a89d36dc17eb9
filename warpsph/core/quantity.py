"""What a quantity is called for people, in which unit, and how it is drawn."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """A name for people and what pictures need beside it.

    Args:
        label: a few words.
        unit: SI unit, "" where it has none or none is known.
        colours: name of its colour map.
        panel: title under which a plot shows it together with others, "" for a panel of its own.
        over: name of the array over which it is given, for example the heights of a profile.
    """

    label: str
    unit: str = ""
    colours: str = "viridis"
    panel: str = ""
    over: str = ""

    @property
    def title(self) -> str:
        """The label with its unit."""
        return with_unit(self.label, self.unit)


def with_unit(text: str, unit: str) -> str:
    """``text [unit]``, or the text alone where there is no unit."""
    return f"{text} [{unit}]" if unit else text


def undeclared(name: str) -> Quantity:
    """What is known of a quantity that nobody has declared: its name."""
    return Quantity(name.replace("_", " "))
