"""Classic delta-SPH: what it keeps exactly, the speed of its sound, and its errors at walls and at rest."""

from dataclasses import replace

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import GRAVITY, Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, DeltaFluid, Elasticity, PhaseChange

SOUND = 10.0


def flow(dimension=2, spacing=0.05, viscosity=0.0, gravity=0.0, lengths=(1.0, 1.0, 0.5), **fluid):
    return Model(
        dimension=dimension,
        spacing=spacing,
        materials=(fluid_material("fluid", 1.0, viscosity), solid_material("wall", 1.0, viscosity)),
        terms=(DeltaFluid(1.0, SOUND, **fluid),),
        gravity=(gravity, 0.0, 0.0),
        periodic=PeriodicBox((0.0, 0.0, 0.0), (*lengths[:dimension], 0.0)[:3]),
    )


@pytest.mark.parametrize("dimension", [2, 3])
def test_momentum_is_kept_to_rounding(dimension, device):
    """If a pair's forces were not opposite, a fluid in a box without walls would begin to travel."""
    points = lattice((0.0, 0.0, 0.0)[:dimension], (1.0, 1.0, 0.5)[:dimension], 0.05)
    random = np.random.default_rng(0)
    way, velocity = random.normal(0.0, 0.005, points.shape), random.normal(0.0, 1.0, points.shape)
    for vectors in (way, velocity):
        vectors[:, dimension:] = 0.0
    particles = Particles()
    particles.add(points + way, Role.FREE, "fluid", velocity=velocity - velocity.mean(axis=0))
    model = flow(dimension, viscosity=0.02, exponent=7.0, background_pressure=2.0)
    simulation = Simulation(Executor(device), model, particles)
    simulation.run(0.2, 0.2)
    speeds = simulation.snapshot()["velocity"].astype(float)
    assert np.std(speeds) > 0.01
    np.testing.assert_allclose(speeds.mean(axis=0), 0.0, atol=2e-7)  # 60 steps of single precision


@pytest.mark.parametrize("exponent", [1.0, 7.0])
def test_sound_swings_with_its_own_period(exponent, device):
    """A wrong slope of the equation of state, or rates of the wrong time, would change the speed or let sound grow."""
    points = lattice((0.0, 0.0), (1.0, 0.5), 0.025)
    wave = np.sin(2.0 * np.pi * points[:, 0])
    particles = Particles()
    particles.add(points, Role.FREE, "fluid", velocity=np.outer(0.01 * wave, (1.0, 0.0, 0.0)))
    undamped = {"artificial_viscosity": 0.0, "density_diffusion": 0.0}
    model = flow(spacing=0.025, lengths=(1.0, 0.5), exponent=exponent, **undamped)
    simulation = Simulation(Executor(device), model, particles)
    amplitudes = []
    for _ in range(2):
        simulation.run(0.05, 0.05)  # half a period of L / c
        state = simulation.snapshot()
        now = np.sin(2.0 * np.pi * state["position"][:, 0].astype(float))
        amplitudes.append(float(state["velocity"][:, 0] @ now / (now @ now)) / 0.01)
    # 40 particles a wave: slower by 2 (H / L)^2 or so, 1 %
    np.testing.assert_allclose(amplitudes, [-1.0, 1.0], atol=0.02)


