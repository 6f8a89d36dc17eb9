"""Air in a square box between a hot and a cold wall: what it carries across."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import GRAVITY, Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.run.statistics import highest
from warpsph.terms import Buoyancy, CorrectedConduction, CorrectedFluid, HeatWall

LAYERS = 3  # of particles in the walls
SOUND_RATIO = 3.5  # speed of sound over sqrt(g beta dT L); the highest speed is a quarter of that root
DENSITY, HEAT_CAPACITY = 1.2, 1005.0  # of air [kg/m^3], [J/(kg K)]
DE_VAHL_DAVIS = {  # Rayleigh number: mean Nusselt number, highest horizontal and vertical speed in kappa / L
    1e3: (1.118, 3.649, 3.697),
    1e4: (2.243, 16.178, 19.617),
    1e5: (4.519, 34.73, 68.59),
}
COMPARED = (  # and how near the source it is to be at 40 rows
    ("mean Nusselt number", "", 0.02),
    ("highest horizontal speed on the upright midline", "kappa/L", 0.03),
    ("highest vertical speed on the level midline", "kappa/L", 0.03),
)
STEADY = 0.25  # of the duration, at its end, over which heat is measured


class NaturalConvection(Scenario):
    """A square box, left wall hot, right wall cold, floor and ceiling insulated; Rayleigh's number makes its size.

    The pressure counts from that of air at rest, so the model has no gravity but in the buoyancy.
    """

    name = "natural_convection"
    summary = "air in a box between a hot and a cold wall turns over and carries heat"
    source = "de Vahl Davis (1983)"
    presets = ("weak", "strong")

    duration: float = parameter(8.0, "s", "physical time to simulate", gt=0, le=1e4)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e4)
    rayleigh: float = parameter(1e4, "", "Rayleigh number g beta dT L^3 / (nu kappa)", ge=1.0, le=1e6)
    prandtl: float = parameter(0.71, "", "Prandtl number nu / kappa", ge=0.1, le=100.0)
    rows: int = parameter(40, "", "rows of particles", ge=10, le=400)
    difference: float = parameter(10.0, "K", "between the hot and the cold wall", ge=1.0, le=100.0)
    mean: float = parameter(300.0, "K", "mean temperature of the two; expansion is one over it", ge=100.0, le=1000.0)
    diffusivity: float = parameter(2.2e-5, "m^2/s", "thermal diffusivity kappa", ge=1e-8, le=1e-2)

    @property
    def viscosity(self) -> float:
        """Kinematic viscosity nu [m^2/s]."""
        return self.prandtl * self.diffusivity

    @property
    def lift(self) -> float:
        """Buoyant acceleration [m/s^2] g beta dT."""
        return GRAVITY * self.difference / self.mean

    @property
    def length(self) -> float:
        """Edge L [m] of the box."""
        return float(np.cbrt(self.rayleigh * self.viscosity * self.diffusivity / self.lift))

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.length / self.rows

    @property
    def conductivity(self) -> float:
        """Thermal conductivity [W/(m K)]."""
        return self.diffusivity * DENSITY * HEAT_CAPACITY

    def build(self, executor: Executor) -> Simulation:
        L, dx = self.length, self.spacing
        hot, cold = self.mean + 0.5 * self.difference, self.mean - 0.5 * self.difference
        viscosity = DENSITY * self.viscosity
        faces = (
            HeatWall.at_temperature((1, 0, 0), 0.0, hot),
            HeatWall.at_temperature((-1, 0, 0), -L, cold),
            HeatWall.insulated((0, 1, 0), 0.0),
            HeatWall.insulated((0, -1, 0), -L),
        )
        conduction = CorrectedConduction(walls=faces, longest_interval=self.output_interval)
        air = fluid_material(
            "air", DENSITY, viscosity, conductivity=self.conductivity, heat_capacity=HEAT_CAPACITY, source=self.source
        )
        flow = CorrectedFluid(DENSITY, SOUND_RATIO * float(np.sqrt(self.lift * L)))
        model = Model(
            dimension=2,
            spacing=dx,
            materials=(air, solid_material("wall", DENSITY, viscosity)),
            terms=(flow, conduction, Buoyancy(1.0 / self.mean, self.mean, gravity=(0.0, -GRAVITY, 0.0))),
            gravity=(0.0, 0.0, 0.0),
        )
        fluid, frame = lattice((0.0, 0.0), (L, L), dx), lattice((-LAYERS * dx,) * 2, (L + LAYERS * dx,) * 2, dx)
        to_surface = way_to_box(frame, (0.0, 0.0, 0.0), (L, L, 0.0))
        outside = np.linalg.norm(to_surface, axis=1) > 0.0
        particles = Particles()
        particles.add(fluid, Role.FREE, "air", temperature=hot - self.difference * fluid[:, 0] / L)
        particles.add(frame[outside], Role.DUMMY, "wall", to_surface=to_surface[outside], temperature=self.mean)
        return Simulation(executor, model, particles, observe=_Observer(self, conduction))

    def speeds(self, result: Result) -> tuple[float, float]:
        """Highest horizontal speed on the upright midline, and vertical speed on the level one [kappa / L]."""
        air = result.made_of("air")
        x, u = result.positions[air, :2].astype(float), result.fields["velocity"][air, :2].astype(float)
        line = np.linspace(0.0, self.length, 4 * self.rows + 1)
        middle = np.full_like(line, 0.5 * self.length)
        across = fitted(x, u[:, 0], np.column_stack([middle, line]), 1.5 * self.spacing)
        upward = fitted(x, u[:, 1], np.column_stack([line, middle]), 1.5 * self.spacing)
        scale = self.length / self.diffusivity
        return float(across.max()) * scale, float(upward.max()) * scale

    def checks(self, result: Result) -> list[Check]:
        time, last = result.diagnostics["time"], result.diagnostics["time"][-1]
        begin = int(np.searchsorted(time, (1.0 - STEADY) * last))
        spent = self.conductivity * self.difference * (time[-1] - time[begin])
        given, taken = (
            float(result.diagnostics[name][-1] - result.diagnostics[name][begin]) / spent
            for name in ("heat_from_hot_wall", "heat_to_cold_wall")
        )
        label = f"Ra {self.rayleigh:g}, {self.rows} rows"
        rows = [
            Check(
                self.name, f"heat that the cold wall takes over that of the hot one ({label})", "", taken, given, 0.005,
                "conservation of energy",
                reason="0.1 % by shifted particles, and what is not steady yet",
            )
        ]  # fmt: skip
        if self.rayleigh not in DE_VAHL_DAVIS or self.prandtl != 0.71:
            return rows
        coarse = (40.0 / self.rows) ** 2 * float(np.sqrt(self.rayleigh / 1e4))
        reason = "second order in the spacing over the layers at the walls, which thin with the fourth root of Ra"
        measured = (0.5 * (given + taken), *self.speeds(result))
        for (quantity, unit, tolerance), value, reference in zip(
            COMPARED, measured, DE_VAHL_DAVIS[self.rayleigh], strict=True
        ):
            allowed = max(tolerance, 0.008 * coarse)
            rows.append(
                Check(
                    self.name, f"{quantity} ({label})", unit, value, reference, allowed, self.source, reason=reason
                )
            )  # fmt: skip
        return rows

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Rayleigh numbers 1e3 and 1e4, and 1e5 where there is time."""
        for preset in (None, *cls.presets) if slow else (None, "weak"):
            case = resolve(cls, [preset_layer(cls, preset)] if preset else [])
            yield from case.checks(simulate(case))


