"""The limits of the time step follow what a flow is given, however much of it that is."""

import numpy as np
import pytest

from warpsph.core.composition import compose
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.run.timestep import plan_steps
from warpsph.terms import (
    ColourFieldTension,
    ContinuityDensity,
    CorrectedFluid,
    DeltaFluid,
    Elasticity,
    Fluid,
    SummedDensity,
)
from warpsph.terms.corrected_fluid import LONGEST_DELAY_AT_SURFACE

SOUND, ROWS = 10.0, 10
STRONG = {"density_diffusion": 50.0, "artificial_viscosity": 50.0}
DAMPED = [
    (CorrectedFluid, STRONG | {"bulk_delay": 5.0, "shifting": 1.0e4, "surface_viscosity": 50.0}),
    (DeltaFluid, STRONG),
]


def disordered(term):
    dx = 1.0 / ROWS
    box = PeriodicBox((0.0, 0.0, 0.0), (1.0, 1.0, 0.0))
    model = Model(2, dx, (fluid_material("fluid", 1.0),), (term,), gravity=(0.0, 0.0, 0.0), periodic=box)
    points, random = lattice((0.0, 0.0), (1.0, 1.0), dx), np.random.default_rng(1)
    points[:, :2] += random.uniform(-0.2 * dx, 0.2 * dx, (len(points), 2))
    velocity = np.column_stack([random.normal(0.0, 0.01 * SOUND, (len(points), 2)), np.zeros(len(points))])
    particles = Particles()
    particles.add(points, Role.FREE, "fluid", velocity=velocity)
    return Simulation(Executor("cpu", 1), model, particles)


@pytest.mark.parametrize(
    ("kind", "given"),
    [(kind, {name: value}) for kind, strong in DAMPED for name, value in strong.items()] + DAMPED,
)
def test_strong_damping_shortens_the_step(kind, given):
    """A step that goes by sound alone would overshoot what is damped, and the run diverge."""
    simulation = disordered(kind(1.0, SOUND, **given))
    steps = 200 * simulation.plan.longest
    energy = simulation.run(steps, steps).diagnostics["kinetic_energy"]
    assert energy[-1] < energy[0]


@pytest.mark.parametrize("kind", [CorrectedFluid, DeltaFluid])
def test_usual_damping_costs_no_steps(kind):
    """Otherwise every run would take more steps for limits that only strong damping needs."""
    limits = disordered(kind(1.0, SOUND)).plan.limits
    assert min(limits, key=limits.get) == "sound"


def test_a_background_pressure_above_the_stiffness_is_refused():
    """Disorder alone would let particles fly apart faster than sound, whatever the step."""
    with pytest.raises(InputError, match=r"background_pressure = 1000000.0: must be at most rho_0 c\^2 = 100 Pa"):
        DeltaFluid(1.0, SOUND, background_pressure=1.0e6)


def test_a_delay_with_which_disorder_grows_is_refused():
    """The corrected gradient is not the opposite of the divergence: with 50 the energy grows fourteenfold."""
    with pytest.raises(InputError, match=r"bulk_delay = 50.0: must be at most 5; artificial_viscosity"):
        CorrectedFluid(1.0, SOUND, bulk_delay=50.0)
    with pytest.raises(InputError, match=r"bulk_delay = 1.0: must be at most 0.5 with a free surface; artificial"):
        CorrectedFluid(1.0, SOUND, bulk_delay=1.0, free_surface=True)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_thin_sheet_does_not_gain_energy_by_the_longest_delay(seed):
    """The gradients of two rows are corrected so much that a longer delay drives a sheet: with 5, to 400 times."""
    dx, random = 1.0 / 16, np.random.default_rng(seed)
    points = lattice((0.0, 0.0), (1.0, 2 * dx), dx)
    points[:, :2] += random.uniform(-0.2 * dx, 0.2 * dx, (len(points), 2))
    velocity = np.column_stack([random.normal(0.0, 0.01 * SOUND, (len(points), 2)), np.zeros(len(points))])
    particles = Particles()
    particles.add(points, Role.FREE, "fluid", velocity=velocity)
    flow = CorrectedFluid(1.0, SOUND, free_surface=True, bulk_delay=LONGEST_DELAY_AT_SURFACE)
    model = Model(2, dx, (fluid_material("fluid", 1.0),), (flow,), gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor("cpu", 1), model, particles)
    steps = 200 * simulation.plan.longest
    energy = simulation.run(steps, steps).diagnostics["kinetic_energy"]
    assert energy[-1] < 0.5 * energy[0]


