"""A column of water collapses and hits the far wall: levels and pressures against those of an experiment."""

import numpy as np
from pydantic import model_validator

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import GRAVITY, Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.flow.lobovsky import EXPERIMENT, GAUGES, SENSORS, published_level, published_pressure
from warpsph.terms import CorrectedFluid, WallFriction

ARRIVED = 0.1  # part of rho g H at which the wave is at a sensor: five times the noise of the experiment
GAP = 2.0  # spacings between the water and what flies above it
PLATEAU = (3.5, 5.5)  # between the impact and the wave that comes back, over sqrt(H / g)


class DamImpact(Scenario):
    """Water that rubs along smooth walls; its column is 0.6 m wide and 0.3 m high in a tank 1.61 m long."""

    name = "dam_impact"
    summary = "a column of water collapses and hits a wall: levels and pressures of an experiment"
    source = EXPERIMENT
    presets = ("coarse",)

    duration: float = parameter(1.23, "s", "physical time to simulate", gt=0, le=100.0)
    output_interval: float = parameter(3.5e-3, "s", "physical time between two frames and diagnostics", gt=0, le=100.0)
    rows: int = parameter(80, "", "rows of particles over the height of the column", ge=8, le=400)
    height: float = parameter(0.3, "m", "height H of the column", ge=0.01, le=10.0)
    width: float = parameter(0.6, "m", "width of the column", ge=0.01, le=10.0)
    length: float = parameter(1.61, "m", "length of the tank, rounded to the spacing", ge=0.02, le=100.0)
    density: float = parameter(997.0, "kg/m^3", "density of the water", ge=1.0, le=2e4)
    viscosity: float = parameter(
        8.9e-4, "Pa s", "dynamic viscosity of the water; with 0 it does not rub at walls", ge=0.0, le=100.0
    )
    sound_ratio: float = parameter(10.0, "", "speed of sound over sqrt(2 g H)", ge=5.0, le=100.0)
    sensor: float = parameter(4.2e-3, "m", "diameter over which a sensor averages", gt=0.0, le=0.1)

    @model_validator(mode="after")
    def _refuse_what_fits_not(self) -> "DamImpact":
        if not 1 <= round(self.width / self.spacing) <= round(self.length / self.spacing):
            raise ValueError(
                f"width = {self.width:g} m: must be at least a spacing of {self.spacing:g} m, and at most the "
                f"length of the tank, {self.length:g} m"
            )
        return self

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.height / self.rows

    @property
    def end(self) -> float:
        """Where the end wall has its face [m]."""
        return round(self.length / self.spacing) * self.spacing

    @property
    def moment(self) -> float:
        """The unit of time sqrt(H / g) [s]."""
        return float(np.sqrt(self.height / GRAVITY))

    @property
    def load(self) -> float:
        """The unit of pressure rho g H [Pa]."""
        return self.density * GRAVITY * self.height

    def build(self, executor: Executor) -> Simulation:
        H, dx = self.height, self.spacing
        sound_speed = self.sound_ratio * np.sqrt(2.0 * GRAVITY * H)
        model = Model(
            dimension=2,
            spacing=dx,
            materials=(fluid_material("water", self.density, self.viscosity), solid_material("tank", self.density)),
            terms=(CorrectedFluid(self.density, sound_speed, free_surface=True), WallFriction()),
        )
        water = lattice((0.0, 0.0), (self.width, H), dx)
        walls = tank((0.0, 0.0), (self.end, 4.0 * H), dx)
        pressure = self.density * GRAVITY * (H - water[:, 1])
        particles = Particles()
        compression = pressure / (self.density * sound_speed**2)
        particles.add(water, Role.FREE, "water", pressure=pressure, compression=compression)
        particles.add(walls, Role.DUMMY, "tank", to_surface=way_to_box(walls, (0.0, 0.0, 0.0), (self.end, np.inf, 0.0)))
        lower, upper = (-H, -H, -dx), (self.end + H, 6.0 * H, dx)
        return Simulation(executor, model, particles, lower=lower, upper=upper, observe=self._observe)

    def _observe(self, state: Snapshot, time: float) -> Values:
        x, dx = state["position"].astype(float), self.spacing
        water = state["role"] == Role.FREE
        wall = np.flatnonzero(~water & (x[:, 0] > self.end) & (x[:, 0] < self.end + dx))
        wall = wall[np.argsort(x[wall, 1])]
        x_water = x[water]
        values: Values = {}
        for name, height in SENSORS.items():
            across = height + self.sensor * np.linspace(-0.5, 0.5, 5)
            along = np.interp(across, x[wall, 1], state["pressure"][wall].astype(float)) if len(wall) else [np.nan]
            mean = float(np.mean(along))
            values[name] = Measured(mean / self.load, "", f"{1e3 * height:g} mm", panel="pressure over rho g H")
        for name, place in GAUGES.items():
            column = x_water[np.abs(x_water[:, 0] - place) < dx, 1]
            level = top_of_water(column, dx) / self.height
            values[name] = Measured(level, "", f"x = {place:g} m", panel="level over H")
        outside = (x_water[:, 0] < 0.0) | (x_water[:, 0] > self.end) | (x_water[:, 1] < 0.0)
        values["escaped"] = Measured(float(np.sum(outside)), "", "particles outside the tank")
        return values

    def checks(self, result: Result) -> list[Check]:
        series, rows = result.diagnostics, [self._escaped(result)]
        time = series["time"] / self.moment
        for name in SENSORS:
            measured, published = arrival(time, series[name]), arrival(*published_pressure(name))
            if measured is not None and published is not None:
                rows.append(
                    self._row(
                        f"arrival of the pressure {1e3 * SENSORS[name]:g} mm up the wall, over sqrt(H / g)",
                        measured,
                        published,
                        0.03,
                        "the gate of the experiment takes time to rise: measured levels lag by 0.05",
                    )
                )
        for name in SENSORS:
            if time[-1] > PLATEAU[1]:
                rows.append(
                    self._row(
                        f"pressure after the impact {1e3 * SENSORS[name]:g} mm up the wall, over rho g H",
                        mean_between(time, series[name]),
                        mean_between(*published_pressure(name)),
                        0.15,
                        "a boundary layer on the bed a row or two thick, no side walls, and no air",
                    )
                )
        for name, place in GAUGES.items():
            at, level = published_level(name)
            compared = at < min(time[-1], PLATEAU[1])
            errors = np.abs(np.interp(at, time, series[name]) - level)[compared]
            rows.append(
                Check(
                    self.name,
                    self._named(f"mean error of the level at x = {place:g} m, over H"),
                    "",
                    float(errors.mean()),
                    None,
                    0.05,
                    EXPERIMENT,
                    reason="the gate's delay times the speed of the level",
                )
            )
        return rows

    def _named(self, quantity: str) -> str:
        return f"{quantity} ({self.rows} rows)"

    def _row(self, quantity: str, measured: float, reference: float, tolerance: float, reason: str) -> Check:
        return Check(self.name, self._named(quantity), "", measured, reference, tolerance, EXPERIMENT, reason=reason)

    def _escaped(self, result: Result) -> Check:
        most = float(result.diagnostics["escaped"].max())
        return Check(self.name, self._named("particles outside the tank"), "", most, None, 0.0, "a tank is tight")


def top_of_water(heights: np.ndarray, spacing: float) -> float:
    """Level [m] of water on the bed from the ``heights`` (n,) [m] of its particles; drops in flight do not count."""
    rows = np.concatenate(([-0.5 * spacing], np.sort(heights)))
    gaps = np.flatnonzero(np.diff(rows) > GAP * spacing)
    return float(rows[gaps[0]] if len(gaps) else rows[-1]) + 0.5 * spacing


def arrival(time: np.ndarray, pressure: np.ndarray) -> float | None:
    """When a pressure (n,) over rho g H first comes to :data:`ARRIVED`, None if it does not."""
    over = np.flatnonzero(pressure > ARRIVED)
    if len(over) == 0 or over[0] == 0:
        return None
    step = slice(over[0] - 1, over[0] + 1)
    return float(np.interp(ARRIVED, pressure[step], time[step]))


def mean_between(time: np.ndarray, values: np.ndarray) -> float:
    """Mean of values (n,) over the :data:`PLATEAU`."""
    return float(values[(time > PLATEAU[0]) & (time < PLATEAU[1])].mean())
