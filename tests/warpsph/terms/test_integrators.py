"""Implicit conduction: orders in the step, no heat lost, latent heat in long steps, failures that say so."""

import numpy as np
import pytest

from warpsph.core import executor
from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import melting_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import DivergenceError, InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import (
    BackwardEuler,
    Conduction,
    CrankNicolson,
    Explicit,
    HeatSources,
    HeatWall,
    PhaseChange,
    PointSource,
    WholePhases,
)

L, ROWS = 0.1, 20
SPACING = L / ROWS
STUFF = solid_material("stuff", density=1000.0, heat_capacity=1000.0, conductivity=10.0)
COPPER = solid_material("copper", density=8900.0, heat_capacity=390.0, conductivity=400.0)
GLASS = solid_material("glass", density=2500.0, heat_capacity=800.0, conductivity=1.0)
MELT = melting_material(
    "melt",
    density=7000.0,
    heat_capacity=700.0,
    heat_capacity_liquid=800.0,
    latent_heat=2.5e5,
    solidus=1000.0,
    liquidus=1000.0,
    conductivity_solid=30.0,
    conductivity_liquid=20.0,
    viscosity=0.0,
    source="none",
)
IMPLICIT = {"backward Euler": BackwardEuler, "Crank-Nicolson": CrankNicolson}


def plate(
    device, integrator, interval, temperature, walls=(), materials=(STUFF,), further=(), threads=None, origin=0.0
):
    """A plate of 20 x 6 rows, its right half of the last material."""
    x = lattice((0.0, 0.0), (L, 0.3 * L), SPACING)
    right = x[:, 0] > 0.5 * L
    x[:, 0] += origin
    particles = Particles()
    for material, here in ((materials[0], ~right), (materials[-1], right)):
        particles.add(x[here], Role.FREE, material=material.name, temperature=temperature(x[here] - [origin, 0, 0]))
    conduction = Conduction(longest_interval=interval, walls=walls, integrator=integrator)
    model = Model(2, SPACING, materials, (conduction, *further), gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device, threads), model, particles), conduction


def enthalpy(simulation):
    s = simulation.state
    return s.numpy("enthalpy").astype(float) - s.numpy("enthalpy_carry")


def content(simulation):
    return float(np.sum(simulation.state.numpy("mass").astype(float) * enthalpy(simulation)))


def wave(x):
    return 300.0 + 50.0 * np.cos(np.pi * x[:, 0] / L)


INSULATED = tuple(HeatWall.insulated(n, at) for n, at in (((1.0, 0, 0), 0.0), ((-1.0, 0, 0), -L)))


@pytest.mark.parametrize(("name", "order"), [("backward Euler", 1), ("Crank-Nicolson", 2)])
def test_order_in_the_step(device, name, order):
    """A wave between insulated ends decays exponentially; steps of 1/2 to 1/8 of its time constant of 101 s.

    Against a run with steps 16 times shorter than the last one, so that the error of the lattice drops out.
    """
    ends = []
    for steps in (4, 8, 16, 256):
        simulation, _ = plate(device, IMPLICIT[name](tolerance=1e-10), 200.0 / steps, wave, INSULATED)
        simulation.run(200.0, 200.0)
        ends.append(enthalpy(simulation)[np.argsort(simulation.state.numpy("id"))])
    errors = [np.abs(end - ends[-1]).max() for end in ends[:-1]]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.25)
    assert np.log2(errors[1] / errors[2]) == pytest.approx(order, abs=0.15)


@pytest.mark.parametrize("name", IMPLICIT)
def test_an_insulated_body_keeps_its_heat(device, name):
    """Whatever the tolerance: steps a hundred times the explicit one, solved to 1 % only, in two materials."""

    def random(x):
        return np.random.default_rng(1).uniform(300.0, 2000.0, len(x))

    simulation, _ = plate(
        device, IMPLICIT[name](tolerance=1e-2), 50.0, random, INSULATED, (MELT, COPPER), (PhaseChange(),)
    )
    before = content(simulation)
    simulation.run(1000.0, 1000.0)
    assert content(simulation) == pytest.approx(before, rel=1e-12)