def limits_of(*materials, terms, moving, spacing=0.1):
    model = compose(Model(2, spacing, materials, terms))
    return plan_steps(model, moving, None, 1.0).limits


def test_surface_tension_is_limited_by_the_lightest_fluid():
    """A capillary wave in it is faster: the step of the reference would be too long by the root of the ratio."""
    heavy, light = fluid_material("heavy", 1000.0), fluid_material("light", 250.0)
    terms = (CorrectedFluid(1000.0, SOUND), ColourFieldTension(1.0))
    both, one = (limits_of(heavy, light, terms=terms, moving=moving)["surface tension"] for moving in ((0, 1), (0,)))
    assert both == pytest.approx(0.5 * one)


def test_a_light_solid_in_a_heavy_fluid_shortens_the_step():
    """The fluid's pressure drives it as fast as it would drive a fluid so light."""
    heavy, cork = fluid_material("heavy", 1000.0, 1.0), solid_material("cork", 250.0)
    terms = (Fluid(1000.0, SOUND), ContinuityDensity(), Elasticity(1.0e4, 0.3))
    name = "sound and viscosity (7.6)"
    both, one = (limits_of(heavy, cork, terms=terms, moving=moving)[name] for moving in ((0, 1), (0,)))
    assert both < 0.55 * one


def test_a_viscous_fluid_beside_a_light_one_shortens_the_step():
    """A pair has up to twice the viscosity of the thinner fluid: the light one's own would be half the rate."""
    heavy, light = fluid_material("heavy", 1000.0, 400.0), fluid_material("light", 100.0, 50.0)
    limits = limits_of(heavy, light, terms=(CorrectedFluid(1000.0, SOUND),), moving=(0, 1))
    shared = 2.0 * 50.0 * 400.0 / (50.0 + 400.0)
    assert limits["viscosity"] == pytest.approx(0.15 * 0.1**2 / (shared / 100.0))


@pytest.mark.parametrize("terms", [(DeltaFluid(1.0, SOUND),), (Fluid(1.0, SOUND), SummedDensity())])
def test_a_wall_that_is_more_viscous_than_the_fluid_shortens_the_step(terms):
    """The mean viscosity of the pair is up to twice that of the fluid."""
    fluid, wall = fluid_material("fluid", 1.0, 10.0), solid_material("wall", 1.0, 1.0e4)
    alone, beside = (min(limits_of(*known, terms=terms, moving=(0,)).values()) for known in ((fluid,), (fluid, wall)))
    assert beside == pytest.approx(0.5 * alone, rel=0.05)


def test_what_waits_in_the_reservoir_counts_for_the_step():
    """A viscous fluid that comes in later would diverge in steps that fit the one that is there."""
    materials = (fluid_material("thin", 1.0, 1.0e-3), fluid_material("thick", 1.0, 10.0))
    model = Model(2, 0.1, materials, (DeltaFluid(1.0, SOUND),))
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 1.0), 0.1), Role.FREE, "thin")
    particles.add(lattice((2.0, 0.0), (2.2, 0.2), 0.1), Role.RESERVOIR, "thick")
    limits = Simulation(Executor("cpu", 1), model, particles).plan.limits
    assert limits["viscosity"] == pytest.approx(0.125 * 0.13**2 / 10.0)
