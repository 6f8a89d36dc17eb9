"""What passes between the reservoir and a fluid whose density follows the equation of continuity."""

import numpy as np
import pytest

from warpsph.core.executor import Executor, available_cores
from warpsph.core.labels import Role
from warpsph.core.materials import thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.machine import Inlet, LevelGauge, Outflow
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, ContinuityDensity, Fluid

SPACING, SPEED, TOP, MOUTH = 0.01, 0.2, 0.3, 0.25
RHO_0 = 2100.0


def strand(executor: Executor, reservoir_density: float = RHO_0) -> Simulation:
    """Melt that is poured onto a strand that is withdrawn, with density by continuity."""
    particles = Particles()
    row = lattice((0.0, 0.0), (6 * SPACING, SPACING), SPACING)
    row[:, 1] = TOP
    filling = np.concatenate([row - np.array([0.0, k * SPACING, 0.0]) for k in range(5)])
    particles.add(filling, Role.INFLOW, temperature=1933.0)
    particles.add(lattice((0.0, 0.0), (6 * SPACING, 0.24), SPACING), Role.FREE, temperature=1900.0)
    particles.add(lattice((0.0, -0.04), (6 * SPACING, 0.0), SPACING), Role.OUTFLOW, temperature=1700.0)
    reserve = np.tile([[0.0, TOP, 0.0]], (60, 1))
    particles.add(reserve, Role.RESERVOIR, temperature=1933.0, density=reservoir_density)
    gauge = LevelGauge((0.0, 0.0, -1.0), (6 * SPACING, 1.0, 1.0), 0.24, SPEED, area_ratio=1.0, gain=0.0)
    model = Model(2, SPACING, (thesis_steel(),), (Fluid(RHO_0, 10.0), ContinuityDensity(), Conduction()))
    outflow = Outflow(gauge, 0.0, -4 * SPACING, 1.0)
    inlet = Inlet(gauge, row, (0.0, -1.0, 0.0), TOP - MOUTH, 1933.0)
    return Simulation(executor, model, particles, parts=[gauge, outflow, inlet])


@pytest.mark.skipif(available_cores() < 2, reason="one core runs one thread only")
def test_same_bits_for_any_number_of_threads():
    """If it failed, one thread would read velocities that another one is setting at the same moment."""
    results = []
    for threads in (1, 2):
        simulation = strand(Executor("cpu", threads))
        simulation.run(0.1, 0.05)
        results.append(simulation.snapshot())
    for name in results[0]:
        assert np.array_equal(results[0][name], results[1][name]), name


def test_density_and_outflow_do_not_share_a_section():
    """If it failed, the density's sum over neighbours' velocities would not be over before the outflow sets them."""
    executor = Executor("cpu", available_cores())
    simulation = strand(executor)
    order: list[str] = []
    launch, meet = executor.__class__.__call__, executor.__class__.meet

    def noted_launch(self, kernel, dim, inputs):
        order.append(kernel.key)
        launch(self, kernel, dim, inputs)

    def noted_meet(self):
        order.append("meet")
        meet(self)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Executor, "__call__", noted_launch)
        patch.setattr(Executor, "meet", noted_meet)
        simulation.solver.step()
    assert "meet" in order[order.index("advance_density") : order.index("hold_zone")]


def test_what_enters_starts_with_the_reference_density(device):
    """If it failed, melt from the inlet would have the pressure of its former life."""
    simulation = strand(Executor(device), reservoir_density=1.5 * RHO_0)
    simulation.run(0.2, 0.2)
    state = simulation.snapshot()
    entered = (state["entries"] > 0) & (state["role"] == Role.INFLOW)
    assert np.sum(entered) >= 6
    assert np.abs(state["density"][entered] / RHO_0 - 1.0).max() < 0.1
    parked = (state["role"] == Role.RESERVOIR) & (state["exits"] == 0)
    assert np.all(state["density"][parked] == np.float32(1.5 * RHO_0))
