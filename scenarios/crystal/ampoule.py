"""The charge in its quartz crucible: what stands where, and the furnace around it."""

import numpy as np
from pydantic import model_validator

from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.materials import Material, solid_material
from warpsph.core.particles import lattice
from warpsph.terms import HeatWall, Profile

TABLE = "Rook, Yildiz & Dost (2007), table 2"
CHARGE = ("quartz", "germanium", "solution", "silicon")  # from below, on the axis
JUMP = 1e-6  # of its height, over which the conductance jumps where the insulator begins


class Ampoule(Scenario):
    """Germanium substrate, solution and silicon source, one above the other, in a crucible that stands in a furnace.

    The half of it at x > 0; y is the height above the outer bottom of the crucible, z in the source.
    """

    spacing: float = parameter(5e-4, "m", "particle spacing; all lengths are whole numbers of it", ge=5e-5, le=2e-3)
    charge_half_width: float = parameter(12.5e-3, "m", "half the inner width of the crucible", gt=0, le=0.5)
    crucible_wall: float = parameter(1.0e-3, "m", "thickness of its wall", gt=0, le=0.1)
    crucible_base: float = parameter(2.0e-3, "m", "thickness of its bottom", gt=0, le=0.1)
    substrate_height: float = parameter(13.0e-3, "m", "of the germanium substrate", gt=0, le=0.5)
    solution_height: float = parameter(32.0e-3, "m", "of the solution of silicon in germanium", gt=0, le=0.5)
    source_height: float = parameter(4.0e-3, "m", "of the silicon source", gt=0, le=0.5)
    conductivity_quartz: float = parameter(2.0, "W/(m K)", "of the crucible", gt=0, le=100.0)
    heat_capacity_solution: float = parameter(393.0, "J/(kg K)", "of the solution, 380 to 406", gt=0, le=1e4)
    furnace_places: tuple[float, ...] = parameter(
        (0.0, 0.015, 0.020, 0.051), "m", "heights at which the temperature of the furnace is given"
    )
    furnace_temperatures: tuple[float, ...] = parameter(
        (1075.0, 1095.0, 1240.0, 1360.0), "K", "of the furnace at these heights, linear in between"
    )
    insulator_begin: float = parameter(
        20e-3, "m", "height above which the insulator is around the crucible", gt=0, le=1
    )
    side_conductance: float = parameter(400.0, "W/(m^2 K)", "to the furnace, below the insulator", gt=0, le=1e6)
    insulated_conductance: float = parameter(250.0, "W/(m^2 K)", "to the furnace, through it", gt=0, le=1e6)
    bottom_conductance: float = parameter(60.0, "W/(m^2 K)", "to the furnace, below the crucible", gt=0, le=1e6)
    top_conductance: float = parameter(100.0, "W/(m^2 K)", "to the furnace, above the source", gt=0, le=1e6)

    @model_validator(mode="after")
    def _refuse_what_fits_not(self) -> "Ampoule":
        for name in (
            "charge_half_width",
            "crucible_wall",
            "crucible_base",
            "substrate_height",
            "solution_height",
            "source_height",
        ):
            cells = getattr(self, name) / self.spacing
            if round(cells) < 1 or abs(cells - round(cells)) > 1e-6 * cells:
                raise ValueError(
                    f"{name} = {getattr(self, name):g} m is {cells:.6g} spacings of {self.spacing:g} m: it must be a "
                    "whole number of them"
                )
        places, temperatures = self.furnace_places, self.furnace_temperatures
        if len(places) < 1 or np.any(np.diff(places) <= 0.0):
            raise ValueError(f"furnace_places = {places}: must be one or more heights that rise [m]")
        if len(temperatures) != len(places) or min(temperatures) <= 0.0:
            raise ValueError(
                f"furnace_temperatures = {temperatures}: must be {len(places)} positive temperatures [K], one for each "
                "of furnace_places"
            )
        return self

    @property
    def shape(self) -> tuple[int, int]:
        """Columns and rows of particles."""
        return round(self.half_width / self.spacing), round(self.height / self.spacing)

    @property
    def charge_columns(self) -> int:
        """How many of the columns are charge, those next to the axis."""
        return round(self.charge_half_width / self.spacing)

    @property
    def half_width(self) -> float:
        """From the axis to the outer face of the crucible [m]."""
        return self.charge_half_width + self.crucible_wall

    @property
    def height(self) -> float:
        """From the outer bottom of the crucible to the top of the source [m]."""
        return self.source_bottom + self.source_height

    @property
    def substrate_top(self) -> float:
        """Height at which the solution begins [m]."""
        return self.crucible_base + self.substrate_height

    @property
    def source_bottom(self) -> float:
        """Height at which the source begins [m]."""
        return self.substrate_top + self.solution_height

    @property
    def points(self) -> np.ndarray:
        """Places (n, 3) [m] of the particles, column after column."""
        return lattice((0.0, 0.0), (self.half_width, self.height), self.spacing)

    @property
    def materials(self) -> tuple[Material, ...]:
        """Quartz, germanium, the solution and silicon; each stays what it is, as in the source."""
        data = {
            "quartz": (2200.0, 1200.0, self.conductivity_quartz),
            "germanium": (5323.0, 396.1, 10.60),
            "solution": (5633.0, self.heat_capacity_solution, 42.8),
            "silicon": (2301.6, 967.0, 23.7),
        }
        return tuple(
            solid_material(name, density, heat_capacity=capacity, conductivity=conductivity, source=TABLE)
            for name, (density, capacity, conductivity) in data.items()
        )

    def material_at(self, points: np.ndarray) -> np.ndarray:
        """Names (n,) of the materials at ``points`` (n, 3)."""
        edges = (self.crucible_base, self.substrate_top, self.source_bottom)
        charge = np.array(CHARGE)[np.searchsorted(edges, points[:, 1])]
        return np.where(points[:, 0] > self.charge_half_width, "quartz", charge)

    @property
    def furnace(self) -> Profile:
        """Temperature of the furnace [K] along the height."""
        return Profile(self.furnace_temperatures, self.furnace_places, "y")

    @property
    def film(self) -> Profile:
        """Conductance [W/(m^2 K)] between the side of the crucible and the furnace along the height."""
        begin = self.insulator_begin
        return Profile((self.side_conductance, self.insulated_conductance), ((1.0 - JUMP) * begin, begin), "y")

    @property
    def walls(self) -> tuple[HeatWall, ...]:
        """The side, the bottom, the top and the plane of symmetry; equation (20) of Rook et al. behind section 5."""
        below, above = self.furnace.at(np.array([[0.0, 0.0, 0.0], [0.0, self.height, 0.0]]), 0.0)
        return (
            HeatWall.film((-1.0, 0.0, 0.0), -self.half_width, self.film, self.furnace),
            HeatWall.film((0.0, 1.0, 0.0), 0.0, self.bottom_conductance, float(below)),
            HeatWall.film((0.0, -1.0, 0.0), -self.height, self.top_conductance, float(above)),
            HeatWall.insulated((1.0, 0.0, 0.0), 0.0),
        )
