"""Ways in which a run blows up: each names the particle that was the first, and the quantity."""

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from warpsph.core.executor import Executor, available_cores
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import DivergenceError
from warpsph.run.simulation import Simulation
from warpsph.terms import (
    Alloy,
    BackwardEuler,
    Conduction,
    CorrectedFluid,
    DeltaFluid,
    Elasticity,
    Fluid,
    HeatSources,
    Liquidus,
    PointSource,
    PreciseMotion,
    Solute,
    SummedDensity,
)

DX, CHOSEN, STRUCK = 0.02, 57, 0.02
SQUARE = lattice((0.0, 0.0), (0.2, 0.2), DX)
WATER = fluid_material("water", 1000.0, 0.5, conductivity=0.6, heat_capacity=4200.0)
ICE = solid_material("ice", 917.0, conductivity=2.4, heat_capacity=2000.0)
FLOW = (Fluid(1000.0, 30.0), SummedDensity())
SOLUTION = (Solute(), Alloy(ICE, 334e3, Liquidus.straight(273.15, 42.28, 255.65)))
IMPLICIT = Conduction(longest_interval=1.0, integrator=BackwardEuler())
BOX = PeriodicBox((0.0, 0.0, 0.0), (0.2, 0.2, 0.0))
NAN = float("nan")


def block(
    *terms: Any, device: str = "cpu", threads: int = 1, material: Any = WATER, periodic: Any = None, **options: Any
) -> Simulation:
    """A square of 10 x 10 particles."""
    given = {name: options.pop(name) for name in ("velocity", "temperature", "phase", "solute") if name in options}
    particles = Particles()
    particles.add(options.pop("points", SQUARE), Role.FREE, **given)
    model = Model(2, DX, (material,), terms, gravity=(0.0, 0.0, 0.0), periodic=periodic)
    return Simulation(Executor(device, threads), model, particles, **options)


def struck(name: str, value: Any, *terms: Any, **options: Any) -> Simulation:
    """A block in which an observer sets a field of one particle, wherever that stands by then."""

    def observe(snapshot: Any, time: float) -> dict:
        if time > STRUCK:
            values, mine = simulation.state.numpy(name), simulation.state.numpy("id") == CHOSEN
            values[mine] = value
            getattr(simulation.state, name).assign(values)
        return {}

    simulation = block(*terms, observe=observe, **options)
    return simulation


def offence(simulation: Simulation, duration: float = 0.2, interval: float = 0.005) -> DivergenceError:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(DivergenceError) as caught:
            simulation.run(duration, interval)
    error = caught.value
    assert "\n" not in str(error)
    assert error.exit_code == 3
    assert {"when", "particle", "time step", "usual cause"} <= set(error.facts)
    return error


STRIKES = {
    "a velocity is no number": (("velocity", NAN, *FLOW), "speed nan m/s"),
    "a particle is shot": (("velocity", 400.0, *FLOW), "speed 692.82 m/s, must be below 150 m/s"),
    "a place is no number": (("position", NAN, *FLOW), "distance from the origin nan m"),
    "a negative density": (("density", -5.0, *FLOW), "density -5 kg/m^3, must be above 0 and below 2000"),
    "a pressure is no number": (("pressure", NAN, *FLOW), "pressure nan Pa, must be a number"),
    "torn apart": (("compression", -1.5, CorrectedFluid(1000.0, 30.0)), "density over the reference density, less one"),
    "squeezed": (("compression", 9.0, DeltaFluid(1000.0, 30.0)), "less one 9, must be above -1 and below 4"),
    "heat alone": (("enthalpy", NAN, Conduction(longest_interval=0.005)), "specific enthalpy nan J/kg"),
    "implicit conduction": (("enthalpy", NAN, IMPLICIT), "specific enthalpy nan J/kg"),
    "heat in a flow": (("enthalpy", np.inf, Conduction(), *FLOW), "specific enthalpy inf J/kg"),
    "below 0 K": (("temperature", -50.0, Conduction(longest_interval=0.005)), "temperature -50 K, must be above -0.29"),
    "an alloy": (("temperature", NAN, *SOLUTION), "temperature nan K"),
    "an elastic solid": (("velocity", 1e5, Elasticity(2e6, 0.3)), "speed 173205 m/s, must be below"),
    "in double precision": (("precise_velocity", 1e9, PreciseMotion()), "speed 1.73205e+09 m/s, must be below 1e+06"),
}


