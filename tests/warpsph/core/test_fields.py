"""Declared arrays: start values, names, sorting, and what is found of them."""

from dataclasses import dataclass

import numpy as np
import pytest
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.field import Field
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import COPPER, fluid_material, thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, PhaseChange, SummedDensity

DX = 0.01


@dataclass(frozen=True, eq=False)
class Marks(Term):
    """Fields of a scenario's own, that nothing changes."""

    mark = Field(float, "kg/m^3", "mark of the maker", start=7.0, written=True)
    miscarry = Field(int, "", "a name with carry in it")
    arrow = Field(wp.vec3, "m", "arrow", written=True)


def block(device: str = "cpu", *terms: Term, **fields) -> Simulation:
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (8 * DX, 8 * DX), DX), Role.FREE, **fields)
    model = Model(2, DX, (fluid_material("water", 1000.0),), terms, gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device), model, particles, dt=1e-4)


def melt(device: str) -> Simulation:
    """A block that flows, conducts, freezes and is elastic."""
    particles = Particles()
    x = lattice((0.0, 0.0), (10 * DX, 10 * DX), DX)
    particles.add(x, Role.FREE, temperature=np.where(x[:, 0] < 5 * DX, 1500.0, 1900.0))
    terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
    return Simulation(Executor(device), Model(2, DX, (thesis_steel(),), terms), particles)


def test_a_field_of_a_scenarios_own_is_in_state_result_and_file(tmp_path):
    """If it failed, a scenario could not write what it measures for each particle."""
    marks = np.linspace(0.0, 1.0, 64)
    path = tmp_path / "marks.vtkhdf"
    result = block("cpu", Marks(), mark=marks, arrow=(1.0, 2.0, 3.0)).run(1e-3, 1e-3, output=path)
    assert np.allclose(result.fields["mark"], marks)
    stored = ResultFile(path)
    _, fields = stored.frame(-1)
    assert np.allclose(fields["mark"][np.argsort(fields["id"])], marks)
    assert np.allclose(fields["arrow"], (1.0, 2.0, 3.0))
    assert "miscarry" not in fields
    assert stored.field_quantities["mark"].title == "mark of the maker [kg/m^3]"


def test_a_name_may_contain_carry():
    """If it failed, a field would be missing from snapshots because of how it is called."""
    snapshot = block("cpu", Marks()).snapshot()
    assert "miscarry" in snapshot
    assert "position_carry" not in snapshot


@pytest.mark.parametrize("name", ["count", "device", "fields", "snapshot", "position", "neighbours"])
def test_names_that_are_taken_are_refused(name):
    """If it failed, an array would hide an attribute of the state, or another array."""
    state = block("cpu").state
    field = Field(float, "", "a field")
    field.__set_name__(State, name)
    with pytest.raises(InputError, match=f"'{name}' is taken"):
        state.add(field, np.zeros(state.count))


def test_values_of_an_unknown_field_are_refused():
    """If it failed, a misspelt field would silently keep its default."""
    with pytest.raises(InputError, match=r"no term of this case has a field 'mrk'; did you mean 'mark'"):
        block("cpu", Marks(), mrk=1.0)


def test_values_of_a_wrong_shape_are_refused():
    """If it failed, values would be spread over the wrong particles."""
    with pytest.raises(InputError, match=r"'mark' was given values of shape \(5,\); 64 particles"):
        block("cpu", Marks(), mark=np.zeros(5))


def test_materials_are_known_by_name():
    """If it failed, a misspelt material would be another one."""
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE, "coper")
    with pytest.raises(InputError, match="unknown material 'coper'; did you mean 'copper'"):
        Simulation(Executor("cpu", 1), Model(2, DX, (COPPER, thesis_steel())), particles, dt=1.0)


def test_a_case_without_particles_is_refused():
    """If it failed, an empty case would end in a traceback."""
    with pytest.raises(InputError, match="particles: there is none"):
        Simulation(Executor("cpu", 1), Model(2, DX, (COPPER,)), Particles(), dt=1.0)


def test_every_kept_field_follows_its_particle_when_particles_are_sorted(device):
    """If it failed, stress in a snapshot would belong to other particles after a renewal of the list."""
    simulation = melt(device)
    simulation.prepare()
    state, count = simulation.state, simulation.state.count
    moved = state.numpy("position") * [-1.0, 1.0, 1.0]
    state.position.assign(moved)
    ids = state.numpy("id")
    marks = {}
    for name, array in state.kept.items():
        if name in ("id", "role", "material", "position"):
            continue
        shape = array.numpy().shape
        marks[name] = np.broadcast_to(ids.reshape(-1, *[1] * (len(shape) - 1)), shape)
        array.assign(marks[name].astype(array.numpy().dtype))
    state.outdated.fill_(1)
    simulation.solver.neighbours.renew_if_outdated()
    after = state.numpy("id")
    assert not np.array_equal(after, ids)
    for name, array in state.kept.items():
        if name in marks:
            first = array.numpy().reshape(count, -1)[:, 0]
            assert np.array_equal(first, after), name


def test_snapshot_after_a_step_with_heat_that_renews_the_list(device):
    """If it failed, what observers see of forces and stress would belong to other particles."""
    simulation = melt(device)
    x = simulation.state.numpy("position")
    simulation.state.velocity.assign(np.where(x[:, :1] < 5 * DX, [[0.4, 0.0, 0.0]], [[-0.4, 0.0, 0.0]]))
    simulation.run(5e-3, 5e-3)
    assert simulation.state.renewals.numpy()[0] > 1
    before = simulation.snapshot()
    simulation.state.outdated.fill_(1)
    simulation.solver.neighbours.renew_if_outdated()
    after = simulation.snapshot()
    for name in ("acceleration", "stress", "deformation", "density", "temperature"):
        assert np.array_equal(before[name], after[name]), name
    assert np.any(before["phase"] == Phase.SOLID)
