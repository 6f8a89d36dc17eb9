"""The limits of the time step follow what a flow is given, however much of it that is."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import CorrectedFluid, DeltaFluid

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