@pytest.mark.parametrize("way", STRIKES)
def test_a_particle_that_was_struck_is_named(way, device):
    """If it failed, the error would name another particle, because they are sorted, or one that caught it from this."""
    (name, value, *terms), what = STRIKES[way]
    options: dict[str, Any] = {"solute": 0.14, "temperature": 280.0} if way == "an alloy" else {}
    if way == "an elastic solid":
        options = {"phase": Phase.SOLID}
    interval = 1.0 if way in ("an alloy", "implicit conduction") else 0.005
    if way == "in double precision":
        options = {"dt": 0.001}
    error = offence(struck(name, value, *terms, device=device, **options), 40.0 * interval, interval)
    assert f"particle {CHOSEN} (free, water)" in str(error)
    assert what in str(error)
    assert "row" in error.facts["last good frame"]


def test_a_periodic_box_is_watched_as_well(device):
    """If it failed, a particle that crosses the border would be taken for another one."""
    simulation = struck("velocity", 400.0, *FLOW, periodic=BOX, velocity=(2.0, 0.0, 0.0), device=device)
    assert f"particle {CHOSEN} (free, water)" in str(offence(simulation))


SHAKEN = {"velocity": np.tile([[3.0, 0.0, 0.0], [-3.0, 0.0, 0.0]], (50, 1))}
WAYS: dict[str, Callable[..., Simulation]] = {
    "a step too long": lambda **o: block(*FLOW, step_factor=8.0, periodic=BOX, **SHAKEN, **o),
    "a stiff solid": lambda **o: block(Elasticity(2e6, 0.3), phase=Phase.SOLID, step_factor=12.0, **SHAKEN, **o),
    "on top of each other": lambda **o: block(*FLOW, points=np.concatenate([SQUARE, SQUARE[[44] * 6]]), **o),
}


@pytest.mark.parametrize("way", WAYS)
def test_the_first_of_many_is_named(way, device):
    """If it failed, the particle named would be one that was hit later, or depend on when the host looks."""
    by_hand = WAYS[way](device=device)
    solver, state = by_hand.solver, by_hand.state
    solver.set_steps(by_hand.plan.longest, by_hand.plan.longest)
    by_hand.prepare()
    for _ in range(2000):
        snapshot = by_hand.snapshot()
        with np.errstate(all="ignore"):
            beyond = ~(np.linalg.norm(snapshot["velocity"].astype(float), axis=1) < solver.speed_limit)
            if "density" in snapshot:
                of_density = ~((snapshot["density"] > 0.0) & (snapshot["density"] < 2000.0))
                beyond = of_density if np.any(of_density) else beyond
        if np.any(beyond):
            break
        solver.step()
    first = int(np.flatnonzero(beyond)[0])
    error = offence(WAYS[way](device=device), 3000 * by_hand.plan.longest, 1000 * by_hand.plan.longest)
    assert f"particle {first} (free, water)" in str(error)
    assert f"at the end of step {state.steps.numpy()[0]}, " in error.facts["when"]


@pytest.mark.parametrize("count", [100, 3000])
def test_too_many_neighbours_are_reported_with_the_particle(count, device):
    """If it failed, forces would be lost, or nobody would know where particles have collapsed."""
    points = np.concatenate([SQUARE, np.tile([[0.5, 0.5, 0.0]], (count, 1))])
    error = offence(block(*FLOW, points=points, device=device))
    assert f"particle 100 (free, water) at (0.5, 0.5, 0) m has {count - 1} neighbours, 53 at most" in str(error)
    assert "at the start other places" in error.facts["usual cause"]


def test_an_implicit_step_without_a_solution_names_a_particle(device):
    """If it failed, one would know that Newton's method has failed, but not where to look."""
    sources = HeatSources((PointSource((0.09, 0.09, 0.0), -1e12),))
    conduction = Conduction(longest_interval=1.0, integrator=BackwardEuler())
    with pytest.raises(DivergenceError, match=r"particle \d+"):
        block(conduction, sources, device=device).run(40.0, 1.0)


def test_the_report_does_not_depend_on_threads():
    """If it failed, the same run would tell two stories."""
    stories = set()
    for threads in {1, min(2, available_cores())}:
        error = offence(WAYS["a step too long"](threads=threads), 1.0, 0.1)
        stories.add((str(error), *error.facts.values()))
    assert len(stories) == 1
