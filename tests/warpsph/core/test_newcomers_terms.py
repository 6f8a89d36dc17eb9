"""Terms as somebody new writes them: what works without being asked for, and what is refused with a reason."""

from dataclasses import dataclass

import numpy as np
import pytest
import warp as wp

from warpsph.core.dynamics import Dynamics
from warpsph.core.executor import Executor
from warpsph.core.field import Field, Value
from warpsph.core.labels import Phase, Role
from warpsph.core.launch import Launch
from warpsph.core.materials import COPPER, fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.term import Term
from warpsph.errors import DivergenceError, InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, SummedDensity

DX = 0.1
WATER = (fluid_material("water", 1000.0),)


@wp.kernel
def count(first: int, rate: int, counter: wp.array[int]):
    counter[0] += rate


@wp.kernel
def push(first: int, acceleration: wp.array[wp.vec3]):
    i = wp.tid() + first
    acceleration[i] += wp.vec3(1.0, 0.0, 0.0)


@wp.kernel
def warm(first: int, heat_rate: wp.array[float]):
    i = wp.tid() + first
    heat_rate[i] += 1.0e5


@dataclass
class Counter(Term):
    """Counts; a plain dataclass, compared by its values."""

    rate: int

    counter = Value(int, "", "counter")

    def move(self, launch: Launch) -> None:
        launch.whole(count, rate=self.rate)


class Push(Term):
    """A force, in a class without parameters."""

    needs = ("forces",)

    def sum_forces(self, launch: Launch) -> None:
        launch(push)


class Heater(Term):
    """A source of heat."""

    needs = ("conduction",)

    def sum_heat(self, launch: Launch) -> None:
        launch(warm)


def case(*terms, materials=WATER, dt: float | None = 1e-3, gravity=(0.0, 0.0, 0.0), **fields):
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.6, 0.6), DX), Role.FREE, **fields)
    return Simulation(Executor("cpu", 1), Model(2, DX, materials, terms, gravity=gravity), particles, dt=dt)


def test_equal_terms_are_two():
    """If it failed, two sources of the same strength would share one counter."""
    terms = (Counter(2), Counter(2))
    case(*terms).run(0.01, 0.01)
    assert [int(term.counter.numpy()[0]) for term in terms] == [20, 20]


@pytest.mark.parametrize(
    "terms", [(Push(),), (Push(), Dynamics()), (Dynamics(), Push())], ids=["alone", "behind", "before"]
)
def test_forces_are_added_in_any_order(terms):
    """If it failed, a force that stands before the built-in dynamics would silently be wiped out."""
    result = case(*terms).run(0.1, 0.1)
    assert np.allclose(result.fields["velocity"][:, 0], 0.1, rtol=1e-5)


@pytest.mark.parametrize("order", [1, -1])
def test_heat_is_added_in_any_order(order):
    """If it failed, a source of heat that stands before conduction would have no effect, without a word."""
    terms = (Heater(), Conduction(longest_interval=0.1))[::order]
    result = case(*terms, materials=(COPPER,), dt=None, temperature=500.0).run(1.0, 0.5)
    assert result.fields["temperature"].mean() == pytest.approx(500.0 + 1e5 / (8940.0 * DX**2 * 387.0), rel=1e-4)


def test_the_shorter_of_two_limits_holds():
    """If it failed, a term used twice would forget the stricter of its two limits of the time step."""

    @dataclass
    class Limited(Term):
        limit: float

        def longest_steps(self, model, moving):
            return {"mine": self.limit}

    for limits in ((1e-3, 1.0), (1.0, 1e-3)):
        assert case(*map(Limited, limits), dt=None).plan.longest == 1e-3


