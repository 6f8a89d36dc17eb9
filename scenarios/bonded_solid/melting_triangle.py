"""A triangle of particles, heated by a source beside its top."""

from pydantic import model_validator

from warpsph.cases.scenario import parameter
from warpsph.core.executor import Executor
from warpsph.run.simulation import Simulation
from warpsph.scenarios.bonded_solid.particle_solid import FOOT, SOURCE, ParticleSolid
from warpsph.scenarios.bonded_solid.tables import published
from warpsph.terms import BondedPhase, DrivingSource, Floor

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
        return self.simulation(executor, published("triangle"), Floor(self.restitution), phases, sources)
