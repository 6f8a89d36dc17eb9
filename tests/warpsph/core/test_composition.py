"""What terms may stand together."""

import numpy as np
import pytest

from warpsph.core.composition import compose
from warpsph.core.dynamics import Dynamics
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import COPPER, fluid_material
from warpsph.core.model import Model
from warpsph.core.motion import Motion
from warpsph.core.particles import Particles
from warpsph.errors import InputError
from warpsph.machine import Inlet, LevelGauge, OscillatingMould, Outflow, SymmetryPlane
from warpsph.run.simulation import Simulation
from warpsph.terms import (
    ColourFieldTension,
    Conduction,
    Contact,
    ContinuityDensity,
    Elasticity,
    Fluid,
    PhaseChange,
    SummedDensity,
    SurfaceTension,
)

FLUID = Fluid(1000.0, 10.0)
GAUGE = LevelGauge((0.0, 0.0, -1.0), (1.0, 1.0, 1.0), 0.1, 0.01, area_ratio=1.0)
INLET = Inlet(GAUGE, np.zeros((1, 3)), (0.0, -1.0, 0.0), 0.1, 300.0)

REFUSED = [
    ((FLUID,), "Fluid needs density in the same case: add ContinuityDensity or SummedDensity"),
    ((FLUID, SummedDensity(), ContinuityDensity()), "SummedDensity and ContinuityDensity exclude each other"),
    ((FLUID, Fluid(1.0, 1.0), SummedDensity()), "Fluid and Fluid exclude each other"),
    ((SummedDensity(),), "SummedDensity needs fluid in the same case: add Fluid"),
    ((PhaseChange(),), "PhaseChange needs conduction in the same case: add Conduction"),
    ((SurfaceTension(1.0),), "SurfaceTension needs fluid in the same case: add CorrectedFluid or Fluid"),
    ((FLUID, SummedDensity(), SurfaceTension(1.0)), "SurfaceTension needs a density by continuity.*ContinuityDensity"),
    (
        (FLUID, ContinuityDensity(), SurfaceTension(1.0), ColourFieldTension(1.0)),
        "SurfaceTension and ColourFieldTension exclude each other",
    ),
    ((Contact(),), "Contact needs elasticity in the same case: add Elasticity"),
    (
        (FLUID, SummedDensity(), Conduction(), Outflow(GAUGE, 0.0, -0.1, 1.0)),
        "Outflow: its gauge, a LevelGauge, is mis",
    ),
    ((FLUID, SummedDensity(), GAUGE, INLET), "LevelGauge needs conduction"),
    ((INLET, GAUGE), "Inlet needs fluid in the same case: add CorrectedFluid or Fluid"),
    ((OscillatingMould(0.1, 1.0), OscillatingMould(0.1, 2.0)), "OscillatingMould and OscillatingMould exclude"),
    ((Conduction(),) * 2, "exclude each other|stands there twice"),
    ((Elasticity,), "is not a term; give instances"),
]


@pytest.mark.parametrize(("terms", "why"), REFUSED, ids=lambda value: value if isinstance(value, str) else "")
def test_contradictions_are_refused_when_the_simulation_is_built(terms, why):
    """If it failed, a case without what it needs would end in a traceback, or run and mean nothing."""
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE)
    model = Model(2, 0.1, (fluid_material("water", 1000.0),), terms)
    with pytest.raises(InputError, match=why) as caught:
        Simulation(Executor("cpu", 1), model, particles)
    assert "\n" not in str(caught.value)


def test_terms_come_in_an_order_in_which_they_can_act():
    """If it failed, the result would depend on the order in which somebody wrote the terms down."""
    written = (Elasticity(1e5, 0.3), PhaseChange(), Conduction(), SummedDensity(), FLUID)
    orders = [
        [type(term) for term in compose(Model(2, 0.1, (COPPER,), terms)).terms] for terms in (written, written[::-1])
    ]
    for order in orders:
        assert order[:2] == [Motion, Dynamics]
        assert order.index(SummedDensity) < order.index(Fluid) < order.index(Elasticity)
        assert order.index(Conduction) < order.index(PhaseChange) < order.index(Elasticity)


def test_parts_may_stand_there_several_times_and_keep_their_order():
    """If it failed, a box could not have two planes of symmetry."""
    planes = tuple(SymmetryPlane((1.0, 0.0, 0.0), float(offset)) for offset in range(3))
    terms = compose(Model(2, 0.1, (COPPER,)), planes).terms
    assert [term for term in terms if isinstance(term, SymmetryPlane)] == list(planes)


def test_what_a_case_does_not_have_costs_nothing():
    """If it failed, a plate at rest would carry the arrays of a fluid."""
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE)
    simulation = Simulation(Executor("cpu", 1), Model(2, 0.1, (COPPER,), (Conduction(),)), particles)
    assert {"enthalpy", "position"} <= set(simulation.state.arrays)
    assert not {"density", "acceleration", "stress", "entries"} & set(simulation.state.arrays)


def test_a_part_belongs_to_one_simulation():
    """If it failed, two simulations would write to the same counters."""
    gauge = LevelGauge((0.0, 0.0, -1.0), (1.0, 1.0, 1.0), 0.1, 0.01, area_ratio=1.0)
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE)
    model = Model(2, 0.1, (fluid_material("water", 1000.0),), (FLUID, SummedDensity(), Conduction()))
    Simulation(Executor("cpu", 1), model, particles, parts=[gauge])
    with pytest.raises(InputError, match="LevelGauge belongs to another simulation"):
        Simulation(Executor("cpu", 1), model, particles, parts=[gauge])
