"""Continuous casting as in chapter 6 of Vijaykumar (2012): nozzle, melt, shell, mould, rolls, spray, withdrawal."""

from collections.abc import Callable, Iterable
from itertools import pairwise
from typing import ClassVar, Literal

import numpy as np
from pydantic import model_validator

from warpsph.boundary import Inlet, LevelGauge, OscillatingMould, Outflow, Spray, SprayZone, SymmetryPlane
from warpsph.case import preset_layer, resolve
from warpsph.check import Check
from warpsph.device import Executor
from warpsph.hydrostatics import row_heights
from warpsph.labels import Role
from warpsph.materials import COPPER, WATER, Material, inert, thesis_steel
from warpsph.model import Conduction, Elasticity, Fluid, Model, PhaseChange
from warpsph.particles import Particles, lattice
from warpsph.scenario import Scenario, parameter
from warpsph.scenarios.casting_checks import casting_checks
from warpsph.scenarios.casting_observer import CastingObserver
from warpsph.scenarios.travelling_slice import cool_slice
from warpsph.simulation import Result, Simulation

STEEL, MOULD, DUMMY, SPRAY_WATER = range(4)
MOULD_COLUMNS = 4
DUMMY_COLUMNS = 3
OUTFLOW_ROWS = 4
COOLING_WATER = 373.15
SPRAY_TEMPERATURE = 298.15
SPRAY_BOILED = 374.15
SPRAY_DISTANCE = 0.04  # from the nozzles to the strand [m]
LONGEST_RIDE = 10.0  # time on the strand for which water is in reserve [s]


