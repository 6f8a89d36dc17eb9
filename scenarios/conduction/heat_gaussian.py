"""A warm spot that spreads: conduction alone, against the fundamental solution of the heat equation."""

from collections.abc import Callable, Iterable

import numpy as np

from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import Snapshot
from warpsph.run.measured import Measured, Values
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.conduction.time_stepping import ConductingScenario
from warpsph.terms import Conduction

BACKGROUND = 300.0  # temperature far from the spot [K]
HEAT_CAPACITY = 1000.0  # [J/(kg K)]
DENSITY = 1000.0  # [kg/m^3]


class HeatGaussian(ConductingScenario):
    """A square plate at rest, insulated at its edges, with a Gaussian rise of temperature in its middle."""

    name = "heat_gaussian"
    summary = "a Gaussian warm spot spreads in a plate at rest (conduction alone)"
    source = "Vijaykumar (2012), section 3.1.2; fundamental solution of the heat equation"
    presets = ("coarse", "fine")

    duration: float = parameter(5.0, "s", "physical time to simulate", gt=0, le=1e4)
    output_interval: float = parameter(0.5, "s", "physical time between two frames and diagnostics", gt=0, le=1e4)
    spacing: float = parameter(0.01, "m", "particle spacing", ge=1e-3, le=0.05)
    edge: float = parameter(1.0, "m", "edge of the plate", ge=0.5, le=10.0)
    support_ratio: float = parameter(3.0, "", "support of the smoothing kernel over the spacing", ge=2.0, le=6.0)
    diffusivity: float = parameter(1.0e-3, "m^2/s", "thermal diffusivity", gt=0, le=1.0)
    width: float = parameter(0.08, "m", "standard deviation of the spot at the start", ge=0.01, le=1.0)
    rise: float = parameter(1000.0, "K", "rise of temperature in the middle at the start", ge=0.01, le=1e4)

    def exact(self, position: np.ndarray, time: float) -> np.ndarray:
        """Temperature (n,) [K] at ``position`` (n, 3) [m] in a plate without edges."""
        variance = self.width**2 + 2.0 * self.diffusivity * time
        r_squared = np.sum(np.asarray(position, float) ** 2, axis=1)
        return BACKGROUND + self.rise * self.width**2 / variance * np.exp(-r_squared / (2.0 * variance))

    def build(self, executor: Executor) -> Simulation:
        conductivity = self.diffusivity * DENSITY * HEAT_CAPACITY
        plate = solid_material("plate", DENSITY, heat_capacity=HEAT_CAPACITY, conductivity=conductivity)
        model = Model(
            dimension=2,
            spacing=self.spacing,
            materials=(plate,),
            support_ratio=self.support_ratio,
            gravity=(0.0, 0.0, 0.0),
            terms=(Conduction(longest_interval=self.step, integrator=self.stepping),),
        )
        position = lattice((-self.edge / 2,) * 2, (self.edge / 2,) * 2, self.spacing)
        particles = Particles()
        particles.add(position, Role.FREE, temperature=self.exact(position, 0.0))
        return Simulation(executor, model, particles, observe=self._observe)

    def _observe(self, state: Snapshot, time: float) -> Values:
        error = self._error(state["position"], state["temperature"], time)
        return {
            "peak_temperature": Measured(float(state["temperature"].max()), "K", "highest temperature"),
            "largest_error": Measured(float(np.abs(error).max()), "", "largest error over the peak"),
            "heat": Measured(
                float(np.sum(state["mass"].astype(float) * state["enthalpy"])), "J", "heat", per_depth=True
            ),
        }

    def _error(self, position: np.ndarray, temperature: np.ndarray, time: float) -> np.ndarray:
        """Difference to the exact temperature, over the highest exact rise of that time."""
        peak = self.exact(np.zeros((1, 3)), time)[0] - BACKGROUND
        return (temperature - self.exact(position, time)) / peak

    def checks(self, result: Result) -> list[Check]:
        error = self._error(result.positions, result.fields["temperature"], result.time)
        heat = result.diagnostics["heat"]
        background = DENSITY * HEAT_CAPACITY * BACKGROUND * self.edge**2
        return [
            Check(
                self.name,
                f"largest temperature error at {result.time:g} s, over the peak",
                "",
                float(np.abs(error).max()),
                None,
                0.01,
                "fundamental solution",
                reason="1 %; second-order smoothing error H^2/10 laplacian T and a first-order time step",
            ),
            Check(
                self.name,
                "heat gained, over the heat of the spot",
                "",
                float((heat[-1] - heat[0]) / (heat[0] - background)),
                None,
                1e-5,
                "insulated plate",
                reason="pairs exchange heat exactly; rounding of the enthalpies remains",
            ),
        ]

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The default run, and the order of convergence over three spacings with the longest stable time steps."""
        yield from super().verify(simulate, slow)
        spacings, errors = np.array([0.02, 0.01, 0.005]), []
        for spacing in spacings:
            scenario = cls(spacing=spacing, output_interval=cls.model_fields["duration"].default)
            result = simulate(scenario)
            near = np.linalg.norm(result.positions, axis=1) < 0.3 * scenario.edge
            error = scenario._error(result.positions, result.fields["temperature"], result.time)
            errors.append(np.abs(error[near]).max())
        order = np.polyfit(np.log(spacings), np.log(errors), 1)[0]
        yield Check(
            cls.name,
            "order of convergence, " + ", ".join(f"{error:.2%}" for error in errors) + " at 20, 10, 5 mm",
            "",
            float(order),
            2.0,
            0.5,
            "smoothing error of second order",
            relative=False,
            reason="at least 1.5; 0.3 m around the spot, where the insulated edges are not felt",
        )
