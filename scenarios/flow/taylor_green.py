"""Vortices in a periodic box: how fast viscosity alone stops them, against the exact solution of Taylor & Green."""

from collections.abc import Callable, Iterable
from typing import Literal

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.flow.formulation import Formulation, disordered, gained_momentum

EXACT = "exp(-8 pi^2 nu t / L^2), exact for an incompressible fluid (Taylor & Green 1937)"
DEPTH = 10  # rows of a box in space, the fewest that a periodic box can have


class TaylorGreen(Scenario):
    """Four vortices in a periodic square of fluid, or in a flat periodic box, that viscosity slows down."""

    name = "taylor_green"
    summary = "vortices in a periodic box decay"
    source = "Taylor & Green (1937), exact solution in the plane"
    presets = ("fine", "space")

    duration: float = parameter(1.0, "s", "physical time to simulate", gt=0, le=1e3)
    output_interval: float = parameter(0.05, "s", "physical time between two frames and diagnostics", gt=0, le=1e3)
    dimension: Literal[2, 3] = parameter(2, "", "2: in the plane; 3: in a flat box, ten particles deep")
    formulation: Formulation = parameter(
        Formulation.CORRECTED,
        "",
        "equations of the flow: corrected, delta (classic delta-SPH), summed (as published) or continuity",
    )
    rows: int = parameter(50, "", "particles along each edge of the square", ge=10, le=2000)
    start: Literal["regular", "disordered"] = parameter(
        "regular",
        "",
        "arrangement at the start: a lattice, or one moved by up to a tenth of a spacing",
    )
    reynolds: float = parameter(100.0, "", "Reynolds number U L / nu", gt=0, le=1e6)
    length: float = parameter(1.0, "m", "edge of the square, L", ge=1e-3, le=1e3)
    speed: float = parameter(1.0, "m/s", "highest speed at the start, U", ge=1e-3, le=1e3)
    density: float = parameter(1.0, "kg/m^3", "reference density", ge=1e-3, le=2e4)
    sound_speed: float = parameter(10.0, "", "speed of sound over the highest speed", ge=5.0, le=100.0)

    @property
    def rate(self) -> float:
        """Exact decay of the velocity [1/s]."""
        return 8.0 * np.pi**2 * self.speed / (self.reynolds * self.length)

    def shape(self, points: np.ndarray) -> np.ndarray:
        """Velocity (n, 3) at the start over the highest one, at points (n, 3) [m]."""
        x, y = (2.0 * np.pi / self.length * points[:, axis] for axis in (0, 1))
        return np.column_stack([-np.cos(x) * np.sin(y), np.sin(x) * np.cos(y), np.zeros(len(points))])

    def build(self, executor: Executor) -> Simulation:
        dx, c = self.length / self.rows, self.sound_speed * self.speed
        size = (self.length, self.length, DEPTH * dx)[: self.dimension]
        viscosity = self.density * self.speed * self.length / self.reynolds
        model = Model(
            dimension=self.dimension,
            spacing=dx,
            materials=(fluid_material("fluid", self.density, viscosity),),
            terms=tuple(self.formulation.terms(self.density, c)),
            gravity=(0.0, 0.0, 0.0),
            periodic=PeriodicBox((0.0, 0.0, 0.0), (*size, 0.0)[:3]),
        )
        points = lattice((0.0,) * self.dimension, size, dx)
        if self.start == "disordered":
            points = disordered(points, dx, self.dimension)
        waves = np.cos(4.0 * np.pi / self.length * points[:, :2]).sum(axis=1)
        pressure = -0.25 * self.density * self.speed**2 * waves
        particles = Particles()
        start = self.formulation.start(pressure, self.density, c)
        particles.add(points, Role.FREE, velocity=self.speed * self.shape(points), **start)
        return Simulation(executor, model, particles, observe=self._observe)

    def _observe(self, state: Snapshot, time: float) -> Values:
        mass, x, u = (state[name].astype(float) for name in ("mass", "position", "velocity"))
        mode = self.shape(x)
        amplitude = float(np.sum(u * mode) / np.sum(mode**2)) / self.speed
        noise = np.sqrt(np.sum((u - amplitude * self.speed * mode) ** 2) / np.sum(u**2))
        exact = float(np.exp(-self.rate * time))
        energy = np.sum(mass[:, None] * u**2) / (self.speed * exact) ** 2 / np.sum(mass[:, None] * mode**2)
        momentum = mass @ u / (mass.sum() * self.speed)
        panel = "momentum over that of all at the highest speed"
        return {
            "amplitude": Measured(amplitude, "", "measured", panel="amplitude of the vortices"),
            "exact_amplitude": Measured(exact, "", "exact", panel="amplitude of the vortices"),
            "energy_over_exact": Measured(float(energy), "", "kinetic energy over the exact one"),
            "velocity_noise": Measured(float(noise), "", "velocity beside the vortices, over all"),
            "momentum_x": Measured(float(momentum[0]), "", "along x", panel=panel),
            "momentum_y": Measured(float(momentum[1]), "", "along y", panel=panel),
        }

    def excess(self, result: Result) -> float:
        """Decay rate from start to end over the exact one, less 1."""
        series = result.diagnostics
        return float(np.log(series["amplitude"][0] / series["amplitude"][-1]) / (self.rate * result.time)) - 1.0

    @property
    def _allowed(self) -> float:
        """Error of the decay rate: of second order, and what is compressible at a tenth of the speed of sound."""
        return max(0.02 * (50.0 / self.rows) ** 2, 0.005) if self.reynolds <= 200.0 else 0.05

    def checks(self, result: Result) -> list[Check]:
        name = f"Re {self.reynolds:g}, {self.rows} rows, {self.start}, in {self.dimension}D: "
        measured = (1.0 + self.excess(result)) * self.rate
        return [
            Check(
                self.name, f"{name}decay rate of the velocity", "1/s", measured, self.rate, self._allowed, EXACT,
                reason="second order in the spacing, and some 0.2 % by the compressibility at a tenth of the speed of "
                "sound; without viscosity to speak of the diffusion of the density takes its part",
            ),
            Check(
                self.name, f"{name}largest velocity beside the vortices, over all", "",
                float(result.diagnostics["velocity_noise"].max()), None, 0.01, EXACT,
                reason="sound of the start and the ordering of the particles, a thousandth",
            ),
            Check(
                self.name, f"{name}largest momentum over that of all at the highest speed", "",
                gained_momentum(result), None, 1e-3, "Newton's third law",
                reason="corrected gradients are not antisymmetric in a pair: they keep momentum to their own error",
            ),
        ]  # fmt: skip

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Both starts; with ``slow``, half the spacing too, a higher Reynolds number, and a box in space."""
        excess = {}
        cases = [cls(), cls(start="disordered")]
        if slow:
            cases += [cls(rows=100), cls(rows=100, start="disordered"), cls(rows=40, dimension=3)]
            cases += [cls(rows=200, reynolds=1000.0, duration=2.0)]
        for case in cases:
            result = simulate(case)
            excess[case.rows, case.start] = abs(case.excess(result))
            yield from case.checks(result)
        if slow:
            yield Check(
                cls.name, "error of the decay rate with 100 rows over that with 50, Re 100", "",
                excess[100, "regular"] / excess[50, "regular"], None, 1.0, EXACT,
                reason="what is left at 100 rows is compressibility, which the spacing does not mend",
            )  # fmt: skip
