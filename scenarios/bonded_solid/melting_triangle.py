"""A triangle of particles, heated by a source beside its top."""

from collections.abc import Callable, Iterable

from pydantic import model_validator

from warpsph.cases.case import preset_layer, resolve
from warpsph.cases.check import Check
from warpsph.cases.scenario import Scenario, parameter
from warpsph.core.executor import Executor
from warpsph.run.result import Result
from warpsph.run.simulation import Simulation
from warpsph.scenarios.bonded_solid.outcome import Outcome, check_unheated
from warpsph.scenarios.bonded_solid.particle_solid import FOOT, SOURCE, ParticleSolid
from warpsph.scenarios.bonded_solid.tables import published
from warpsph.terms import BondedPhase, DrivingSource, Floor

INDEPENDENT = "the same equations by another program"
TOP = 28  # P28
LEFT_EDGE = (1, 8, 14, 19, 23, 26)  # of the triangle at the start
PRINTED_STEP = 1.0e-4  # [s], in which the source gives the speeds of the paper


class MeltingTriangle(ParticleSolid):
    """28 particles, a source of heat near the top one; a particle is fluid when it moves fast or has no bonds."""

    name = "melting_triangle"
    summary = "a solid of 28 particles melts beside a source of heat"
    source = f"{SOURCE}, section 4, figures 4.1 and 4.2"
    presets = ("printed", "adjusted", "fast_printed", "fast_adjusted")
    default_preset = "adjusted"

    duration: float = parameter(10.0, "s", "physical time to simulate", gt=0, le=1e4)
    output_interval: float = parameter(0.1, "s", "physical time between two frames and diagnostics", gt=0, le=1e4)
    strengths: tuple[float, ...] = parameter((), "ft^3/s", "strengths Gamma of the source, per 1e-4 s; () for none")
    until: tuple[float, ...] = parameter((), "s", "time to which each of the strengths holds")
    source_x: float = parameter(0.2, "ft", "place of the source", ge=-100, le=100)
    source_y: float = parameter(5.7, "ft", "height of the source", ge=-100, le=100)
    source_reach: float = parameter(2.5, "ft", "distance from which on the source does nothing", gt=0, le=100)
    highest_speed: float = parameter(7.5, "ft/s", "mean speed above which a particle is fluid", gt=0, le=1e6)

    @model_validator(mode="after")
    def _check_source(self) -> "MeltingTriangle":
        if any(abs(strength) > 1.0 for strength in self.strengths):
            raise ValueError(f"strengths = {self.strengths} ft^3/s: each must be from -1 to 1")
        if len(self.until) != len(self.strengths):
            raise ValueError(f"until = {self.until} s: needs one time for each of {len(self.strengths)} strengths")
        if any(later <= earlier for earlier, later in zip((0.0, *self.until), self.until, strict=False)):
            raise ValueError(f"until = {self.until} s: must be positive times that rise")
        return self

    def build(self, executor: Executor) -> Simulation:
        place = (FOOT * self.source_x, FOOT * self.source_y, 0.0)
        strengths = [FOOT**3 * strength / PRINTED_STEP for strength in self.strengths]
        source = DrivingSource(place, FOOT * self.source_reach, strengths, self.until)
        phases = BondedPhase(FOOT * self.cutoff, self.interval, highest_speed=FOOT * self.highest_speed)
        sources = (source,) if self.strengths else ()
        return self.simulation(executor, published("triangle"), (Floor(self.restitution), phases, *sources))

    @classmethod
    def verify(cls, simulate: Callable[[Scenario], Result], slow: bool) -> Iterable[Check]:
        """Without heat, and slow and fast heating, each as printed and with the strength that melts the top."""
        unheated = Outcome(simulate(cls()), published("triangle"))
        yield from check_unheated(cls.name, unheated, "100 000")
        for what, energy, reference in (
            ("largest kinetic energy", unheated.kinetic_energy.max(), 77.0),
            ("kinetic energy at the end", unheated.kinetic_energy[-1], 18.0),
        ):
            quantity = f"{what} [kg ft^2/s^2]"
            yield cls._row(quantity, "no heat", float(energy), reference, 1.0, INDEPENDENT, "given with two digits")
        cases = {name: resolve(cls, [preset_layer(cls, name)]) for name in cls.presets}
        runs = {name: Outcome(simulate(case), published("triangle")) for name, case in cases.items()}
        for name in ("printed", "fast_printed"):
            yield cls._row("particles fluid at any time", name, runs[name].most_fluid, 0, 0, INDEPENDENT, "a count")
        yield cls._row(
            "where P28 is at the end: x [ft]",
            "printed",
            runs["printed"].place(TOP)[0],
            -0.60,
            0.01,
            INDEPENDENT,
            "given with two digits",
        )
        times = {
            "adjusted": (83000.0, 1000.0, "between the pictures of steps 82 000 and 84 000"),
            "fast_adjusted": (2000.0, 0.0, INDEPENDENT),
        }
        for name, (step, tolerance, reason) in times.items():
            run, source = runs[name], f"{cls.source}; {INDEPENDENT}"
            found = round(run.first_fluid_time / cases[name].step)
            yield cls._row("step of the first fluid particle", name, found, step, tolerance, source, reason)
            first = sum(run.first_fluid)
            yield cls._row("number of the first fluid particle", name, first, TOP, 0, source, "P28, and no other")
            bonds = len(run.bonded_to(TOP, cases[name].cutoff) & set(LEFT_EDGE))
            yield cls._row("bonds of P28 with the left side at the end", name, bonds, 2, 0, source, "a count")
            yield cls._row("particles fluid at the end", name, run.fluid_at_end, 0, 0, source, "a count")

    @classmethod
    def _row(
        cls, quantity: str, preset: str, found: float, reference: float, tolerance: float, source: str, reason: str
    ) -> Check:
        what = f"{quantity} ({preset})"
        return Check(cls.name, what, "", found, reference, tolerance, source, relative=False, reason=reason)
