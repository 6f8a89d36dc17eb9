"""What a run does not depend on, and what it survives."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import fluid_material, melting_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.run.progress import Progress
from warpsph.run.schedule import Schedule
from warpsph.run.simulation import Simulation
from warpsph.run.timestep import StepPlan, plan_steps
from warpsph.scenarios import HeatGaussian
from warpsph.terms import BondedPhase, Conduction, Fluid, PairPotential, PhaseChange, PreciseMotion, SummedDensity

DX = 0.004


def pool() -> Simulation:
    """A little melt in a cold box, which freezes completely."""
    easy = melting_material(
        "tin", density=2000.0, heat_capacity=500.0, latent_heat=2.0e4, solidus=500.0, liquidus=510.0,
        conductivity_solid=100.0, conductivity_liquid=100.0, viscosity=5.0, source="round numbers",
    )  # fmt: skip
    box = lattice((-4 * DX, -4 * DX), (8 * DX, 8 * DX), DX)
    inside = np.all((box[:, :2] > 0.0) & (box[:, :2] < 4 * DX), axis=1)
    particles = Particles()
    particles.add(box[inside], Role.FREE, temperature=515.0)
    particles.add(box[~inside], Role.WALL, temperature=300.0, held=True)
    terms = (Fluid(2000.0, 10.0), SummedDensity(), Conduction(), PhaseChange())
    return Simulation(Executor("cpu", 1), Model(2, DX, (easy,), terms), particles)


def falling(**options) -> Simulation:
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.1, 0.1), 0.02), Role.FREE)
    model = Model(2, 0.02, (fluid_material("water", 1000.0, viscosity=0.5),), (Fluid(1000.0, 30.0), SummedDensity()))
    return Simulation(Executor("cpu", 1), model, particles, **options)


def test_a_run_whose_melt_freezes_completely_comes_to_its_end(tmp_path):
    """If it failed, every Stefan problem would end in a traceback when its last particle has frozen."""
    path = tmp_path / "pool.vtkhdf"
    result = pool().run(0.1, 0.01, output=path)
    melt = result.fields["role"] == Role.FREE
    assert np.all(result.fields["phase"][melt] == Phase.SOLID)
    for series in (result.diagnostics, ResultFile(path).diagnostics):
        assert np.isfinite(series["density_max"][0])
        assert np.isnan(series["density_max"][-1])
        assert len(series["density_max"]) == len(series["time"]) == 11
    assert ResultFile(path).provenance["status"] == "complete"


@pytest.mark.parametrize(("first", "then"), [({"a": 1.0}, {}), ({}, {"a": 1.0}), ({"a": 1.0}, {"b": 2.0})])
def test_diagnostics_that_come_and_go_are_not_a_number_meanwhile(tmp_path, first, then):
    """If it failed, an observer that has nothing to measure at some moment would end the run."""
    path = tmp_path / "run.vtkhdf"
    result = falling(observe=lambda state, time: first if time == 0.0 else then).run(0.02, 0.02, output=path)
    expected = {name: [first.get(name, np.nan), then.get(name, np.nan)] for name in (*first, *then)}
    for series in (result.diagnostics, ResultFile(path).diagnostics):
        for name, values in expected.items():
            assert np.array_equal(series[name], values, equal_nan=True)


def test_a_run_from_python_stores_its_parameters(tmp_path):
    """If it failed, nobody could tell later what a file holds."""
    path = tmp_path / "plate.vtkhdf"
    case = HeatGaussian(spacing=0.05, duration=1.0)
    case.run(device="cpu", output=path)
    assert ResultFile(path).parameters == case.as_dict()
    assert ResultFile(path).parameters["spacing"] == 0.05


def test_the_time_step_does_not_depend_on_the_duration():
    """If it failed, a run to 0.07 s could not be continued to what a run to 0.4 s gives."""
    long, short = falling(), falling()
    long.run(0.04, 0.01)
    short.run(0.007, 0.01)
    assert short.solver.dt == long.solver.dt
    assert short.time == 0.007


def test_a_second_run_counts_its_own_progress():
    """If it failed, the bar of a continued run would jump, and the time left be wrong."""
    simulation = falling()
    simulation.run(0.03, 0.01)
    reports: list[Progress] = []
    simulation.run(0.02, 0.01, progress=reports.append)
    assert reports[-1].time == reports[-1].duration == pytest.approx(0.05, abs=1e-15)
    assert reports[-1].seconds_left == 0.0
    assert reports[-1].steps == round(0.02 / simulation.solver.dt)


@pytest.mark.parametrize(
    ("duration", "interval", "expected"),
    [
        (2.4, 1.0, [0.0, 1.0, 2.0, 2.4]),
        (2.6, 1.0, [0.0, 1.0, 2.0, 2.6]),
        (1.0, 0.3, [0.0, 0.3, 0.6, 0.9, 1.0]),
        (0.4, 1.0, [0.0, 0.4]),
        (0.3, 0.1, [0.0, 0.1, 0.2, 0.3]),
    ],
)
def test_a_run_ends_at_its_duration_with_frames_in_time(tmp_path, duration, interval, expected):
    """If it failed, a run would end at another time than it was told, and call itself complete."""
    path = tmp_path / "plate.vtkhdf"
    reports: list[Progress] = []
    case = HeatGaussian(spacing=0.05, diffusivity=1e-6, duration=duration, output_interval=interval)
    result = case.run(device="cpu", output=path, progress=reports.append)
    assert ResultFile(path).times.tolist() == expected
    assert result.time == duration
    assert result.diagnostics["time"][-1] == reports[-1].time == duration
    assert max(report.time / report.duration for report in reports) == 1.0


def test_the_last_steps_are_shorter_not_longer():
    """If it failed, a run that ends within a cycle would end with an unstable step."""
    plan = StepPlan(longest=0.01, heat_every=4, limits={}, with_heat=True)
    for duration in (0.001, 0.0399, 0.0401, 0.075, 0.1, 0.12, 0.123, 1.0):
        schedule = Schedule(plan, 0.0, duration, 0.1)
        total, steps = 0.0, 0
        while not schedule.done:
            cycles = schedule.next_batch(1)
            assert schedule.cycle_steps.dt <= 0.01 * (1.0 + 1e-9)
            assert schedule.cycle_steps.count <= 4
            total += cycles * schedule.cycle_steps.duration
            steps += cycles * schedule.cycle_steps.count
        assert total == pytest.approx(duration, rel=1e-12)
        assert schedule.time == duration
        assert schedule.steps_done == steps


@pytest.mark.parametrize(("count", "dt"), [(49, 1e-4), (29, 1e-5), (53, 3e-4), (1000, 1e-4)])
def test_a_cycle_has_as_many_steps_as_were_asked_for(count, dt):
    """If it failed, a mean over 49 steps would be one over 48, by steps of half the length."""
    terms = (PreciseMotion(), PairPotential(2500.0, 2900.0, 4, 6, 1.5), BondedPhase(1.5, count * dt, 7.5))
    plan = plan_steps(Model(2, 1.0, (solid_material("particles", 1.0),), terms, 1.2), (0,), dt, 1.0)
    schedule = Schedule(plan, 0.0, 20 * count * dt, 2 * count * dt)
    assert schedule.cycle_steps.count == count
    assert schedule.cycle_steps.dt == pytest.approx(dt, rel=1e-12)


@pytest.mark.parametrize(
    ("duration", "interval"), [(0.0, 0.1), (-1.0, 0.1), (1.0, 0.0), (float("nan"), 0.1), (float("inf"), 0.1)]
)
def test_times_without_meaning_are_refused(duration, interval):
    """If it failed, a run of no time would divide by zero or never end."""
    with pytest.raises(InputError, match="must be positive and finite"):
        falling().run(duration, interval)
