"""The parameters of the casting machine, and what follows from them alone."""

from collections.abc import Callable
from typing import Literal

import numpy as np
from pydantic import model_validator

from warpsph.cases.scenario import parameter
from warpsph.core.materials import WATER, Material, thesis_steel
from warpsph.core.model import GRAVITY
from warpsph.scenarios.casting.travelling_slice import cool_slice
from warpsph.scenarios.conduction.time_stepping import ConductingScenario

WALL_LAYERS = 3  # of the nozzle
COOLING_WATER = 373.15  # [K]
SPRAY_TEMPERATURE = 298.15  # [K]
SPRAY_BOILED = 374.15  # [K]
BOILING_HEAT = float(WATER.enthalpy(SPRAY_BOILED) - WATER.enthalpy(SPRAY_TEMPERATURE))  # [J/kg]


class CastingParameters(ConductingScenario):
    """A half strand in the plane: axis at x = 0, cold face at x = ``half_width``, y upwards from the outflow.

    In three dimensions a quarter of a square billet, with a second plane of symmetry at z = 0 and a second cold face.
    """

    duration: float = parameter(18.0, "s", "physical time to simulate", gt=0, le=1e4)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e4)
    step: float = parameter(
        1e-3, "s", "longest step of conduction; explicit ones are shorter where stability asks for it", gt=0, le=1.0
    )

    dimension: Literal[2, 3] = parameter(2, "", "2: a half strand in the plane; 3: a quarter of a square billet")
    spacing: float = parameter(0.004, "m", "particle spacing", ge=2e-4, le=0.01)
    half_width: float = parameter(0.10, "m", "half width of the strand", ge=0.02, le=1.0)
    level: float = parameter(0.44, "m", "height of the meniscus above the outflow", ge=0.1, le=5.0)
    mould_bottom: float = parameter(0.24, "m", "lower end of the mould", ge=0.02, le=5.0)
    mould_top: float = parameter(0.50, "m", "upper end of the mould", ge=0.05, le=5.5)
    mould_stroke: float = parameter(
        0.006, "m", "stroke of the mould's oscillation, turning point to turning point", ge=0, le=0.05
    )
    mould_frequency: float = parameter(1.5, "Hz", "frequency of the mould's oscillation", ge=0, le=10)
    mould_conductance: float = parameter(1500.0, "W/(m^2 K)", "conductance between steel and mould", gt=0, le=1e5)
    mould_friction: float = parameter(
        0.0,
        "Pa s",
        "viscosity with which the mould drags on the steel; 0: the flux lubricates perfectly",
        ge=0,
        le=1e3,
    )
    nozzle_port: Literal["down", "side"] = parameter(
        "down", "", "where the submerged nozzle opens: downwards, or sideways by ports towards the shell"
    )
    nozzle_mouth: float = parameter(0.36, "m", "height of the nozzle's mouth, or of the middle of a port", gt=0, le=5)
    nozzle_width: float = parameter(0.012, "m", "half width of the nozzle's bore, half height of a port", gt=0, le=1.0)
    nozzle_reach: float = parameter(0.05, "m", "distance from the axis at which a side port ends", gt=0, le=1.0)
    casting_speed: float = parameter(0.01, "m/s", "speed of the strand at the level asked for", ge=0.001, le=0.2)
    level_gain: float = parameter(
        40.0, "", "relative rise of the pouring speed per relative shortage of level", ge=0, le=1e3
    )

    pouring_temperature: float = parameter(1933.15, "K", "temperature of the melt in the nozzle", gt=1000, le=2500)
    density: float = parameter(2100.0, "kg/m^3", "density of the steel (scaled down, see the theory)", ge=100, le=1e4)
    viscosity: float = parameter(6.0, "Pa s", "viscosity of the melt (a thousandfold steel's)", gt=0, le=1e3)
    melt_conductivity: float = parameter(
        300.0, "W/(m K)", "conductivity of the melt, raised for its turbulence", ge=1, le=1e4
    )
    sound_speed: float = parameter(10.0, "m/s", "artificial speed of sound", ge=1, le=5e3)
    youngs_modulus: float = parameter(4.0e5, "Pa", "Young's modulus of the shell (scaled down)", ge=1e3, le=1e12)
    poisson_ratio: float = parameter(0.3, "", "Poisson's ratio of the shell", ge=0, lt=0.5)

    spray_flux: float = parameter(0.2528, "kg/(m^2 s)", "water sprayed on the shell below the mould", ge=0, le=50)
    spray_particle: float = parameter(1.0e-3, "kg/m", "mass of one particle of water", gt=0, le=1)
    spray_speed: float = parameter(0.2, "m/s", "speed of the water", gt=0, le=20)
    spray_zones: int = parameter(
        3, "", "number of zones between mould and outflow, the first under the mould", ge=1, le=20
    )
    spray_failure: float | None = parameter(
        None, "s", "time at which the failing zones go off; none: never", changeable=True, ge=0
    )
    spray_failing: tuple[int, ...] = parameter(
        (1, 2, 3), "", "zones that fail, counted from the mould", changeable=True
    )

    formulation: Literal["published", "corrected"] = parameter(
        "published", "", "flow: summed density as published, or corrected gradients, for comparison"
    )
    support_ratio: float = parameter(2.6, "", "support of the smoothing kernels over the spacing", ge=2.0, le=4.0)
    step_factor: float = parameter(1.0, "", "time step over the stable one; 2 is the most that holds", gt=0, le=2)
    elasticity: Literal["corrected", "published"] = parameter(
        "corrected", "", "displacement gradient: corrected for rotation, or as published"
    )
    start: Literal["hydrostatic", "grid"] = parameter(
        "hydrostatic", "", "initial rows: as they stand under their weight, or a regular grid"
    )

    roll_pitch: float = parameter(0.04, "m", "distance of the support rolls", gt=0, le=1)
    roll_first: float = parameter(0.215, "m", "height of the middle of the first roll", gt=0, le=5)
    roll_radius: float = parameter(0.01, "m", "radius of the support rolls", gt=0, le=0.5)

    @model_validator(mode="after")
    def _check_geometry(self) -> "CastingParameters":
        def refuse(key: str, why: str) -> None:
            raise ValueError(f"{key} = {getattr(self, key)}: {why}")

        if not self.mould_bottom < self.level < self.mould_top:
            refuse("level", f"must lie between mould_bottom {self.mould_bottom} and mould_top {self.mould_top} m")
        if self.nozzle_port == "side":
            self._check_port(refuse)
        if not self.mould_bottom < self.nozzle_mouth < self.level:
            refuse(
                "nozzle_mouth",
                f"must lie in the melt between mould_bottom {self.mould_bottom} and level {self.level} m",
            )
        if not self.spacing <= self.nozzle_width <= 0.5 * self.half_width:
            refuse(
                "nozzle_width", f"must lie between spacing {self.spacing} m and half of half_width {self.half_width} m"
            )
        if self.roll_radius < 1.5 * self.spacing:
            refuse("roll_radius", f"the melt would pass by rolls thinner than 1.5 spacings of {self.spacing} m")
        if 2.0 * self.roll_radius > self.roll_pitch:
            refuse("roll_radius", f"rolls at a roll_pitch of {self.roll_pitch} m must be thinner than that")
        if self.roll_first + self.roll_radius > self.mould_bottom:
            refuse("roll_first", f"the first roll must stand below mould_bottom {self.mould_bottom} m")
        if self.spray_failure is not None and any(not 1 <= zone <= self.spray_zones for zone in self.spray_failing):
            refuse("spray_failing", f"zones are counted from 1 to spray_zones {self.spray_zones}")
        if self.pouring_temperature < self.steel.liquidus:
            refuse("pouring_temperature", f"must lie above the liquidus {self.steel.liquidus:.2f} K")
        return self

    def _check_port(self, refuse: Callable[[str, str], None]) -> None:
        if self.dimension == 3:
            refuse("nozzle_port", "a side port exists in the plane only (dimension = 2)")
        height = self.bore + WALL_LAYERS * self.spacing
        if self.nozzle_mouth + height > self.level:
            refuse("nozzle_mouth", f"a side port of half height {height:.4g} m must lie below level {self.level} m")
        if not height <= self.nozzle_reach <= 0.7 * self.half_width:
            refuse("nozzle_reach", f"must lie between {height:.4g} m, the tube's wall, and 0.7 half_width")

    @property
    def steel(self) -> Material:
        return thesis_steel(self.density, self.melt_conductivity, self.viscosity)

    def zone_at(self, height: float) -> int | None:
        """Spray zone at a height [m], counted from the mould; none in the mould or below the outflow."""
        if not 0.0 <= height < self.mould_bottom:
            return None
        return min(int((1.0 - height / self.mould_bottom) * self.spray_zones) + 1, self.spray_zones)

    @property
    def passage(self) -> float:
        """Time [s] after which nothing is left of the strand that the start was given."""
        return self.level / self.casting_speed

    @property
    def fastest_shell(self) -> float:
        """Speed [m/s] that no part of the shell should exceed.

        The mould's at most, and g h / c_s, with which a particle sets off that is rid of the whole pressure of the melt
        at once: by freezing or melting nothing can be faster.
        """
        return self.fastest_mould + GRAVITY * self.level / self.sound_speed

    @property
    def fastest_mould(self) -> float:
        """Highest speed of the mould [m/s]."""
        return np.pi * self.mould_frequency * self.mould_stroke

    @property
    def bore(self) -> float:
        """Half width of the nozzle's bore in whole particles [m]."""
        return round(self.nozzle_width / self.spacing) * self.spacing

    @property
    def nozzle_side(self) -> float:
        """Distance from the axis [m] to which the nozzle reaches, its walls among it."""
        tube = self.bore + WALL_LAYERS * self.spacing
        return max(tube, self.nozzle_reach) if self.nozzle_port == "side" else tube

    @property
    def beside_nozzle(self) -> tuple[int, int]:
        """The cells from the axis between which the level is gauged, beside the nozzle; none where the first is not
        below the second."""
        sides = max(0.25 * self.half_width, self.nozzle_side), 0.75 * self.half_width
        low, high = (round(side / self.spacing) for side in sides)
        return low, high

    @property
    def spray_heat_flux(self) -> float:
        """Heat flux [W/m^2] by which the water boils away."""
        return self.spray_flux * BOILING_HEAT

    def surface_flux(self, temperature: float, age: float) -> float:
        """Heat flux [W/m^2] out of the shell of surface ``temperature`` [K], ``age`` [s] after the meniscus."""
        if self.level - self.casting_speed * age > self.mould_bottom:
            return self.mould_conductance * (temperature - COOLING_WATER)
        return self.spray_heat_flux

    def slices(self, heights: np.ndarray) -> np.ndarray:
        """Temperature (k, cells) [K] of the stagnant strand at some heights [m], from the axis to the surface."""
        ages = np.maximum(self.level - heights, 0.0) / self.casting_speed
        order = np.argsort(ages)
        profiles = cool_slice(
            self.steel, self.half_width, self.pouring_temperature, ages[order], self.surface_flux, 0.25 * self.spacing
        )
        return profiles[np.argsort(order)]
