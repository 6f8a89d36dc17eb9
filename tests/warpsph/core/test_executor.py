"""The executor: the same bits whatever the number of threads, recorded or not."""

import os

import numpy as np
import pytest
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Fluid, SummedDensity


def collapsing_column(executor: Executor) -> Simulation:
    dx = 0.02
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.2, 0.4), dx), Role.FREE)
    particles.add(tank((0.0, 0.0), (0.6, 0.5), dx), Role.DUMMY)
    model = Model(2, dx, (fluid_material("water", 1000.0, viscosity=0.5),), (Fluid(1000.0, 30.0), SummedDensity()))
    return Simulation(executor, model, particles)


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="this machine has one core, so there is nothing to compare")
def test_threads_do_not_change_a_bit():
    """A result that depends on the number of threads could not be reproduced."""
    one, two = (collapsing_column(Executor("cpu", threads)).run(0.2, 0.1) for threads in (1, 2))
    assert np.array_equal(one.positions, two.positions)
    assert all(np.array_equal(one.fields[name], two.fields[name], equal_nan=True) for name in one.fields)
    assert one.diagnostics["highest_speed"][-1] > 0.5


def test_recorded_steps_are_the_steps(device):
    """A recording that loses a launch or a condition would simulate something else."""
    direct, recorded = (collapsing_column(Executor(device)) for _ in range(2))
    for simulation in (direct, recorded):
        simulation.solver.set_steps(simulation.plan.longest, simulation.plan.longest)
        simulation.prepare()
    recording = recorded.executor.record(recorded.solver.step)
    for _ in range(200):
        direct.solver.step()
    recorded.executor.replay([(recording, 200)])
    assert direct.state.renewals.numpy()[0] > 1
    for name in direct.state.arrays:
        assert np.array_equal(direct.state.numpy(name), recorded.state.numpy(name)), name


def test_a_condition_is_decided_at_replay(device):
    """A condition fixed at recording would never renew the neighbour list, or always."""

    @wp.kernel
    def count(first: int, number: wp.array[int]):
        number[0] += 1

    executor = Executor(device)
    flag, number = (wp.zeros(1, dtype=int, device=device) for _ in range(2))
    recording = executor.record(lambda: executor.when(flag, lambda: executor.whole(count, 1, [number])))
    executor.replay([(recording, 3)])
    assert number.numpy()[0] == 0
    flag.fill_(1)
    executor.replay([(recording, 3)])
    assert number.numpy()[0] == 3


@pytest.mark.parametrize("name", ["cuda:99", "gpu", ""])
def test_unknown_device_is_refused(name):
    """A mistyped device must not fall back to another one in silence."""
    with pytest.raises(InputError, match="available: auto, cpu"):
        Executor(name)


@pytest.mark.parametrize("threads", [0, -1, 100_000])
def test_impossible_threads_are_refused(threads):
    """More spinning threads than cores would make a run crawl."""
    with pytest.raises(InputError, match="core"):
        Executor("cpu", threads)
