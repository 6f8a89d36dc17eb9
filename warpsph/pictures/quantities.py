"""What the fields and diagnostics are called in a picture, in which unit and in which colours."""

from dataclasses import dataclass

import numpy as np

from warpsph.errors import InputError
from warpsph.nearest import did_you_mean


@dataclass(frozen=True)
class Quantity:
    """A name for people, its SI unit ("" where it has none or none is known) and its colour map."""

    label: str
    unit: str = ""
    colours: str = "viridis"

    @property
    def title(self) -> str:
        return f"{self.label} [{self.unit}]" if self.unit else self.label


FIELDS = {
    "speed": Quantity("speed", "m/s"),
    "velocity": Quantity("speed", "m/s"),
    "pressure": Quantity("pressure", "Pa", "cividis"),
    "density": Quantity("density", "kg/m³", "cividis"),
    "temperature": Quantity("temperature", "K", "inferno"),
    "enthalpy": Quantity("specific enthalpy", "J/kg", "inferno"),
    "solid_fraction": Quantity("solid fraction", "", "YlGnBu"),
    "concentration": Quantity("concentration", "", "viridis"),
}

DIAGNOSTICS = {
    "time": Quantity("time", "s"),
    "height": Quantity("height", "m"),
    "level": Quantity("melt level", "m"),
    "meniscus": Quantity("meniscus", "m"),
    "front": Quantity("front", "m"),
    "mass_inside": Quantity("inside", "kg/m"),
    "mass_in": Quantity("in", "kg/m"),
    "mass_out": Quantity("out", "kg/m"),
    "enthalpy_inside": Quantity("inside", "J/m"),
    "enthalpy_in": Quantity("in", "J/m"),
    "enthalpy_out": Quantity("out", "J/m"),
    "heat_mould": Quantity("to the mould", "J/m"),
    "heat_spray": Quantity("to the sprays", "J/m"),
    "heat_fluid": Quantity("in the fluid", "J/m"),
    "heat_wall": Quantity("in the wall", "J/m"),
    "ledger_error": Quantity("relative error of the heat ledger"),
    "kinetic_energy": Quantity("kinetic energy", "J/m"),
    "highest_speed": Quantity("highest speed", "m/s"),
    "strain_energy": Quantity("elastic energy", "J/m"),
    "tip": Quantity("deflection of the tip", "m"),
    "gap": Quantity("least distance of the bodies", "m"),
    "asymmetry": Quantity("distance from the mirror image", "m"),
    "separation_speed": Quantity("speed at which the bodies part", "m/s"),
    "stretch_min": Quantity("least stretch"),
    "stretch_max": Quantity("greatest stretch"),
    "density_min": Quantity("lowest", "kg/m³"),
    "density_max": Quantity("highest", "kg/m³"),
    "casting_speed": Quantity("casting speed", "m/s"),
    "pouring_speed": Quantity("pouring speed", "m/s"),
    "mould_velocity": Quantity("velocity of the mould", "m/s"),
    "shell_velocity": Quantity("velocity of the shell's skin in the mould", "m/s"),
    "particles_inside": Quantity("inside"),
    "particles_in": Quantity("in"),
    "particles_out": Quantity("out"),
    "escaped_melt": Quantity("particles of escaped melt"),
    "hole_height": Quantity("height without shell", "m"),
    "missing_melt": Quantity("melt missing in the reservoir"),
    "missing_water": Quantity("water missing in the reservoir"),
    "heat": Quantity("heat", "J/m"),
    "bottom_pressure": Quantity("pressure at the bottom", "Pa"),
    "shell_thickness": Quantity("shell thickness", "m", "viridis"),
    "shell_surface_temperature": Quantity("shell surface temperature", "K", "inferno"),
}


def quantity(name: str, known: dict[str, Quantity]) -> Quantity:
    """The description of ``name``; an unknown name stands for itself."""
    return known.get(name, Quantity(name.replace("_", " ")))


def values_of(fields: dict[str, np.ndarray], name: str) -> np.ndarray:
    """One number a particle (n,): a stored field, the magnitude of a vector, or ``speed``.

    Raises:
        InputError: there is no such field.
    """
    allowed = [*fields, "speed"] if "velocity" in fields else [*fields]
    if name not in allowed:
        raise InputError(f"field = '{name}': the file holds no such field{did_you_mean(name, allowed)}")
    values = fields["velocity" if name == "speed" else name]
    return np.linalg.norm(values, axis=1) if values.ndim == 2 else values