class _Observer:
    """What passes the walls, and what the flow carries."""

    def __init__(self, case: NaturalConvection, conduction: CorrectedConduction):
        self.case, self.conduction = case, conduction

    def __call__(self, state: Snapshot, time: float) -> Values:
        case = self.case
        air = state["role"] == Role.FREE
        u = state["velocity"][air].astype(float)
        warmer = state["temperature"][air].astype(float) - case.mean
        carried = float(np.mean(u[:, 0] * warmer)) * case.length / (case.diffusivity * case.difference)
        hot, cold = self.conduction.heat_to_walls()[:2]
        speed = highest(np.linalg.norm(u, axis=1)) * case.length / case.diffusivity
        taken: dict[str, Any] = {"per_depth": True, "panel": "heat through the walls"}
        return {
            "nusselt": Measured(1.0 + carried, "", "Nusselt number, mean over the box"),
            "heat_from_hot_wall": Measured(-float(hot), "J", "from the hot wall", **taken),
            "heat_to_cold_wall": Measured(float(cold), "J", "to the cold wall", **taken),
            "peclet": Measured(speed, "", "highest speed over kappa / L"),
        }


def fitted(points: np.ndarray, values: np.ndarray, places: np.ndarray, width: float) -> np.ndarray:
    """Values (k,) at ``places`` (k, 2) [m]: fits of second degree to ``values`` (n,) at ``points`` (n, 2) [m].

    Points are weighted by a Gaussian of the ``width`` [m].
    """
    found = np.empty(len(places))
    for k, place in enumerate(places):
        d = (points - place) / width
        near = np.sum(d**2, axis=1) < 9.0
        weight = np.exp(-0.5 * np.sum(d[near] ** 2, axis=1))
        basis = np.column_stack([np.ones(np.sum(near)), d[near], d[near] ** 2])
        found[k] = np.linalg.lstsq(basis * weight[:, None], values[near] * weight, rcond=None)[0][0]
    return found
