"""Materials as data: enthalpy curve, conductivity, viscosity, with the source of the numbers."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from warpsph.errors import InputError, number, shown

SMALLEST, LARGEST = 1.0e-6, 1.0e9  # of densities, capacities and conductivities, in SI units


@dataclass(frozen=True)
class Material:
    """One material.

    Args:
        name: for messages and pictures.
        density: reference density [kg/m^3].
        temperatures: nodes of the enthalpy curve [K], rising; a pure substance has its melting point twice.
        enthalpies: specific enthalpy at the nodes [J/kg], rising strictly, in single precision as well; linear between
            and beyond the nodes.
        conductivity_solid, conductivity_liquid: thermal conductivity [W/(m K)], linear in the solid fraction between.
        viscosity: dynamic viscosity of the fluid [Pa s].
        solidus, liquidus: melting range [K]; one temperature for a pure substance, whose latent heat is that between
            the two nodes of its melting point.
        source: where the numbers come from.

    Raises:
        InputError: a density, heat capacity or conductivity is not from 1e-6 to 1e9 (a conductivity may be 0), a
            viscosity is negative, a curve does not rise, or it is flat elsewhere than at the melting point of a pure
            substance.
    """

    name: str
    density: float
    temperatures: tuple[float, ...]
    enthalpies: tuple[float, ...]
    conductivity_solid: float
    conductivity_liquid: float
    viscosity: float
    solidus: float
    liquidus: float
    source: str

    def __post_init__(self) -> None:
        self._refuse_unless(isinstance(self.name, str) and self.name != "", "name", "a text")
        within = f"from {SMALLEST:g} to {LARGEST:g}"
        self._refuse_unless(SMALLEST <= number(self.density) <= LARGEST, "density", f"{within} [kg/m^3]")
        for label in ("conductivity_solid", "conductivity_liquid"):
            conductivity = number(getattr(self, label))
            plausible = conductivity == 0.0 or SMALLEST <= conductivity <= LARGEST
            self._refuse_unless(plausible, label, f"zero, or {within} [W/(m K)]")
        self._refuse_unless(0.0 <= number(self.viscosity) < np.inf, "viscosity", "zero or positive [Pa s]")
        for label in ("solidus", "liquidus"):
            self._refuse_unless(bool(np.isfinite(number(getattr(self, label)))), label, "a number [K]")
        for label, nodes in (("temperatures", self.temperatures), ("enthalpies", self.enthalpies)):
            several = isinstance(nodes, Sequence | np.ndarray)
            finite = several and bool(np.all(np.isfinite([number(node) for node in nodes])))
            self._refuse_unless(finite, label, "finite numbers")
            rises = np.diff(np.asarray(nodes, np.float32)) > 0.0
            if label == "temperatures" and self.is_pure:
                rises |= np.asarray(nodes[:-1]) == self.solidus
            if len(nodes) < 2 or not np.all(rises):
                raise InputError(
                    f"material {self.name}: {label} need two or more nodes that rise strictly, in single precision too"
                )
        if len(self.temperatures) != len(self.enthalpies):
            raise InputError(f"material {self.name}: as many temperatures as enthalpies are needed")
        with np.errstate(divide="ignore"):
            capacity = float(np.min(np.diff(self.enthalpies) / np.diff(self.temperatures)))
        if not SMALLEST <= capacity <= LARGEST:
            raise InputError(f"material {self.name}: a heat capacity of {capacity:g}: must be {within} [J/(kg K)]")
        if not self.solidus <= self.liquidus:
            raise InputError(
                f"material {self.name}: solidus {self.solidus} K must not lie above liquidus {self.liquidus} K"
            )
        if self.is_pure and np.sum(np.asarray(self.temperatures) == self.solidus) != 2:
            raise InputError(
                f"material {self.name}: melts at one temperature, {self.solidus} K; its curve must have that "
                "temperature at two nodes, the latent heat between them"
            )

    def _refuse_unless(self, holds: bool, argument: str, allowed: str) -> None:
        if not holds:
            raise InputError(f"material {self.name}: {argument} = {shown(getattr(self, argument))}: must be {allowed}")

    @property
    def melts(self) -> bool:
        """Whether it melts and freezes at all."""
        return self.solidus > NEVER_FREEZES[0] and self.liquidus < NEVER_MELTS[1]

    @property
    def is_pure(self) -> bool:
        """Whether it melts at one temperature."""
        return self.solidus == self.liquidus

    @property
    def melting_enthalpies(self) -> tuple[float, float]:
        """Specific enthalpy [J/kg] of the solid at the solidus and of the liquid at the liquidus."""
        if self.is_pure:
            first = list(self.temperatures).index(self.solidus)
            return self.enthalpies[first], self.enthalpies[first + 1]
        return float(self.enthalpy(self.solidus)), float(self.enthalpy(self.liquidus))

    def enthalpy(self, temperature: float | np.ndarray) -> np.ndarray:
        """Specific enthalpy [J/kg] at a temperature [K]; that of the liquid where a pure substance melts."""
        return _piecewise_linear(temperature, self.temperatures, self.enthalpies)

    def start_enthalpy(self, temperature: np.ndarray, is_solid: np.ndarray) -> np.ndarray:
        """Specific enthalpies (n,) [J/kg] at temperatures (n,) [K]; ``is_solid`` decides where a pure substance melts.

        There the temperature stands for all the latent heat. Compared in single precision, in which it is kept.
        """
        enthalpy = self.enthalpy(temperature)
        if not self.is_pure:
            return enthalpy
        melts = np.asarray(temperature, np.float32) == np.float32(self.solidus)
        return np.where(melts, np.where(is_solid, *self.melting_enthalpies), enthalpy)

    def temperature(self, enthalpy: float | np.ndarray) -> np.ndarray:
        """Temperature [K] at a specific enthalpy [J/kg]."""
        return _piecewise_linear(enthalpy, self.enthalpies, self.temperatures)

    def solid_fraction(self, temperature: float | np.ndarray) -> np.ndarray:
        """Solid fraction at a temperature [K]; 0 at the melting point of a pure substance."""
        if self.is_pure:
            return np.where(np.asarray(temperature) < self.solidus, 1.0, 0.0)
        return np.clip((self.liquidus - np.asarray(temperature)) / (self.liquidus - self.solidus), 0.0, 1.0)


NEVER_FREEZES = (1.0, 2.0)  # solidus and liquidus [K] of what stays as it is
NEVER_MELTS = (1.0e9, 2.0e9)
NO_HEAT = 1000.0  # heat capacity [J/(kg K)] of what conducts no heat and therefore keeps its temperature


def _piecewise_linear(x, nodes, values):
    nodes, values = np.asarray(nodes, float), np.asarray(values, float)
    segment = np.clip(np.searchsorted(nodes, x, side="right") - 1, 0, len(nodes) - 2)
    rise = np.diff(nodes)
    slope = np.diff(values) / np.where(rise > 0.0, rise, np.inf)  # no x lies within a part without rise
    return values[segment] + slope[segment] * (np.asarray(x, float) - nodes[segment])


def melting_material(
    name: str,
    *,
    density: float,
    heat_capacity: float,
    latent_heat: float,
    solidus: float,
    liquidus: float,
    conductivity_solid: float,
    conductivity_liquid: float,
    viscosity: float,
    source: str,
    heat_capacity_liquid: float | None = None,
) -> Material:
    """A material of constant heat capacity [J/(kg K)] whose latent heat [J/kg] is spread evenly over its melting range.

    A pure substance, whose solidus is its liquidus, takes it up at that temperature. The enthalpy counts from 0 K:
    ``heat_capacity * T`` below the solidus. The heat capacity of the liquid is by default that of the solid; within a
    melting range it is the mean of both.
    """
    liquid = heat_capacity if heat_capacity_liquid is None else heat_capacity_liquid
    for label, value in (
        ("heat_capacity", heat_capacity), ("heat_capacity_liquid", liquid), ("latent_heat", latent_heat)
    ):  # fmt: skip
        if not 0.0 <= number(value) < np.inf:
            raise InputError(f"material {name}: {label} = {shown(value)}: must be zero or positive")
    for label, value in (("solidus", solidus), ("liquidus", liquidus)):
        if not 0.0 < number(value) < np.inf:
            raise InputError(f"material {name}: {label} = {shown(value)}: must be positive [K]")
    top = liquidus + 1000.0
    at_solidus = heat_capacity * solidus
    at_liquidus = at_solidus + 0.5 * (heat_capacity + liquid) * (liquidus - solidus) + latent_heat
    return Material(
        name=name,
        density=density,
        temperatures=(0.0, solidus, liquidus, top),
        enthalpies=(0.0, at_solidus, at_liquidus, at_liquidus + liquid * (top - liquidus)),
        conductivity_solid=conductivity_solid,
        conductivity_liquid=conductivity_liquid,
        viscosity=viscosity,
        solidus=solidus,
        liquidus=liquidus,
        source=source,
    )


def fluid_material(
    name: str,
    density: float,
    viscosity: float = 0.0,
    *,
    conductivity: float = 0.0,
    heat_capacity: float | None = None,
    source: str = "",
) -> Material:
    """A fluid that never freezes.

    Args:
        name: for messages and pictures.
        density: [kg/m^3], that of the term :class:`~warpsph.terms.Fluid`.
        viscosity: dynamic viscosity [Pa s].
        conductivity: thermal conductivity [W/(m K)]; by default it conducts no heat.
        heat_capacity: [J/(kg K)], of what conducts; the enthalpy counts from 0 K.
        source: where the numbers come from.

    Raises:
        InputError: a number is out of bounds, or something conducts and has no heat capacity.
    """
    return _unchanging(name, density, viscosity, conductivity, heat_capacity, source, NEVER_FREEZES)


def solid_material(
    name: str,
    density: float,
    viscosity: float = 0.0,
    *,
    conductivity: float = 0.0,
    heat_capacity: float | None = None,
    source: str = "",
) -> Material:
    """A solid that never melts: an elastic body, a wall, a dummy.

    How stiff elastic bodies are is said by the term :class:`~warpsph.terms.Elasticity`, one for all of a case.

    Args:
        name: for messages and pictures.
        density: [kg/m^3].
        viscosity: of a wall, with which it holds back the fluid that passes [Pa s].
        conductivity: thermal conductivity [W/(m K)]; by default it conducts no heat.
        heat_capacity: [J/(kg K)], of what conducts; the enthalpy counts from 0 K.
        source: where the numbers come from.

    Raises:
        InputError: a number is out of bounds, or something conducts and has no heat capacity.
    """
    return _unchanging(name, density, viscosity, conductivity, heat_capacity, source, NEVER_MELTS)


def _unchanging(
    name: str,
    density: float,
    viscosity: float,
    conductivity: float,
    heat_capacity: float | None,
    source: str,
    melting_range: tuple[float, float],
) -> Material:
    """A material of constant heat capacity whose melting range is never reached."""
    if heat_capacity is None and number(conductivity) > 0.0:
        raise InputError(f"material {name}: heat_capacity is missing; what conducts needs one [J/(kg K)]")
    capacity = NO_HEAT if heat_capacity is None else number(heat_capacity)
    if not 0.0 < capacity < np.inf:
        raise InputError(f"material {name}: heat_capacity = {shown(heat_capacity)}: must be positive [J/(kg K)]")
    return Material(
        name=name,
        density=density,
        temperatures=(0.0, 1000.0),
        enthalpies=(0.0, 1000.0 * capacity),
        conductivity_solid=conductivity,
        conductivity_liquid=conductivity,
        viscosity=viscosity,
        solidus=melting_range[0],
        liquidus=melting_range[1],
        source=source,
    )


COPPER = Material(
    name="copper",
    density=8940.0,
    temperatures=(0.0, 1000.0),
    enthalpies=(0.0, 387.0e3),
    conductivity_solid=350.0,
    conductivity_liquid=350.0,
    viscosity=0.0,
    solidus=1357.0,
    liquidus=1358.0,
    source="copper of casting moulds: k 350 W/(m K), rho 8940 kg/m^3, c_p 387 J/(kg K), usual in casting literature",
)

WATER = Material(
    name="water",
    density=998.0,
    temperatures=(0.0, 373.15, 374.15),
    enthalpies=(0.0, 4190.0 * 373.15, 4190.0 * 373.15 + 2.257e6),
    conductivity_solid=1.0e4,
    conductivity_liquid=1.0e4,
    viscosity=0.0,
    solidus=272.15,
    liquidus=273.15,
    source="water: c_p 4190 J/(kg K), latent heat of vaporisation 2.257 MJ/kg (handbook values); conductivity 'very "
    "large', so that the metal decides (Vijaykumar 2012, section 6.4)",
)


def thesis_steel(density: float = 2100.0, conductivity_liquid: float = 300.0, viscosity: float = 6.0) -> Material:
    """Steel as the casting thesis needs it: light, a thousandfold viscous, and a melt that conducts ten times better.

    Density and viscosity after Vijaykumar (2012), sections 7.5.1 and 7.5.4. Heat capacity, latent heat and melting
    range are rounded values of low-carbon steel; the thesis leaves them unsaid. The conductivity of the melt stands
    for turbulent mixing, as is usual in casting models.
    """
    return melting_material(
        "steel",
        density=density,
        heat_capacity=700.0,
        latent_heat=272.0e3,
        solidus=1450.0 + 273.15,
        liquidus=1500.0 + 273.15,
        conductivity_solid=30.0,
        conductivity_liquid=conductivity_liquid,
        viscosity=viscosity,
        source="Vijaykumar (2012), section 7.5, completed with rounded values of low-carbon steel",
    )