@pytest.mark.parametrize("start", [np.zeros(3), 3.0, np.zeros((36, 3)), np.zeros((12, 3))], ids=str)
def test_start_values_of_a_wrong_shape_are_refused(start):
    """If it failed, kernels would read and write beyond the end of an array."""

    class Wrong(Term):
        level = Field(float, "m", "level")

        def start(self, model, particles, fields):
            return {"level": start}

    with pytest.raises(InputError, match=r"field 'level': start values of shape .*36 particles need \(36,\)"):
        case(Wrong())


def test_start_values_of_an_unknown_field_are_refused():
    """If it failed, a misspelt name in a term would silently do nothing."""

    class Misspelt(Term):
        level = Field(float, "m", "level")

        def start(self, model, particles, fields):
            return {"levle": np.zeros(36)}

    with pytest.raises(InputError, match=r"Misspelt.start: there is no field 'levle'; did you mean 'level'"):
        case(Misspelt())


@pytest.mark.parametrize(("name", "value"), [("mass", 5.0), ("viscosity", 3.0), ("fluid_mass", 7.0)])
def test_what_particles_are_given_stays(name, value):
    """If it failed, values of a field would be accepted and thrown away."""
    simulation = case(Fluid(1000.0, 10.0), SummedDensity(), **{name: value})
    assert np.all(simulation.state.numpy(name) == value)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"temperature": np.nan}, "'temperature' was given values that are not finite"),
        ({"id": 3}, "'id' is not given as a field"),
        ({"held": 0.5}, "'held' was given values that are not integers"),
        ({"phase": 9}, "'phase' must be one of Phase.LIQUID"),
        ({"temperature": "hot"}, "'temperature' was given .* values; numbers are needed"),
        ({"velocity": (0.0, 0.0, 1.0)}, "a velocity has a third coordinate"),
        ({"volume": -1.0}, "volume = -1.0: must be zero or positive"),
        ({"flows": np.ones(3)}, "flows = .*one for each of 36"),
    ],
)
def test_values_without_meaning_are_refused(values, words):
    """If it failed, nonsense would run as if it were a case."""
    with pytest.raises(InputError, match=words):
        case(Conduction(), materials=(COPPER,), dt=None, **values)


@pytest.mark.parametrize("role", [7, -1, 1.5, "FREE"])
def test_roles_without_meaning_are_refused(role):
    """If it failed, a particle would belong to nobody and stand still for ever."""
    with pytest.raises(InputError, match=r"role = .*must be one of Role"):
        Particles().add(np.zeros((1, 3)), role)


@pytest.mark.parametrize("dt", [-1.0, 0.0, np.nan, np.inf])
def test_time_steps_without_meaning_are_refused(dt):
    """If it failed, a negative step would get past the limit of stability."""
    with pytest.raises(InputError, match=r"dt = .*must be positive"):
        case(Elasticity(1e5, 0.3), dt=dt, phase=Phase.SOLID)


def test_a_refused_case_can_be_mended_with_the_same_terms():
    """If it failed, a second try in a notebook would complain of a simulation that never was."""
    elasticity = Elasticity(1e5, 0.3)
    with pytest.raises(InputError, match="too long"):
        case(elasticity, dt=1.0, phase=Phase.SOLID)
    case(elasticity, dt=1e-4, phase=Phase.SOLID).run(1e-3, 1e-3)


@pytest.mark.parametrize("relation", ["provides", "needs", "follows"])
def test_a_forgotten_comma_is_named(relation):
    """If it failed, a text would be taken for a tuple of its letters."""
    kind = type("Forgetful", (Term,), {relation: "dye"})
    with pytest.raises(InputError, match=rf"Forgetful\.{relation} is a text; give a tuple"):
        case(kind())


@pytest.mark.parametrize("name", ["start", "move", "check", "provides", "arrays"])
def test_fields_do_not_hide_what_a_term_does(name):
    """If it failed, the name of a field would replace a method, and fail far away from here."""
    with pytest.raises(TypeError, match=f"every term has something called '{name}'"):
        type("Hiding", (Term,), {name: Field(float, "", "hiding")})


