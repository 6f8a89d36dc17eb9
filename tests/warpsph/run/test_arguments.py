"""What a simulation cannot be built from, or cannot do, is refused in one line that names the argument."""

from typing import Any

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Fluid, SummedDensity

DX = 0.02
MODEL = Model(2, DX, (fluid_material("water", 1000.0),), (Fluid(1000.0, 10.0), SummedDensity(), Conduction()))
NAN = float("nan")


def particles(**values: Any) -> Particles:
    made = Particles()
    made.add(lattice((0.0, 0.0), (0.1, 0.1), DX), Role.FREE, **values)
    return made


def built(**changed: Any) -> Simulation:
    return Simulation(**({"executor": Executor("cpu", 1), "model": MODEL, "particles": particles()} | changed))


def refused(what) -> str:
    with pytest.raises(InputError) as caught:
        what()
    text = str(caught.value)
    assert "\n" not in text
    assert len(text) < 250
    return text


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"executor": "cpu"}, "executor = 'cpu'"),
        ({"model": None}, "model = None"),
        ({"particles": np.zeros((100, 3))}, "particles = array("),
        ({"parts": SummedDensity()}, "parts = SummedDensity()"),
        ({"dt": "short"}, "dt = 'short'"),
        ({"dt": -1.0}, "dt = -1.0"),
        ({"step_factor": "small"}, "step_factor = 'small'"),
        *(({"speed_limit": limit}, "speed_limit = ") for limit in (-1.0, NAN, "fast")),
        *(({"lower": corner}, "lower, upper = ") for corner in ((0.0, 0.0), "abc", 1.0, (NAN, 0.0, 0.0))),
        ({"observe": "energy"}, "observe = 'energy'"),
        ({"describe": 3}, "describe = 3"),
    ],
)
def test_a_simulation_is_not_built_from_nonsense(changed, words):
    """If it failed, a slip in a script would end in a traceback out of the engine."""
    assert words in refused(lambda: built(**changed))


@pytest.mark.parametrize(
    ("values", "words"),
    [
        *(({name: 0.0}, f"'{name}' was given values that are not positive") for name in ("mass", "density")),
        *(({"velocity": v}, "velocity") for v in ("fast", (1.0, 2.0), (NAN, 0.0, 0.0), None, (0.0, 0.0, 1.0))),
        *(({"phase": phase}, "phase") for phase in ("solid", 7)),
        *(({"temperature": T}, "temperature") for T in ("hot", NAN, None, [1.0, 2.0], {})),
        ({"material": "watr"}, "unknown material 'watr'; did you mean 'water'?"),
        ({"temprature": 300.0}, "no term of this case has a field 'temprature'; did you mean 'temperature'?"),
        ({"id": 3}, "'id' is not given as a field"),
    ],
)
def test_particles_that_do_not_fit_the_case_are_refused(values, words):
    """If it failed, particles without mass, or values of no field, would go into a run."""
    assert words in refused(lambda: built(particles=particles(**values)))


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        *(({"duration": value}, "duration = ") for value in (-1.0, 0.0, NAN, "long", None)),
        *(({"output_interval": value}, "output_interval = ") for value in (-1.0, 0.0, NAN, "often", None)),
        ({"output": 3}, "output = 3"),
        ({"progress": "bar"}, "progress = 'bar'"),
        ({"parameters": 3}, "parameters = 3"),
    ],
)
def test_a_run_into_the_past_or_nowhere_is_refused(changed, words):
    """If it failed, a run would never end, or end in a traceback."""
    simulation = built()
    assert words in refused(lambda: simulation.run(**({"duration": 0.01, "output_interval": 0.01} | changed)))


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (3, "observe gave 3"),
        ({"level": "high"}, "diagnostic 'level' is no number: 'high'"),
        ({"time": 1.0}, "cannot call a diagnostic 'time'"),
    ],
)
def test_an_observer_that_gives_no_numbers_is_refused(given, words):
    """If it failed, a slip in an observer would look like a fault of the engine."""
    assert words in refused(lambda: built(observe=lambda state, time: given).run(0.01, 0.01))


def test_names_that_are_not_there_are_refused_with_the_nearest():
    """If it failed, a typo in a script would end in a KeyError."""
    simulation = built()
    assert "did you mean 'find_density'?" in refused(lambda: simulation.solver.act("find_densty"))
    result = simulation.run(0.001, 0.001)
    assert "did you mean 'water'?" in refused(lambda: result.made_of("watr"))


def test_each_particle_may_have_a_material_of_its_own():
    """If it failed, a table of particles of several materials would have to be taken apart first."""
    names = np.array(["oil", "water"])[np.arange(25) % 2]
    model = Model(2, DX, tuple(fluid_material(name, 1000.0) for name in ("water", "oil")), MODEL.terms)
    state = built(model=model, particles=particles(material=names)).snapshot()
    assert np.array_equal(state["material"], (names == "oil").astype(int))
    some = particles(material="water")
    some.add(lattice((0.2, 0.0), (0.3, 0.1), DX), Role.FREE, "oil")
    assert np.array_equal(built(model=model, particles=some).snapshot()["material"], np.repeat([0, 1], 25))