class Casting(Scenario):
    """A half strand in the plane: axis at x = 0, cold face at x = ``half_width``, y upwards from the outflow."""

    name: ClassVar[str] = "casting"
    summary: ClassVar[str] = "continuous casting of steel: nozzle, oscillating mould, shell, sprays, withdrawal"
    source: ClassVar[str] = "Vijaykumar (2012), chapters 6 and 7"
    presets: ClassVar[tuple[str, ...]] = ("demo", "thesis", "breakout")
    default_preset: ClassVar[str | None] = "demo"

    duration: float = parameter(18.0, "s", "physical time to simulate", gt=0, le=1e4)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e4)

    spacing: float = parameter(0.004, "m", "particle spacing", ge=2e-4, le=0.01)
    half_width: float = parameter(0.10, "m", "half width of the strand", ge=0.02, le=1.0)
    level: float = parameter(0.44, "m", "height of the meniscus above the outflow", ge=0.1, le=5.0)
    mould_bottom: float = parameter(0.24, "m", "lower end of the mould", ge=0.0, le=5.0)
    mould_top: float = parameter(0.50, "m", "upper end of the mould", ge=0.05, le=5.5)
    mould_stroke: float = parameter(
        0.006, "m", "stroke of the mould's oscillation, turning point to turning point", ge=0, le=0.05
    )
    mould_frequency: float = parameter(1.5, "Hz", "frequency of the mould's oscillation", ge=0, le=10)
    mould_conductance: float = parameter(1500.0, "W/(m^2 K)", "conductance between steel and mould", gt=0, le=1e5)
    nozzle_mouth: float = parameter(0.36, "m", "height of the mouth of the submerged nozzle", gt=0, le=5.0)
    nozzle_width: float = parameter(0.012, "m", "half width of the nozzle's bore", gt=0, le=1.0)
    casting_speed: float = parameter(0.01, "m/s", "speed of the strand at the level asked for", gt=0, le=0.2)
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
    spray_failure: float | None = parameter(None, "s", "time at which the failing zones go off; none: never", ge=0)
    spray_failing: tuple[int, ...] = parameter((1, 2, 3), "", "zones that fail, counted from the mould")

    elasticity: Literal["corrected", "published"] = parameter(
        "corrected", "", "displacement gradient: corrected for rotation, or as published"
    )
    start: Literal["hydrostatic", "grid"] = parameter(
        "hydrostatic", "", "initial rows: as they stand under their weight, or a regular grid"
    )

    roll_pitch: float = parameter(0.04, "m", "distance of the support rolls", gt=0, le=1)
    roll_first: float = parameter(0.215, "m", "height of the middle of the first roll", gt=0, le=5)
    roll_size: float = parameter(0.008, "m", "height of the face of a roll", gt=0, le=0.5)

    @model_validator(mode="after")
    def _check_geometry(self) -> "Casting":
        def refuse(key: str, why: str) -> None:
            raise ValueError(f"{key} = {getattr(self, key)}: {why}")

        if not self.mould_bottom < self.level < self.mould_top:
            refuse("level", f"must lie between mould_bottom {self.mould_bottom} and mould_top {self.mould_top} m")
        if not self.mould_bottom < self.nozzle_mouth < self.level:
            refuse(
                "nozzle_mouth",
                f"must lie in the melt between mould_bottom {self.mould_bottom} and level {self.level} m",
            )
        if not self.spacing <= self.nozzle_width <= 0.5 * self.half_width:
            refuse(
                "nozzle_width", f"must lie between spacing {self.spacing} m and half of half_width {self.half_width} m"
            )
        if self.spacing > 0.5 * self.roll_size:
            refuse("spacing", f"a roll of roll_size {self.roll_size} m needs two rows of particles")
        if self.roll_first + 0.5 * self.roll_size > self.mould_bottom:
            refuse("roll_first", f"the first roll must stand below mould_bottom {self.mould_bottom} m")
        if any(not 1 <= zone <= self.spray_zones for zone in self.spray_failing):
            refuse("spray_failing", f"zones are counted from 1 to spray_zones {self.spray_zones}")
        if self.pouring_temperature < self.steel.liquidus:
            refuse("pouring_temperature", f"must lie above the liquidus {self.steel.liquidus:.2f} K")
        return self

    @property
    def steel(self) -> Material:
        return thesis_steel(self.density, self.melt_conductivity, self.viscosity)

    @property
    def model(self) -> Model:
        plain = Model(2, self.spacing, (self.steel, COPPER, inert("dummy", self.density), WATER))
        contact = {
            (STEEL, MOULD): plain.contact_conductivity(self.mould_conductance),
            (MOULD, SPRAY_WATER): 0.0,
            (SPRAY_WATER, SPRAY_WATER): 0.0,
        }
        return Model(
            dimension=2,
            spacing=self.spacing,
            materials=plain.materials,
            fluid=Fluid(self.density, self.sound_speed),
            conduction=Conduction(contact),
            phase_change=PhaseChange(),
            elasticity=Elasticity(self.youngs_modulus, self.poisson_ratio, self.elasticity == "corrected"),
        )

    @property
    def bore(self) -> float:
        """Half width of the nozzle's bore in whole particles [m]."""
        return round(self.nozzle_width / self.spacing) * self.spacing

    @property
    def spray_heat_flux(self) -> float:
        """Heat flux [W/m^2] by which the water boils away."""
        return self.spray_flux * float(WATER.enthalpy(SPRAY_BOILED) - WATER.enthalpy(SPRAY_TEMPERATURE))

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

    def build(self, executor: Executor) -> Simulation:
        model = self.model
        particles = Particles()
        gauge = LevelGauge(
            low=(0.25 * self.half_width, 0.0, -1.0),
            high=(0.75 * self.half_width, 2.0 * self.mould_top, 1.0),
            target_level=self.level,
            casting_speed=self.casting_speed,
            area_ratio=self.half_width / self.bore,
            gain=self.level_gain,
        )
        top = self.level + 5.0 * self.spacing
        row = lattice((0.0, 0.0), (self.bore, self.spacing), self.spacing)
        row[:, 1] = 0.0
        plane = SymmetryPlane((1.0, 0.0, 0.0), 0.0)
        self._add_strand(particles, top)
        self._add_walls(particles, plane)
        spray = self._add_spray(particles)
        inlet = Inlet(gauge, row, top, self.nozzle_mouth, self.pouring_temperature, STEEL)
        observer = CastingObserver(self, gauge, inlet, spray)
        simulation = Simulation(
            executor,
            model,
            particles,
            devices=[
                gauge,
                OscillatingMould(self.mould_stroke, self.mould_frequency),
                plane,
                Outflow(gauge, 0.0, -OUTFLOW_ROWS * self.spacing, self.half_width + 2.0 * self.spacing),
                inlet,
                spray,
            ],
            lower=(-4 * self.spacing, -8 * self.spacing, 0.0),
            upper=(self.half_width + 0.1, self.mould_top + 0.05, 0.0),
            observe=observer,
            describe=observer.describe,
        )
        observer.begin(simulation)
        return simulation

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The demo, or the whole run at the thesis's resolution."""
        case = resolve(cls, [preset_layer(cls, "thesis" if slow else "demo")])
        yield from case.checks(simulate(case))

    def checks(self, result: Result) -> list[Check]:
        return casting_checks(self, result)

    def _add_strand(self, particles: Particles, top: float) -> None:
        """Melt and shell at rest under their weight, the moving zones at both ends, and a reserve."""
        dx, floor = self.spacing, -OUTFLOW_ROWS * self.spacing
        rows = round((self.level - floor) / dx)
        settled = row_heights(rows, dx, 9.81, self.sound_speed)
        heights = floor + (settled if self.start == "hydrostatic" else (np.arange(rows) + 0.5) * dx)
        columns = lattice((0.0, 0.0), (self.half_width, dx), dx)[:, 0]
        x, y = (a.ravel() for a in np.meshgrid(columns, heights))
        profiles = self.slices(heights)
        cells = (np.arange(profiles.shape[1]) + 0.5) * self.half_width / profiles.shape[1]
        temperature = np.concatenate([np.interp(columns, cells, profile) for profile in profiles])

        in_tube = (y > self.nozzle_mouth) & (x < self.bore + DUMMY_COLUMNS * dx)
        points = np.column_stack([x, y, np.zeros_like(x)])
        strand, withdrawn = ~in_tube & (y > 0.0), y <= 0.0
        down = (0.0, -self.casting_speed, 0.0)
        particles.add(points[strand], Role.FREE, STEEL, temperature[strand], down)
        particles.add(points[withdrawn], Role.OUTFLOW, STEEL, temperature[withdrawn], down)

        filling = lattice((0.0, 0.0), (self.bore, top - self.nozzle_mouth), dx)
        filling[:, 1] = top - filling[:, 1] + 0.5 * dx
        filling = filling[filling[:, 1] > self.nozzle_mouth]
        particles.add(filling, Role.INFLOW, STEEL, self.pouring_temperature)
        reserve = np.tile([[0.0, top, 0.0]], (len(x) // 5, 1))
        particles.add(reserve, Role.RESERVOIR, STEEL, self.pouring_temperature)

    def _add_walls(self, particles: Particles, plane: SymmetryPlane) -> None:
        dx, W = self.spacing, self.half_width
        rim = self.mould_top + 0.02
        mould = lattice((W, self.mould_bottom), (W + MOULD_COLUMNS * dx, self.mould_top), dx)
        outermost = mould[:, 0] > W + (MOULD_COLUMNS - 1) * dx
        particles.add(mould, Role.WALL, MOULD, COOLING_WATER, held=outermost)
        plane.add_dummies(particles, lattice((-DUMMY_COLUMNS * dx, -7 * dx), (0.0, rim), dx), DUMMY)
        tube = lattice((self.bore, self.nozzle_mouth), (self.bore + DUMMY_COLUMNS * dx, rim), dx)
        particles.add(tube, Role.DUMMY, DUMMY)
        for middle in np.arange(self.roll_first, -2 * dx, -self.roll_pitch):
            low, high = middle - 0.5 * self.roll_size, middle + 0.5 * self.roll_size
            particles.add(lattice((W, low), (W + DUMMY_COLUMNS * dx, high), dx), Role.DUMMY, DUMMY)

    def _add_spray(self, particles: Particles) -> Spray:
        flow = self.spray_flux * self.mould_bottom
        edges = np.linspace(self.mould_bottom, 0.0, self.spray_zones + 1)
        zones = [
            SprayZone(
                low=low,
                high=high,
                rate=flow / self.spray_zones / self.spray_particle,
                off=self.spray_failure if self.spray_failure is not None and k + 1 in self.spray_failing else 1.0e9,
            )
            for k, (high, low) in enumerate(pairwise(edges))
        ]
        nozzle = self.half_width + SPRAY_DISTANCE
        under_way = SPRAY_DISTANCE / self.spray_speed + LONGEST_RIDE
        reserve = int(flow / self.spray_particle * under_way) + 10
        parked = np.tile([[nozzle, 0.0, 0.0]], (reserve, 1))
        volume = self.spray_particle / WATER.density
        particles.add(parked, Role.RESERVOIR, SPRAY_WATER, SPRAY_TEMPERATURE, flows=False, volume=volume)
        return Spray(
            zones,
            nozzle,
            self.spray_speed,
            reach=1.2 * self.spacing,
            lost=0.5 * self.half_width,
            temperature=SPRAY_TEMPERATURE,
            boiled=SPRAY_BOILED,
            material=SPRAY_WATER,
        )
