"""Continuous casting as in chapter 6 of Vijaykumar (2012): nozzle, melt, shell, mould, rolls, spray, withdrawal."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import ClassVar

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario
from warpsph.core.executor import Executor
from warpsph.core.materials import COPPER, WATER, solid_material
from warpsph.core.model import Model
from warpsph.machine import OscillatingMould
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.casting.checks import casting_checks
from warpsph.scenarios.casting.experiments import INLETS, inlet_checks, oscillation_checks, parameter_checks
from warpsph.scenarios.casting.feasibility import refuse_what_cannot_hold
from warpsph.scenarios.casting.machine import MOULD, NOZZLE, PLANE, ROLLS, CastingMachine
from warpsph.scenarios.casting.observer import CastingObserver
from warpsph.scenarios.casting.parameters import CastingParameters
from warpsph.terms import Conduction, CorrectedFluid, Elasticity, Fluid, PhaseChange, SummedDensity


class Casting(CastingParameters):
    """The casting machine: a half strand in the plane, or a quarter billet in three dimensions."""

    name: ClassVar[str] = "casting"
    summary: ClassVar[str] = "continuous casting of steel: nozzle, oscillating mould, shell, sprays, withdrawal"
    source: ClassVar[str] = "Vijaykumar (2012), chapters 6 and 7"
    presets: ClassVar[tuple[str, ...]] = ("demo", "steady", "thesis", *INLETS, "oscillation", "billet")
    default_preset: ClassVar[str | None] = "demo"

    @property
    def model(self) -> Model:
        """The physics of the strand and its surroundings, without the parts of the machine."""
        steel, copper = self.steel, replace(COPPER, name=MOULD, viscosity=self.mould_friction)
        held = (solid_material(name, self.density) for name in (PLANE, NOZZLE, ROLLS))
        materials = (steel, copper, *held, WATER)
        films = {
            (steel.name, copper.name): self.mould_conductance,
            (copper.name, WATER.name): 0.0,
            (WATER.name, WATER.name): 0.0,
        }
        published = (Fluid(self.density, self.sound_speed), SummedDensity())
        corrected = (CorrectedFluid(self.density, self.sound_speed, free_surface=True),)
        terms = (
            *(published if self.formulation == "published" else corrected),
            Conduction(films, longest_interval=self.step, integrator=self.stepping),
            PhaseChange(),
            Elasticity(self.youngs_modulus, self.poisson_ratio, self.elasticity == "corrected"),
        )
        return Model(self.dimension, self.spacing, materials, terms, self.support_ratio)

    def build(self, executor: Executor) -> Simulation:
        refuse_what_cannot_hold(self)
        machine = CastingMachine(self)
        lower, upper = machine.box
        observer = CastingObserver(self, machine)
        simulation = Simulation(
            executor,
            self.model,
            machine.particles,
            parts=[
                machine.gauge,
                OscillatingMould(self.mould_stroke, self.mould_frequency),
                machine.rolls,
                *machine.planes,
                machine.outflow,
                machine.inlet,
                machine.spray,
                machine.speedometer,
            ],
            lower=lower,
            upper=upper,
            step_factor=self.step_factor,
            observe=observer,
            describe=observer.describe,
        )
        observer.begin(simulation.model, simulation.snapshot(), simulation.events)
        return simulation

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """The demo; where there is time, the steady strand, the thesis's resolution and experiments, and the billet."""
        for preset in ("steady", "thesis", "billet") if slow else ("demo",):
            case = resolve(cls, [preset_layer(cls, preset)])
            yield from case.checks(simulate(case))
        if slow:
            yield from inlet_checks(cls, simulate)
            yield from oscillation_checks(cls, simulate)
            yield from parameter_checks(cls, simulate)

    def checks(self, result: Result) -> list[Check]:
        return casting_checks(self, result)
