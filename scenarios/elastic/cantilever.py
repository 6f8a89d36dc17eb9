"""A plate of rubber, clamped at one end, swings: its period, its amplitude and its energy."""

import csv
from collections.abc import Callable, Iterable
from importlib.resources import files

import numpy as np
from pydantic import model_validator

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.diagnostics import strain_energy
from warpsph.run.measured import Measured, Values
from warpsph.run.recorder import Observe
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.terms import Elasticity

FIRST_MODE = 1.8751040687  # k L of the first mode of a slender beam: cos(k L) cosh(k L) = -1
SHORTEST = 4  # columns, of which one is held and two tell of the tip
REFERENCE = "own spectral elements, large deflection"


class Cantilever(Scenario):
    """A plate of 20 cm by 2 cm, clamped at x = 0, starts flat with the velocities of the first mode of a beam."""

    name = "cantilever"
    summary = "a clamped plate of rubber swings: period, amplitude, energy"
    source = "Gray, Monaghan & Swift (2001), oscillating plate; own spectral elements"

    duration: float = parameter(0.8, "s", "physical time to simulate", gt=0, le=100.0)
    output_interval: float = parameter(2e-3, "s", "physical time between two frames and diagnostics", gt=0, le=10.0)
    length: float = parameter(0.2, "m", "length L of the plate outside the clamp", ge=0.01, le=10.0)
    thickness: float = parameter(0.02, "m", "thickness of the plate", ge=0.001, le=1.0)
    layers: int = parameter(10, "", "particles over the thickness", ge=3, le=100)
    density: float = parameter(1000.0, "kg/m^3", "density", ge=1.0, le=2e4)
    youngs_modulus: float = parameter(2.0e6, "Pa", "Young's modulus", ge=1.0, le=1e12)
    poisson_ratio: float = parameter(0.3975, "", "Poisson's ratio", ge=0.0, lt=0.5)
    speed: float = parameter(0.05, "", "speed of the tip at the start over sqrt(K / rho)", gt=0, le=0.2)

    support_ratio: float = parameter(1.5, "", "support of the smoothing kernel over the spacing", ge=1.5, le=4.0)
    hourglass: float = parameter(0.1, "", "strength of the hourglass control", ge=0.0, le=10.0)

    @model_validator(mode="after")
    def _check_length(self) -> "Cantilever":
        if self.length < SHORTEST * self.spacing:
            raise ValueError(
                f"thickness = {self.thickness}: a plate as short as length {self.length} m has less than {SHORTEST} "
                f"columns of {self.layers} layers; a longer or thinner plate, or more layers"
            )
        return self

    @property
    def spacing(self) -> float:
        """Particle spacing [m]."""
        return self.thickness / self.layers

    @property
    def tip_speed(self) -> float:
        """Speed [m/s] of the tip at the start."""
        bulk_modulus = self.youngs_modulus / (3.0 * (1.0 - 2.0 * self.poisson_ratio))
        return self.speed * float(np.sqrt(bulk_modulus / self.density))

    def build(self, executor: Executor) -> Simulation:
        dx, half = self.spacing, 0.5 * self.thickness
        elasticity = Elasticity(self.youngs_modulus, self.poisson_ratio, hourglass=self.hourglass)
        model = Model(
            dimension=2,
            spacing=dx,
            support_ratio=self.support_ratio,
            materials=(solid_material("rubber", self.density),),
            gravity=(0.0, 0.0, 0.0),
            terms=(elasticity,),
        )
        # The gradient over bonds reaches from one spacing on this side to one on that side, so that what is held
        # acts on average one spacing behind the first particle that is free: the first column is held, too.
        free = lattice((dx, -half), (self.length, half), dx)
        held = lattice((dx - np.ceil(self.support_ratio) * dx, -half), (dx, half), dx)
        velocity = np.zeros_like(free)
        velocity[:, 1] = self.tip_speed * first_mode(free[:, 0] / self.length)
        particles = Particles()
        particles.add(free, Role.FREE, velocity=velocity, phase=Phase.SOLID)
        particles.add(held, Role.WALL, phase=Phase.SOLID)
        reach = self.length + half
        lower, upper = (-4.0 * dx, -reach, -dx), (reach, reach, dx)
        return Simulation(
            executor, model, particles, lower=lower, upper=upper, observe=self._observer(free, elasticity)
        )

    def _observer(self, free: np.ndarray, elasticity: Elasticity) -> Observe:
        middle = np.abs(free[:, 1]) < 0.6 * self.spacing
        columns_from_tip = (self.length - free[:, 0]) / self.spacing
        last, second = (np.flatnonzero(middle & (np.abs(columns_from_tip - k) < 0.5)) for k in (0.5, 1.5))

        def observe(state: Snapshot, time: float) -> Values:
            y = state["position"][:, 1].astype(float)
            tip = float(1.5 * y[last].mean() - 0.5 * y[second].mean())
            return {
                "tip": Measured(tip, "m", "deflection of the tip"),
                "strain_energy": strain_energy(state, elasticity),
            }

        return observe

    def checks(self, result: Result) -> list[Check]:
        series, width = result.diagnostics, f"{self.layers} particles across"
        rows = []
        if self.speed in (known := spectral_elements()) and self == self.model_copy(update=_defaults()):
            tolerance = 0.02 * (10.0 / self.layers) ** 2
            reason = (
                "second order in the spacing: strain is measured inside of the faces and summed by the midpoint rule"
            )
            for quantity, unit, measured, reference in zip(
                (f"period, {width}", f"largest deflection of the tip, {width}"),
                ("s", "m"),
                (period(series["time"], series["tip"]), float(np.abs(series["tip"]).max())),
                known[self.speed],
                strict=True,
            ):
                rows.append(Check(self.name, quantity, unit, measured, reference, tolerance, REFERENCE, reason=reason))
        energy = series["kinetic_energy"] + series["strain_energy"]
        rows.append(
            Check(
                self.name,
                f"largest change of kinetic and elastic energy, {width}",
                "",
                float(np.abs(energy / energy[0] - 1.0).max()),
                None,
                2e-3,
                "conservation of energy",
                reason="hourglass control holds some energy while the plate is bent; both are half a step apart",
            )
        )
        return rows

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Two or three spacings, and the order at which the error of the period falls."""
        errors = {}
        for layers in (6, 10, 20) if slow else (6, 10):
            scenario = cls(layers=layers)
            rows = scenario.checks(simulate(scenario))
            errors[layers] = rows[0].error
            yield from rows
        coarse, fine = list(errors)[-2:]
        yield Check(
            cls.name,
            f"order at which the error of the period falls from {coarse} to {fine} particles across",
            "",
            float(np.log(errors[coarse] / errors[fine]) / np.log(fine / coarse)),
            2.0,
            0.25,
            REFERENCE,
            reason="the midpoint rule over the thickness and the gradient over bonds are of second order",
        )


def first_mode(s: np.ndarray | float) -> np.ndarray:
    """First mode of a slender beam at s = x / L, 1 at the free end (Gray, Monaghan & Swift 2001)."""

    def shape(s: np.ndarray | float) -> np.ndarray:
        even, odd = np.cosh(FIRST_MODE * s) - np.cos(FIRST_MODE * s), np.sinh(FIRST_MODE * s) - np.sin(FIRST_MODE * s)
        a, b = np.cos(FIRST_MODE) + np.cosh(FIRST_MODE), np.sin(FIRST_MODE) - np.sinh(FIRST_MODE)
        return a * even + b * odd

    return shape(s) / shape(1.0)


def period(time: np.ndarray, deflection: np.ndarray) -> float:
    """Mean time [s] between the zeros at which a deflection that is 0 at first rises again, interpolated, or NaN."""
    before = np.flatnonzero((deflection[:-1] < 0.0) & (deflection[1:] >= 0.0))
    zeros = time[before] - deflection[before] * np.diff(time)[before] / np.diff(deflection)[before]
    return float((zeros[-1] - time[0]) / len(zeros)) if len(zeros) else np.nan


def spectral_elements() -> dict[float, tuple[float, float]]:
    """Period [s] and largest deflection of the tip [m] by ``speed``, from ``data/cantilever.csv``."""
    text = (files("warpsph.scenarios.elastic") / "data" / "cantilever.csv").read_text()
    return {
        float(row["speed_over_sound"]): (float(row["period_s"]), float(row["largest_tip_deflection_m"]))
        for row in csv.DictReader(text.splitlines())
    }


def _defaults() -> dict[str, float]:
    """The plate of the reference."""
    fields = Cantilever.model_fields
    return {key: fields[key].default for key in ("length", "thickness", "density", "youngs_modulus", "poisson_ratio")}
