"""A run: schedule, output, divergence, interruption."""

import signal

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.errors import DivergenceError, InputError
from warpsph.files.results import ResultFile
from warpsph.run.simulation import Simulation
from warpsph.terms import Fluid, SummedDensity

DX = 0.02


def falling_block(**options) -> Simulation:
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.2, 0.2), DX), Role.FREE)
    particles.add(tank((0.0, 0.0), (0.4, 0.3), DX), Role.DUMMY)
    particles.add(np.zeros((3, 3)), Role.RESERVOIR)
    model = Model(2, DX, (fluid_material("water", 1000.0, viscosity=0.5),), (Fluid(1000.0, 30.0), SummedDensity()))
    return Simulation(Executor("cpu", 1), model, particles, **options)


def test_frames_and_diagnostics_come_when_asked(tmp_path):
    """Frames at other times than the clock says could not be compared with anything."""
    path = tmp_path / "run.vtkhdf"
    reports = []
    simulation = falling_block(observe=lambda state, time: {"doubled": 2.0 * time})
    result = simulation.run(0.1, 0.04, output=path, progress=reports.append, parameters={"a": 1})
    stored = ResultFile(path)
    assert np.allclose(stored.times, [0.0, 0.04, 0.08, 0.1], atol=simulation.solver.dt)
    assert np.allclose(stored.diagnostics["time"], stored.times)
    assert np.allclose(stored.diagnostics["doubled"], 2.0 * stored.times)
    assert np.allclose(result.diagnostics["doubled"], stored.diagnostics["doubled"])
    assert stored.parameters == {"a": 1}
    assert stored.provenance["status"] == result.status == "complete"
    assert stored.provenance["steps"] == result.steps
    assert reports[-1].time == pytest.approx(0.1, abs=simulation.solver.dt)
    points, fields = stored.frame(len(stored.times) - 1)
    present = result.fields["role"] != Role.RESERVOIR
    assert np.array_equal(np.sort(fields["id"]), result.fields["id"][present])
    assert len(points) == len(result.positions) - 3


def test_the_speed_limit_is_that_of_the_terms():
    """A flow faster than any that we had in mind would count as diverged while all is well."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.2, 0.2), DX), Role.FREE, velocity=(2.0e6, 0.0, 0.0))
    model = Model(2, DX, (fluid_material("plasma", 1000.0),), (Fluid(1000.0, 2.0e7), SummedDensity()))
    simulation = Simulation(Executor("cpu", 1), model, particles, lower=(0.0, 0.0, 0.0), upper=(1.0, 1.0, 0.0))
    simulation.run(1e-9, 1e-9)
    assert simulation.solver.speed_limit == pytest.approx(1.0e8)


def test_divergence_names_the_particle_and_keeps_the_file(tmp_path):
    """A run that blows up without a word teaches nothing."""
    path = tmp_path / "run.vtkhdf"
    with pytest.raises(DivergenceError, match=r"particle \d+ \(free, water\).*below 0.5 m/s") as caught:
        falling_block(speed_limit=0.5).run(0.5, 0.01, output=path)
    assert "sound and viscosity (7.6)" in caught.value.facts["time step"]
    assert f"frame 4 of {path}, at t = 0.03 s" == caught.value.facts["last good frame"]
    stored = ResultFile(path)
    assert stored.provenance["status"] == "diverged"
    assert len(stored.times) > 2
    assert np.all(np.isfinite(stored.frame(len(stored.times) - 1)[0]))


def test_ctrl_c_ends_in_good_order(tmp_path):
    """A user who stops a long run wants what it has done so far."""
    path = tmp_path / "run.vtkhdf"
    asked = []
    before = signal.getsignal(signal.SIGINT)

    def impatient(progress):
        if progress.time > 0.05 and not asked:
            asked.append(progress.time)
            signal.raise_signal(signal.SIGINT)

    result = falling_block().run(100.0, 0.02, output=path, progress=impatient)
    stored = ResultFile(path)
    assert result.status == stored.provenance["status"] == "interrupted"
    assert stored.times[-1] == pytest.approx(result.time)
    assert signal.getsignal(signal.SIGINT) is before


def test_too_long_a_step_is_refused():
    """A step beyond the limit of stability ends in nonsense."""
    with pytest.raises(InputError, match=r"too long.*sound and viscosity \(7.6\)"):
        falling_block(dt=0.1)


def test_an_existing_file_is_not_overwritten(tmp_path):
    """Hours of results must not vanish by a repeated command."""
    path = tmp_path / "run.vtkhdf"
    path.write_text("precious")
    with pytest.raises(InputError, match="overwrite"):
        falling_block().run(0.01, 0.01, output=path)
    assert path.read_text() == "precious"


def test_events_reach_file_and_result(tmp_path):
    """A breakout that is noticed but not kept cannot be looked up."""
    path = tmp_path / "run.vtkhdf"
    simulation = falling_block()
    simulation.events.note(0.0, "start")
    result = simulation.run(0.01, 0.01, output=path)
    assert result.events == ResultFile(path).events == [(0.0, "start")]


def test_what_has_become_of_a_run_is_its_status(tmp_path):
    """A strand that is lost would be complete, and nobody would look at it."""
    path = tmp_path / "run.vtkhdf"

    def observe(state, time):
        if time > 0.05:
            simulation.events.outcome = "block lost"
        return {}

    simulation = falling_block(observe=observe)
    assert simulation.run(0.04, 0.02).status == "complete"
    assert simulation.run(0.04, 0.02, output=path).status == "block lost"
    assert ResultFile(path).provenance["status"] == "block lost"
