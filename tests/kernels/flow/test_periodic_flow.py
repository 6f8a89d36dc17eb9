"""Flow that fills a periodic box: density, momentum, and no trace of where the box is cut."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.core.state import Snapshot
from warpsph.run.simulation import Simulation
from warpsph.terms import ContinuityDensity, CorrectedFluid, Fluid, SummedDensity

DX = 0.1
RHO, SOUND = 1000.0, 5.0
LOWER = np.array([-0.37, 0.11, 1.05])
ROWS = {2: 20, 3: 12}
FLUID = Fluid(RHO, SOUND)
FLOWS = {
    "summed": lambda: (FLUID, SummedDensity()),
    "continuity": lambda: (FLUID, ContinuityDensity()),
    "corrected": lambda: (CorrectedFluid(RHO, SOUND),),
}


def flow(
    device: str,
    dimension: int,
    kind: str,
    *,
    jitter: float = 0.0,
    speed: float = 0.0,
    shift: float = 0.0,
    acceleration: float = 0.0,
) -> tuple[Simulation, PeriodicBox]:
    """Water that fills a box periodic along all its axes; ``shift`` is where it is cut, in periods along each axis."""
    edge = ROWS[dimension] * DX
    x = lattice(LOWER[:dimension], LOWER[:dimension] + edge, DX)
    x[:, :dimension] += np.random.default_rng(5).uniform(-jitter, jitter, (len(x), dimension)) * DX
    phase = 2.0 * np.pi * (x - LOWER) / edge
    velocity = np.zeros_like(x)
    velocity[:, 0], velocity[:, 1] = speed * (0.5 + np.sin(phase[:, 1])), speed * np.sin(phase[:, 0])
    particles = Particles()
    particles.add(x, Role.FREE, velocity=velocity)
    lower = LOWER + shift * edge
    box = PeriodicBox(lower * [1, 1, dimension == 3], [edge, edge, edge if dimension == 3 else 0.0])
    water, gravity = fluid_material("water", RHO, 5.0), (acceleration, 0.0, 0.0)
    model = Model(dimension, DX, (water,), FLOWS[kind](), gravity=gravity, periodic=box)
    return Simulation(Executor(device), model, particles), box


def run(simulation: Simulation, steps: int) -> Snapshot:
    duration = steps * simulation.plan.longest
    simulation.run(duration, duration)
    return simulation.snapshot()


def momentum(state: Snapshot) -> np.ndarray:
    return state["mass"].astype(float) @ state["velocity"].astype(float)


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_lattice_has_the_same_density_everywhere(device, dimension):
    """A pair missing or doubled at the border would be a layer of pressure there."""
    simulation, _ = flow(device, dimension, "summed")
    simulation.prepare()
    density = simulation.snapshot()["density"]
    assert np.allclose(density, RHO, rtol=1e-5)


@pytest.mark.parametrize("kind", ["summed", "continuity"])  # corrected gradients do not keep it
@pytest.mark.parametrize("dimension", [2, 3])
def test_momentum_stays(device, dimension, kind):
    """Pairs that see each other differently across the border would drive the flow by themselves."""
    simulation, _ = flow(device, dimension, kind, jitter=0.2, speed=0.5)
    simulation.prepare()
    before = momentum(simulation.snapshot())
    after = run(simulation, 200)
    assert np.ptp(np.linalg.norm(after["velocity"], axis=1)) > 0.1
    total = 0.5 * np.sum(after["mass"], dtype=float)
    assert np.allclose(momentum(after), before, rtol=0.0, atol=1e-5 * total)


@pytest.mark.parametrize("kind", FLOWS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_a_stream_passes_the_border_unchanged(device, dimension, kind):
    """A lattice that is carried through the border would be disturbed there."""
    simulation, box = flow(device, dimension, kind)
    velocity = np.array([1.1, -0.7, 0.4 * (dimension == 3)])
    simulation.state.velocity.assign(np.tile(velocity, (simulation.state.count, 1)))
    simulation.prepare()
    before = simulation.snapshot()
    after = run(simulation, 160)
    assert np.linalg.norm(velocity) * simulation.time > 1.2 * box.edges[0]
    assert np.allclose(after["density"], before["density"], rtol=1e-5)
    assert np.allclose(after["velocity"], velocity, atol=1e-4)
    way = after["position"].astype(float) - before["position"]
    assert np.allclose(box.nearest(way - velocity * simulation.time), 0.0, atol=1e-3 * DX)


@pytest.mark.parametrize("kind", FLOWS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_where_the_box_is_cut_makes_no_difference(device, dimension, kind):
    """The border is no place in space: a flow that knew of it would be two flows."""
    one, box = flow(device, dimension, kind, jitter=0.1, speed=0.5)
    other, _ = flow(device, dimension, kind, jitter=0.1, speed=0.5, shift=1.0 / 3.0)
    steps = 10 if kind == "corrected" else 15  # in noise like this its rounding grows threefold in five steps
    a, b = run(one, steps), run(other, steps)
    assert not np.allclose(a["position"], b["position"], atol=DX)
    away = box.nearest(b["position"].astype(float) - a["position"])
    assert np.allclose(away, 0.0, atol=1e-4 * DX)
    assert np.allclose(a["velocity"], b["velocity"], atol=1e-4)
    assert np.allclose(a["density"], b["density"], rtol=1e-5)


def test_a_force_along_the_period_drives_the_flow_for_ever(device):
    """Gravity along a periodic axis has no floor to end on: the whole box falls as one."""
    simulation, _ = flow(device, 2, "summed", acceleration=3.0)
    state = run(simulation, 200)
    assert np.allclose(state["velocity"], [3.0 * simulation.time, 0.0, 0.0], atol=1e-4)
