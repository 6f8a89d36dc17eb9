"""A circle of inviscid fluid that stretches to an ellipse: what is kept of energy, area and momentum."""

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
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.flow.ellipse import StretchedEllipse
from warpsph.scenarios.flow.formulation import Formulation, disordered, gained_momentum


class FreePatch(Scenario):
    """A circular patch in the plane, in a vacuum and without viscosity, that starts with u = (A x, -A y)."""

    name = "free_patch"
    summary = "a circle of inviscid fluid stretches to an ellipse"
    source = "Monaghan (1994); exact semi-axes of an ordinary differential equation"
    presets = ("fine",)

    duration: float = parameter(1.0, "s", "physical time to simulate", gt=0, le=1e3)
    output_interval: float = parameter(0.05, "s", "physical time between two frames and diagnostics", gt=0, le=1e3)
    formulation: Formulation = parameter(
        Formulation.CORRECTED,
        "",
        "equations of the flow: corrected, delta (classic delta-SPH), summed (as published) or continuity",
    )
    rows: int = parameter(50, "", "particles over the diameter", ge=10, le=2000)
    start: Literal["regular", "disordered"] = parameter(
        "regular",
        "",
        "arrangement at the start: a lattice, or one moved by up to a tenth of a spacing",
    )
    radius: float = parameter(1.0, "m", "radius of the circle, R", ge=1e-3, le=1e3)
    rate: float = parameter(1.0, "1/s", "rate of stretching at the start, A", ge=1e-3, le=1e3)
    density: float = parameter(1.0, "kg/m^3", "reference density", ge=1e-3, le=2e4)
    sound_speed: float = parameter(15.0, "", "speed of sound over A R", ge=5.0, le=100.0)

    @property
    def exact(self) -> StretchedEllipse:
        return StretchedEllipse(self.radius, self.rate)

    @property
    def _sound(self) -> float:
        return self.sound_speed * self.rate * self.radius

    def build(self, executor: Executor) -> Simulation:
        R, dx = self.radius, 2.0 * self.radius / self.rows
        model = Model(
            dimension=2,
            spacing=dx,
            materials=(fluid_material("fluid", self.density),),
            terms=tuple(self.formulation.terms(self.density, self._sound, free_surface=True, viscous=False)),
            gravity=(0.0, 0.0, 0.0),
        )
        points = lattice((-R, -R), (R, R), dx)
        points = points[np.linalg.norm(points, axis=1) < R]
        if self.start == "disordered":
            points = disordered(points, dx, 2)
        particles = Particles()
        fields = self.formulation.start(self.exact.pressure(points, self.density), self.density, self._sound)
        particles.add(points, Role.FREE, velocity=self.rate * points * (1.0, -1.0, 0.0), **fields)
        room = 4.0 * R
        return Simulation(executor, model, particles, lower=(-room,) * 3, upper=(room,) * 3, observe=self._observe)

    def _observe(self, state: Snapshot, time: float) -> Values:
        mass, x, u = (state[name].astype(float) for name in ("mass", "position", "velocity"))
        x -= x.mean(axis=0)
        length, width = 2.0 * np.sqrt(np.mean(x[:, :2] ** 2, axis=0))
        work = self.formulation.elastic_energy(state, self.density, self._sound, free_surface=True)
        energy = 0.5 * float(np.sum(mass[:, None] * u**2)) + work
        speed = self.rate * self.radius
        momentum = mass @ u / (mass.sum() * speed)
        spin = np.sum(mass * (x[:, 0] * u[:, 1] - x[:, 1] * u[:, 0])) / (mass.sum() * speed * self.radius)
        axes, drift = "semi-axes by the second moments", "momentum over mass times A R, and A R^2"
        return {
            "length": Measured(float(length), "m", "long", panel=axes),
            "width": Measured(float(width), "m", "short", panel=axes),
            "area": Measured(float(np.pi * length * width), "m^2", "area by the second moments"),
            "total_energy": Measured(energy, "J", "kinetic and elastic energy", per_depth=True),
            "momentum_x": Measured(float(momentum[0]), "", "along x", panel=drift),
            "momentum_y": Measured(float(momentum[1]), "", "along y", panel=drift),
            "spin": Measured(float(spin), "", "angular", panel=drift),
        }

    def change(self, result: Result, name: str) -> float:
        """Relative change of a diagnostic from start to end."""
        return float(result.diagnostics[name][-1] / result.diagnostics[name][0]) - 1.0

    def checks(self, result: Result) -> list[Check]:
        series, name = result.diagnostics, f"{self.rows} rows, {self.start}: "
        exact = "exact for an incompressible fluid without viscosity"
        half_length, half_width = self.exact.semi_axes(series["time"])[-1] / self.radius
        turned = float(np.abs(series["spin"] - series["spin"][0]).max())
        third = "Newton's third law"
        return [
            Check(
                self.name, f"{name}change of the kinetic energy", "", self.change(result, "kinetic_energy"),
                None, 0.005, exact,
                reason="artificial viscosity on what is not linear in space: on the surface, and on sound",
            ),
            Check(
                self.name, f"{name}change of the area", "", self.change(result, "area"), None, 0.01, exact,
                reason="particles at the surface order themselves anew: a tenth of a spacing of 25, twice",
            ),
            Check(
                self.name, f"{name}half length over that at the start", "", 1.0 + self.change(result, "length"),
                half_length, 0.01, exact, reason="as the energy, and half the area",
            ),
            Check(
                self.name, f"{name}half width over that at the start", "", 1.0 + self.change(result, "width"),
                half_width, 0.01, exact, reason="as the energy, and half the area",
            ),
            Check(
                self.name, f"{name}largest change of the momentum, over mass times A R", "",
                gained_momentum(result), None, 2e-3, third,
                reason="corrected gradients are not antisymmetric in a pair: they keep momentum to their own error",
            ),
            Check(
                self.name, f"{name}largest change of the angular momentum, over mass times A R^2", "",
                turned, None, 2e-3, third, reason="the same",
            ),
        ]  # fmt: skip

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Both starts; with ``slow``, at half the spacing too."""
        cases = [cls(), cls(start="disordered")]
        if slow:
            cases += [cls(rows=100), cls(rows=100, start="disordered")]
        for case in cases:
            yield from case.checks(simulate(case))
