"""The periodic box: what it refuses, the neighbour list against brute force, and places that leave it."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.periodic import PeriodicBox
from warpsph.core.state import State
from warpsph.errors import InputError
from warpsph.machine import Inlet, LevelGauge, OscillatingMould, SymmetryPlane
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Floor, Fluid, HeatWall, Lamp, PreciseMotion, SummedDensity

DX = 0.1
RADIUS = np.float32((2.6 + 0.4) * DX)
LOWER = np.array([-0.37, -1.2, 0.15])
LENGTHS = np.array([0.93, 1.31, 1.0])
WATER = fluid_material("water", 1000.0)
PERIODIC = {2: ("x", "y", "xy"), 3: ("x", "z", "yz", "xyz")}
AXES = [(dimension, axes) for dimension, several in PERIODIC.items() for axes in several]


def box_along(axes: str) -> PeriodicBox:
    return PeriodicBox(LOWER, [length if axis in axes else 0.0 for axis, length in zip("xyz", LENGTHS, strict=True)])


def points(kind: str, dimension: int) -> np.ndarray:
    """Places (n, 3) [m] in the box, on its border, or outside."""
    generator = np.random.default_rng(11)
    x = LOWER + generator.uniform(0.0, 1.0, (120 if dimension == 2 else 500, 3)) * LENGTHS
    if kind == "on the border":
        on = generator.integers(0, 3, x.shape)
        x = np.where(on == 0, LOWER, np.where(on == 1, LOWER + LENGTHS, x))[:60]
    if kind == "outside":
        x += generator.uniform(-0.06, 0.06, x.shape) + generator.integers(-1, 2, x.shape) * LENGTHS
    if kind == "coincident":
        x[10:15] = LOWER
        x[15:18] = LOWER + LENGTHS
    x[:, dimension:] = 0.0
    return x


def simulation_of(x: np.ndarray, box: PeriodicBox, dimension: int, device: str = "cpu", **options) -> Simulation:
    """Particles at ``x`` (n, 3) [m] that fly freely, at rest."""
    particles = Particles()
    particles.add(x, Role.FREE)
    model = Model(dimension, DX, (WATER,), options.pop("terms", ()), gravity=(0.0, 0.0, 0.0), periodic=box)
    return Simulation(Executor(device), model, particles, dt=1.0e-4, **options)


def pairs_of(state: State) -> list[tuple[int, int]]:
    rows, id = state.neighbours, state.numpy("id")
    entry, count = rows.entry.numpy(), rows.count.numpy()
    return sorted(
        (int(id[i]), int(id[entry[i * rows.row_stride + k * rows.entry_stride]]))
        for i in range(len(count))
        for k in range(count[i])
    )


@pytest.mark.parametrize("kind", ["inside", "on the border", "outside", "coincident"])
@pytest.mark.parametrize(("dimension", "axes"), AXES)
def test_list_is_what_brute_force_finds(device, dimension, axes, kind):
    """A pair that is missing across the border is a crack there; one that stands twice doubles its force."""
    box = box_along(axes)
    simulation = simulation_of(points(kind, dimension), box, dimension, device)
    simulation.prepare()
    x = simulation.snapshot()["position"].astype(float)
    distance = np.linalg.norm(box.nearest(x[:, None] - x[None]), axis=2)
    np.fill_diagonal(distance, np.inf)
    listed = pairs_of(simulation.state)
    assert simulation.state.longest_row.numpy()[0] == 0
    assert len(set(listed)) == len(listed)
    found = np.zeros(distance.shape, bool)
    found[tuple(np.transpose(listed))] = True
    assert np.all(found[distance < RADIUS * (1.0 - 1e-6)])
    assert not np.any(found[distance > RADIUS * (1.0 + 1e-6)])


@pytest.mark.parametrize("precise", [False, True], ids=["single", "double"])
def test_places_come_back_into_the_box_without_a_loss(device, precise):
    """A particle would lose up to half a digit each time it comes around, and its bonds would feel that."""
    generator = np.random.default_rng(2)
    box, x = box_along("xz"), points("inside", 3)
    simulation = simulation_of(x, box, 3, device, terms=(PreciseMotion(),) if precise else ())
    simulation.prepare()
    state = simulation.state
    order = state.numpy("id")
    far = x + generator.integers(-3, 4, x.shape) * box.edges + generator.uniform(-1e-9, 1e-9, x.shape)
    moved = far[order].astype(np.float32)
    state.position.assign(moved)
    state.position_carry.assign((moved - far[order]).astype(np.float32))
    if precise:
        state.precise_position.assign(far[order])
    state.outdated.fill_(1)
    simulation.solver.neighbours.renew_if_outdated()
    kept = simulation.snapshot()
    place = kept["position"].astype(float) - state.numpy("position_carry")[np.argsort(state.numpy("id"))]
    assert np.allclose(box.nearest(place - x), far - x - box.edges * np.rint((far - x) * box.inverse), atol=1e-13)
    inside = (place >= box.lower) & (place < np.asarray(box.lower) + box.edges)
    assert np.all(inside[:, [0, 2]])
    assert np.array_equal(state.numpy("position"), state.numpy("reference"))


def test_a_particle_that_flies_around_is_where_it_should_be(device):
    """A place that is wrapped at the wrong moment, or a reference left behind, would hold or throw the particle."""
    simulation = simulation_of(points("inside", 2), box_along("xy"), 2, device)
    before = simulation.snapshot()["position"].astype(float)
    velocity = np.array([0.31, -0.77, 0.0])
    simulation.state.velocity.assign(np.tile(velocity, (len(before), 1)))
    simulation.solver.set_steps(0.01, 0.01)
    simulation.prepare()
    for _ in range(1000):
        simulation.solver.step()
    after = simulation.snapshot()["position"].astype(float)
    assert np.allclose(box_along("xy").nearest(after - before - 10.0 * velocity), 0.0, atol=1e-6)
    assert np.all((after > LOWER - 0.2 * DX)[:, :2] & (after < LOWER + LENGTHS + 0.2 * DX)[:, :2])
    # a particle that jumps with the border would look as if it had outrun the skin: the list, renewed at each step
    assert simulation.state.renewals.numpy()[0] < 1.2 * 10.0 * np.linalg.norm(velocity) / (0.2 * DX)


@pytest.mark.parametrize(
    ("lower", "lengths"),
    [((0, 0), (1, 1, 0)), ((0, 0, 0), (1, 1)), ((0, 0, 0), (0, 0, 0)), ((0, 0, 0), (-1, 0, 0)), ((0, 0, 0), "abc"),
     ((0, 0, 0), (np.nan, 0, 0)), ((np.inf, 0, 0), (1, 0, 0)),
     ((0, 0, 0), (1e39, 0, 0)), ((0, 0, 0), (1e-50, 0, 0)), ((0, 0, 0), (1e-50, 1, 0)),
     ((0, 0, 0), 1.0), ((0, 0, 0), None)],
)  # fmt: skip
def test_a_box_that_is_none_is_refused(lower, lengths):
    """A crash much later would say nothing of the box."""
    with pytest.raises(InputError, match="PeriodicBox: l"):
        PeriodicBox(lower, lengths)


def test_the_plane_has_no_period_along_z():
    """A third length in the plane means that the dimension is not what the user thinks."""
    with pytest.raises(InputError, match="in two dimensions"):
        Model(2, DX, (WATER,), periodic=PeriodicBox((0, 0, 0), (1, 0, 1)))
    with pytest.raises(InputError, match="a PeriodicBox, or None"):
        Model(2, DX, (WATER,), periodic=(1.0, 0.0, 0.0))  # type: ignore[arg-type]


def test_a_short_period_is_refused_and_the_least_length_is_enough(device):
    """With fewer cells a particle would see one image of another and miss the other; the remedy must be one."""
    with pytest.raises(InputError, match=r"0\.89 m along y: must be at least") as refused:
        simulation_of(points("inside", 2), PeriodicBox(LOWER, (0.0, 0.89, 0.0)), 2, device)
    least = float(str(refused.value).partition("at least ")[2].split()[0])
    assert 0.9 <= least < 0.901
    simulation_of(points("inside", 2), PeriodicBox(LOWER, (0.0, least, 0.0)), 2, device)


def gauge() -> LevelGauge:
    return LevelGauge((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), 1.0, 0.1, 2.0)


MACHINE = (Fluid(1000.0, 10.0), SummedDensity(), Conduction())


@pytest.mark.parametrize(
    ("axis", "terms"),
    [
        ("x", (Conduction(walls=(HeatWall.insulated((1.0, 0.0, 0.0), 0.0),)),)),
        ("y", (PreciseMotion(), Floor())),
        ("x", (PreciseMotion(), Lamp((0.0, 0.0, 0.0), 1.0, 0.1))),
        ("y", (OscillatingMould(0.1, 1.0),)),
        ("x", (SymmetryPlane((1.0, 0.0, 0.0), 0.0),)),
        ("y", (*MACHINE, gauge())),
        ("y", (*MACHINE, g := gauge(), Inlet(g, np.zeros((1, 3)), (0.0, -1.0, 0.0), 0.1, 1000.0))),
    ],
    ids=["wall", "floor", "lamp", "mould", "symmetry", "gauge", "inlet"],
)
def test_what_has_one_place_is_refused_where_the_box_is_periodic(axis, terms):
    """A wall that is there once in all periods would heat one side of the border and not the other."""
    with pytest.raises(InputError, match=f"has one place along {axis}, so the box cannot be periodic there"):
        simulation_of(points("inside", 2), box_along(axis), 2, terms=terms)
    other = {"x": "y", "y": "x"}[axis]
    if not isinstance(terms[-1], Lamp | Inlet | LevelGauge):
        simulation_of(points("inside", 2) + np.array([1.0, 0.0, 0.0]), box_along(other), 2, terms=terms)


def test_a_box_of_too_many_cells_is_shown_as_it_is():
    """The particles' own corners would hide that it is the period which is too long."""
    with pytest.raises(InputError, match=r"the box from \(0, .*\) to \(1e\+09, .*\) m has"):
        simulation_of(points("inside", 2) + np.array([9.0, 0.0, 0.0]), PeriodicBox((0.0, 0.0, 0.0), (1e9, 0.0, 0.0)), 2)