@pytest.mark.parametrize("dtype", [wp.float32, bool, wp.vec2, np.float64])
def test_types_that_fields_cannot_have_are_refused(dtype):
    """If it failed, a field of such a type would fail when particles are sorted for the first time."""
    with pytest.raises(TypeError, match="is not one of int, float"):
        Field(dtype, "", "odd")


def test_two_declarations_of_one_name_are_refused_with_the_remedy():
    """If it failed, two terms would write to one array that each believes its own."""

    class One(Term):
        level = Field(float, "m", "level")

    class Other(Term):
        level = Field(float, "m", "level")

    with pytest.raises(InputError, match=r"One and Other both declare a field 'level'.*level = One.level"):
        case(One(), Other())


def test_names_of_constants_are_refused():
    """If it failed, a kernel would get a constant in place of the field of that name."""
    kind = type("Hiding", (Term,), {"gravity": Field(float, "", "hiding")})
    with pytest.raises(InputError, match="a field cannot be called 'gravity'"):
        case(kind())


@pytest.mark.parametrize("name", ["position", "enthalpy"])
def test_what_is_no_longer_a_number_ends_the_run(name):
    """If it failed, a run of nonsense would call itself complete."""
    simulation = case(Conduction(longest_interval=0.1), materials=(COPPER,), dt=None, temperature=500.0)
    simulation.run(0.1, 0.1)
    broken = simulation.state.numpy(name)
    broken[7] = np.nan
    getattr(simulation.state, name).assign(broken)
    with pytest.raises(DivergenceError, match="particle"):
        simulation.run(1.0, 0.1)


def test_observers_can_neither_change_what_is_written_nor_what_was_measured(tmp_path):
    """If it failed, a careless observer would write frames of zeros, or one value into all rows."""
    from warpsph.files.results import ResultFile

    buffer = np.zeros(2)

    def careless(state, time):
        state["position"][:] = 0.0
        buffer[:] = time
        return {"times": buffer}

    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.6, 0.6), DX), Role.FREE)
    model = Model(2, DX, (fluid_material("water", 1000.0),))
    simulation = Simulation(Executor("cpu", 1), model, particles, dt=0.1, observe=careless)
    result = simulation.run(0.2, 0.1, output=tmp_path / "run.vtkhdf")
    assert np.all(ResultFile(tmp_path / "run.vtkhdf").frame(-1)[0][:, 0] > 0.0)
    assert np.allclose(result.diagnostics["times"][:, 0], [0.0, 0.1, 0.2])


def test_what_was_saved_before_the_first_step_begins_the_run_anew():
    """If it failed, a solid that is set back to its start would have no bonds, and nobody would say so."""
    simulation = case(Elasticity(1e5, 0.3), dt=None, phase=Phase.SOLID)
    saved = simulation.registry.save()
    simulation.run(0.05, 0.05)
    first = simulation.snapshot()
    simulation.registry.load(saved)
    simulation.run(0.05, 0.05)
    assert simulation.state.bonds.count.numpy().sum() > 400
    assert all(np.array_equal(first[name], values) for name, values in simulation.snapshot().items())


def test_forces_and_rates_can_be_found_without_a_step():
    """If it failed, whoever wants a density, a force or a flux once would have to call private methods."""
    simulation = case(Fluid(1000.0, 10.0, tension=True), SummedDensity(), dt=None)
    simulation.prepare()
    squeezed = simulation.state.numpy("position") * [0.9, 0.9, 1.0]
    before = simulation.snapshot()["density"]
    simulation.state.position.assign(squeezed)
    simulation.state.outdated.fill_(1)
    simulation.prepare()
    assert np.all(simulation.snapshot()["density"] > before)
    assert simulation.steps == 0
    assert simulation.time == 0.0
    simulation.state.acceleration.zero_()
    simulation.solver.act("sum_forces")
    assert np.abs(simulation.state.numpy("acceleration")).max() > 0.0
