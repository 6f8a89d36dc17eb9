"""What happens across the border of a periodic box is what happens in free space, wherever the box is cut."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import Material, fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.core.state import Snapshot
from warpsph.core.term import Term
from warpsph.run.simulation import Simulation
from warpsph.terms import (
    Alloy,
    BackwardEuler,
    BondedPhase,
    ColourFieldTension,
    Conduction,
    Contact,
    ContinuityDensity,
    CorrectedFluid,
    DrivingSource,
    Elasticity,
    Fluid,
    GradientWalls,
    HeatSources,
    HeatWall,
    Liquidus,
    PairPotential,
    PointSource,
    PreciseMotion,
    Solute,
    SummedDensity,
    SurfaceTension,
)

DX = 0.01
EDGE = 40 * DX
CENTRE = (0.0, 0.0, 0.0)
WATER = fluid_material("water", 1000.0, 0.1)
RUBBER = solid_material("rubber", 1000.0)
SOLUTION = fluid_material("solution", 1097.0, conductivity=0.498, heat_capacity=4180.0)
ICE = solid_material("ice", 917.0, conductivity=2.408, heat_capacity=2006.0)
LIQUIDUS = Liquidus.straight(273.15, 42.28, 253.15)
FLOOR = HeatWall.film((0.0, 1.0, 0.0), -3 * DX, 500.0, 280.0)
ON_FLOOR = HeatWall.film((0.0, 1.0, 0.0), -2.5 * DX, 500.0, 280.0)

Fields = dict[str, object]


@dataclass(frozen=True)
class Case:
    """A block of some rows and what happens to it."""

    material: Material
    terms: Callable[[], tuple[Term, ...]]
    fields: Callable[[np.ndarray], Fields]
    steps: int = 60
    walled: bool = False


def warm(x: np.ndarray) -> Fields:
    return {"temperature": 350.0 + 400.0 * x[:, 0] + 100.0 * x[:, 1]}


def cold(x: np.ndarray) -> Fields:
    return {"solute": 0.1 + x[:, 0], "temperature": 262.0 + 100.0 * x[:, 0]}


def solid(x: np.ndarray) -> Fields:
    """A bar that swings; its right half is another body in contact with the left one."""
    velocity = np.column_stack([0.5 + 40.0 * x[:, 1] ** 2, 2.0 * x[:, 0], np.zeros(len(x))])
    return {"phase": Phase.SOLID, "body": x[:, 0] > 0.0, "velocity": velocity}


def flow(x: np.ndarray) -> Fields:
    return {"velocity": np.column_stack([np.full(len(x), 0.5), 3.0 * x[:, 0], np.zeros(len(x))])}


def molecules(x: np.ndarray) -> Fields:
    return flow(x) | {"mass": 1.0}


FLUID = Fluid(1000.0, 5.0)
PAIR = PairPotential(7.5e-6, 7.5e-10, 4, 6, cutoff=0.025)
CASES = {
    "drop": Case(WATER, lambda: (FLUID, ContinuityDensity(), SurfaceTension(0.07)), flow),
    "published drop": Case(WATER, lambda: (FLUID, ContinuityDensity(), ColourFieldTension(0.07)), flow),
    "summed density": Case(WATER, lambda: (FLUID, SummedDensity()), flow),
    "corrected flow": Case(WATER, lambda: (CorrectedFluid(1000.0, 5.0, free_surface=True),), flow, 10),
    "bodies": Case(RUBBER, lambda: (Elasticity(1e5, 0.3), Contact()), solid, 30),
    "heat": Case(SOLUTION, lambda: (Conduction(walls=(FLOOR,)),), warm, 200, walled=True),
    "implicit heat": Case(
        SOLUTION,
        lambda: (Conduction(walls=(FLOOR,), integrator=BackwardEuler(), longest_interval=1.0),),
        warm,
        5,
        walled=True,
    ),
    "walls by gradients": Case(SOLUTION, lambda: (Conduction(), GradientWalls((ON_FLOOR,))), warm, 200, walled=True),
    "source": Case(SOLUTION, lambda: (Conduction(), HeatSources((PointSource(CENTRE, 5.0),))), warm, 200),
    "alloy": Case(SOLUTION, lambda: (Solute(1e-6), Alloy(ICE, 334.4e3, LIQUIDUS)), cold, 200),
    "implicit alloy": Case(
        SOLUTION,
        lambda: (Solute(1e-6), Alloy(ICE, 334.4e3, LIQUIDUS, integrator=BackwardEuler(), longest_interval=1.0)),
        cold,
        5,
    ),
    "molecules": Case(
        RUBBER,
        lambda: (
            PreciseMotion(),
            PAIR,
            BondedPhase(0.015, 1e-3),
            DrivingSource((0.0, 0.0, 0.0), 0.05, (1e-4,), (1.0,)),
        ),
        molecules,
        10,
    ),
}
CARRIED = ("position", "precise_position", "place_before")
# what is left out is a small difference of these, or what rounding has lost of them
COMPARED = (
    *CARRIED, "velocity", "density", "temperature", "enthalpy", "heat_held", "deformation", "phase", "mean_velocity",
    "solute", "liquid_mass", "ice_mass", "ice_temperature",
)  # fmt: skip


def run(device: str, case: Case, dimension: int, periodic: bool) -> Snapshot:
    """The fields by id of a small block, around the origin, after some steps."""
    half = (7 * DX, 3 * DX, 3 * DX)[:dimension]
    x = lattice([-length for length in half], half, DX)
    if not case.walled:
        x[:, :dimension] += np.random.default_rng(1).uniform(-0.05, 0.05, (len(x), dimension)) * DX
    particles = Particles()
    particles.add(x, Role.FREE, **case.fields(x))
    lengths = [EDGE, 0.0 if case.walled else EDGE, EDGE if dimension == 3 else 0.0]
    box = PeriodicBox((0.0, 0.0, 0.0), lengths) if periodic else None
    model = Model(dimension, DX, (case.material,), case.terms(), 2.0, gravity=(0.0, 0.0, 0.0), periodic=box)
    simulation = Simulation(Executor(device), model, particles)
    duration = case.steps * simulation.plan.longest * simulation.plan.heat_every
    simulation.run(duration, duration)
    return simulation.snapshot()


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", CASES)
def test_a_block_on_the_border_is_one_in_free_space(device, name, dimension):
    """A term that takes a difference of places by itself would tear the block apart, or not see half of it."""
    case = CASES[name]
    free = run(device, case, dimension, periodic=False)
    border = run(device, case, dimension, periodic=True)
    for field in COMPARED:
        if field in free:
            away = border[field].astype(float) - free[field]
            if field in CARRIED:
                assert np.ptp(border[field][:, 0]) > 0.8 * EDGE
                away -= EDGE * np.rint(away / EDGE)
            assert np.abs(away).max() <= 1e-4 * np.abs(free[field]).max(), field