@pytest.mark.parametrize("change", [PhaseChange, WholePhases])
@pytest.mark.parametrize("name", IMPLICIT)
def test_freezing_in_long_steps(device, name, change):
    """Melt between cold faces, 5 steps, in the first of which several rows freeze, against explicit ones.

    1 % of the latent heat is what backward Euler has with so few steps (0.6 %); the ledger is closed in any.
    """
    walls = (
        HeatWall.at_temperature((1.0, 0.0, 0.0), 0.0, 300.0),
        HeatWall.film((-1.0, 0.0, 0.0), -L, 2000.0, 300.0),
    )
    frozen = []
    for integrator, interval in ((Explicit(), None), (IMPLICIT[name](), 8.0)):
        simulation, conduction = plate(
            device, integrator, interval, lambda x: np.full(len(x), 1050.0), walls, (MELT,), (change(),)
        )
        before = content(simulation)
        simulation.run(40.0, 40.0)
        taken = conduction.heat_to_walls().sum()
        assert before - content(simulation) == pytest.approx(taken, rel=1e-5 if interval is None else 1e-10)
        frozen.append(float(np.mean(simulation.state.numpy("solid_fraction"))))
    assert 0.2 < frozen[0] < 0.9
    assert frozen[1] == pytest.approx(frozen[0], abs=0.02)


@pytest.mark.parametrize("name", IMPLICIT)
def test_sources_and_held_particles(device, name):
    """A source gives its power for the whole step; what flows on to a held row is in its ledger."""
    source = HeatSources((PointSource((0.3 * L, 0.15 * L, 0.0), 500.0),))
    simulation, _ = plate(device, IMPLICIT[name](), 20.0, lambda x: np.full(len(x), 300.0), further=(source,))
    state = simulation.state
    held = (state.numpy("position")[:, 0] > L - SPACING).astype(np.int32)
    state.held.assign(held)
    before = content(simulation)
    simulation.run(400.0, 400.0)
    taken = float(np.sum(state.numpy("heat_held")))
    assert content(simulation) - before + taken == pytest.approx(500.0 * 400.0, rel=1e-6)
    assert taken > 0.2 * 500.0 * 400.0
    temperature, last = state.numpy("temperature"), state.numpy("position")[:, 0] > L - SPACING
    assert np.all(temperature[last] == 300.0)


@pytest.mark.parametrize("name", [*IMPLICIT, "explicit"])
def test_a_source_beside_held_particles(device, name):
    """What it gives to particles whose temperature stays is in their ledger, too."""
    source = HeatSources((PointSource((0.97 * L, 0.15 * L, 0.0), 5000.0),))
    integrator = IMPLICIT[name]() if name in IMPLICIT else Explicit()
    simulation, _ = plate(device, integrator, 0.5, lambda x: np.full(len(x), 300.0), further=(source,))
    state = simulation.state
    state.held.assign((state.numpy("position")[:, 0] > L - 2 * SPACING).astype(np.int32))
    before = content(simulation)
    simulation.run(20.0, 20.0)
    assert content(simulation) - before + float(np.sum(state.numpy("heat_held"))) == pytest.approx(1e5, rel=1e-5)


@pytest.mark.parametrize("step", [1e3, 1e6])
@pytest.mark.parametrize("materials", [(COPPER,), (COPPER, GLASS)], ids=["copper", "copper and glass"])
@pytest.mark.parametrize("name", IMPLICIT)
def test_any_step_is_stable(device, name, materials, step):
    """A wave in copper, steps of a thousand to a million times dx^2 / diffusivity: it is gone, and its heat is kept.

    But for the rounding of double precision, of what flows in a step: 1e7 times what is there.
    """
    simulation, conduction = plate(device, IMPLICIT[name](), step, wave, INSULATED, materials)
    before = content(simulation)
    simulation.run(4.0 * step, step)
    temperature = simulation.state.numpy("temperature")
    assert np.ptp(temperature) < (1.0 if GLASS not in materials or step > 1e5 else 50.0)  # glass takes 2000 s
    assert 250.0 <= temperature.min() <= temperature.max() <= 350.0
    assert content(simulation) == pytest.approx(before, rel=1e-8)
    steps, systems, _ = conduction.implicit.counters
    assert systems <= 12 * steps