def test_a_background_pressure_is_added_everywhere(device):
    """It would otherwise not keep particles apart where the pressure falls below zero."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 1.0), 0.05), Role.FREE, "fluid", compression=0.001)
    simulation = Simulation(Executor(device), flow(background_pressure=3.0, exponent=7.0), particles)
    expected = 3.0 + SOUND**2 / 7.0 * (1.001**7 - 1.0)
    np.testing.assert_allclose(simulation.snapshot()["pressure"], expected, rtol=1e-5)
    simulation.run(0.1, 0.1)
    state = simulation.snapshot()
    np.testing.assert_allclose(state["pressure"], expected, rtol=1e-4)
    np.testing.assert_allclose(state["velocity"], 0.0, atol=1e-4)  # a lattice is in balance


def test_shear_between_walls(device):
    """A wall that acts a spacing away from its face makes an error of 10 % with 10 rows."""
    dx, viscosity = 0.1, 0.1
    walls = np.concatenate([lattice((0.0, -3 * dx), (1.0, 0.0), dx), lattice((0.0, 1.0), (1.0, 1.0 + 3 * dx), dx)])
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 1.0), dx), Role.FREE, "fluid")
    particles.add(walls, Role.DUMMY, "wall", to_surface=way_to_box(walls, (-np.inf, 0.0, 0.0), (np.inf, 1.0, 0.0)))
    model = flow(spacing=dx, viscosity=viscosity, gravity=8.0 * viscosity, lengths=(1.0, 0.0), artificial_viscosity=0.0)
    simulation = Simulation(Executor(device), model, particles)
    simulation.run(8.0, 8.0)
    state = simulation.snapshot()
    fluid = state["role"] == Role.FREE
    y = state["position"][fluid, 1].astype(float)
    exact = 4.0 * y * (1.0 - y)
    error = np.sqrt(np.mean((state["velocity"][fluid, 0] - exact) ** 2) / np.mean(exact**2))
    assert error < 0.06  # viscosity without its normalisation: 4.4 %, 3.0 % with 20 rows


def test_a_tank_comes_to_rest(device):
    """Walls that did not bear the weight of the fluid would let it through."""
    dx, sound = 1.0 / 12.0, 10.0 * np.sqrt(2.0 * GRAVITY)
    model = Model(
        dimension=2,
        spacing=dx,
        materials=(fluid_material("water", 1000.0), solid_material("wall", 1000.0)),
        terms=(DeltaFluid(1000.0, sound, free_surface=True),),
    )
    water, walls = lattice((0.0, 0.0), (1.0, 1.0), dx), tank((0.0, 0.0), (1.0, 1.3), dx)
    particles = Particles()
    particles.add(water, Role.FREE, "water", compression=GRAVITY * (1.0 - water[:, 1]) / sound**2)
    particles.add(walls, Role.DUMMY, "wall", to_surface=way_to_box(walls, (0.0, 0.0, 0.0), (1.0, np.inf, 0.0)))
    simulation = Simulation(Executor(device), model, particles)
    simulation.run(3.0, 3.0)
    state = simulation.snapshot()
    fluid = state["role"] == Role.FREE
    y = state["position"][fluid, 1].astype(float)
    error = state["pressure"][fluid] / (1000.0 * GRAVITY) - (1.0 - y)
    assert np.sqrt(np.mean(error**2)) < 0.06  # half a row of 12, for want of neighbours at the surface
    assert np.linalg.norm(state["velocity"][fluid], axis=1).max() < 0.05 * np.sqrt(GRAVITY)


@pytest.mark.parametrize(
    "wrong", [{"exponent": 0.5}, {"background_pressure": -1.0}, {"density_diffusion": np.inf}, {"free_surface": "no"}]
)
def test_parameters_out_of_bounds_are_refused(wrong):
    """They would end in numbers that are none."""
    with pytest.raises(InputError, match=next(iter(wrong))):
        DeltaFluid(1.0, SOUND, **wrong)


def test_a_wall_whose_face_is_unknown_is_refused():
    """It would act at the places of its particles, half a spacing behind its face."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 1.0), 0.05), Role.FREE, "fluid")
    particles.add(lattice((0.0, -0.15), (1.0, 0.0), 0.05), Role.DUMMY, "wall")
    with pytest.raises(InputError, match="to_surface"):
        Simulation(Executor("cpu"), flow(lengths=(1.0, 0.0)), particles)


@pytest.mark.parametrize("terms", [(Elasticity(1e5, 0.3),), (Conduction(), PhaseChange())], ids=["elastic", "freezes"])
def test_solids_are_refused(terms):
    """They would fall through fluid and walls, which bear on none of them."""
    model = flow(lengths=(1.0, 1.0))
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (1.0, 1.0), 0.05), Role.FREE, "fluid")
    with pytest.raises(InputError, match=f"DeltaFluid and {type(terms[-1]).__name__} exclude each other"):
        Simulation(Executor("cpu"), replace(model, terms=(*model.terms, *terms)), particles)
    solid = Particles()
    solid.add(lattice((0.0, 0.0), (1.0, 1.0), 0.05), Role.FREE, "fluid", phase=Phase.SOLID)
    with pytest.raises(InputError, match="no solids but walls"):
        Simulation(Executor("cpu"), model, solid)


@pytest.mark.parametrize("densities", [(2.0,), (1.0, 2.0)])
def test_another_density_is_refused(densities):
    """Its particles would weigh as much as those of the reference density, whatever their material says."""
    fluids = tuple(fluid_material(name, rho) for name, rho in zip("ab", densities, strict=False))
    particles = Particles()
    for height, fluid in enumerate(fluids):
        particles.add(lattice((0.0, 1.0 * height), (1.0, 1.0 + height), 0.1), Role.FREE, fluid.name)
    with pytest.raises(InputError, match=r"of 2 kg/m\^3 flows"):
        Simulation(Executor("cpu"), Model(2, 0.1, fluids, (DeltaFluid(1.0, SOUND),)), particles)