def test_a_sudden_wall_rings_unless_the_first_steps_are_damped(device):
    """Steps of 80 times the explicit one after a jump of 100 K, against steps of a hundredth of that.

    Without damping the shortest waves change sign from step to step and keep most of their 50 K.
    """
    cold = (HeatWall.at_temperature((1.0, 0.0, 0.0), 0.0, 300.0),)

    def at_the_end(interval, damped):
        simulation, _ = plate(
            device, CrankNicolson(damped_steps=damped), interval, lambda x: np.full(len(x), 400.0), cold
        )
        simulation.run(80.0, 80.0)
        return simulation.state.numpy("temperature")[np.argsort(simulation.state.numpy("id"))]

    exact = at_the_end(0.2, 2)
    assert np.abs(at_the_end(20.0, 0) - exact).max() > 10.0
    assert np.abs(at_the_end(20.0, 2) - exact).max() < 1.0


def test_two_runs_are_one(device):
    """The damped steps are counted over runs; with threads, without, and with the rows shared out among them."""

    def run(*durations, threads=None):
        walls = (HeatWall.film((1.0, 0.0, 0.0), 0.0, 500.0, 300.0),)
        simulation, conduction = plate(device, CrankNicolson(damped_steps=3), 10.0, wave, walls, threads=threads)
        for duration in durations:
            simulation.run(duration, 10.0)
        assert conduction.implicit.counters[0] == 6
        return enthalpy(simulation)

    assert np.array_equal(run(60.0), run(20.0, 40.0, threads=1))


def test_threads_multiply_alike(monkeypatch):
    monkeypatch.setattr(executor, "WORTH_THREADS", 1)
    ends = []
    for threads in (1, None):
        simulation, _ = plate("cpu", CrankNicolson(), 10.0, wave, INSULATED, threads=threads)
        simulation.run(60.0, 30.0)
        ends.append(enthalpy(simulation))
    assert np.array_equal(*ends)


def test_far_from_the_origin(device):
    """100 m away positions are rounded to 7.6e-6 m, 0.15 % of a spacing: 0.02 K of 100 K."""
    ends = []
    for origin in (0.0, 100.0):
        walls = (HeatWall.at_temperature((1.0, 0.0, 0.0), origin, 200.0),)
        simulation, _ = plate(device, CrankNicolson(), 10.0, wave, walls, origin=origin)
        simulation.run(60.0, 60.0)
        ends.append(simulation.state.numpy("temperature")[np.argsort(simulation.state.numpy("id"))])
    assert np.abs(ends[0] - ends[1]).max() < 0.02


def test_a_solver_that_does_not_converge_says_so(device):
    simulation, _ = plate(device, BackwardEuler(most_iterations=3), 1e4, wave, materials=(STUFF, COPPER))
    with pytest.raises(DivergenceError, match=r"conjugate gradients has not converged after \d+ .* rest is .* J"):
        simulation.run(1e4, 1e4)


def test_what_is_refused():
    for none in (None, np.inf):
        with pytest.raises(InputError, match="longest_interval: an implicit integrator is stable for any step"):
            Conduction(integrator=BackwardEuler(), longest_interval=none)
    with pytest.raises(InputError, match="integrator"):
        Conduction(integrator="crank_nicolson")
    for wrong in (0.0, 1.0, float("nan"), "small"):
        with pytest.raises(InputError, match="tolerance"):
            BackwardEuler(tolerance=wrong)
    with pytest.raises(InputError, match="most_iterations"):
        BackwardEuler(most_iterations=0)
    with pytest.raises(InputError, match="damped_steps"):
        CrankNicolson(damped_steps=-1)
    _, conduction = plate("cpu", BackwardEuler(), 1.0, wave)
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (L, L), SPACING), Role.FREE, temperature=300.0)
    with pytest.raises(InputError, match="belongs to another simulation"):
        Simulation(Executor("cpu"), Model(2, SPACING, (STUFF,), (conduction,), gravity=(0.0, 0.0, 0.0)), particles)
