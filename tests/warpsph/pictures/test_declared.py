"""From a declaration in a term or an observer, through a real run and its file, to the picture."""

from dataclasses import dataclass

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.field import Field
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.term import Term
from warpsph.files.results import ResultFile
from warpsph.pictures.looks import choose_look
from warpsph.pictures.panels import panels_of
from warpsph.run.measured import Measured
from warpsph.run.simulation import Simulation


@dataclass(frozen=True, eq=False)
class Dye(Term):
    """A dye that stays where it is."""

    dye = Field(float, "kg/m^3", "dye", written=True, colours="magma")


def observe(state, time):
    """One number, and one profile over heights, of the dye."""
    return {
        "dye_in_all": Measured(float(state["dye"].sum()), "kg", "dye in all", per_depth=True),
        "dye_profile": Measured(state["dye"][:2], "kg/m^3", "dye by height", over="dye_height"),
        "dye_height": Measured(np.array([0.1, 0.2]), "m", "height"),
    }


@pytest.fixture(params=[2, 3])
def dyed(request, tmp_path) -> ResultFile:
    """A few dyed particles at rest, in the plane and in space, after one frame."""
    model = Model(request.param, 0.1, (fluid_material("water", 1000.0),), (Dye(),), gravity=(0.0, 0.0, 0.0))
    position = lattice((0.0,) * request.param, (0.3,) * request.param, 0.1)
    particles = Particles()
    particles.add(position, Role.FREE, dye=np.linspace(0.0, 1.0, len(position)))
    simulation = Simulation(Executor("cpu", 1), model, particles, dt=0.05, observe=observe)
    simulation.run(0.1, 0.1, output=tmp_path / "dyed.vtkhdf")
    return ResultFile(tmp_path / "dyed.vtkhdf")


def test_a_field_of_a_term_is_drawn_as_declared(dyed):
    """If it failed, a new kind of physics would need a line in some table before one could look at it."""
    look = choose_look(dyed, "dye", [dyed.frame(0), dyed.frame(-1)])
    assert look.title == "dye [kg/m³]"
    assert look.mappable.get_cmap().name == "magma"
    assert choose_look(dyed, "speed", [dyed.frame(-1)]).title == "speed [m/s]"


def test_diagnostics_are_plotted_as_declared(dyed):
    """If it failed, a diagnostic would lose its label, or count per metre of a depth that the run has already."""
    per_depth = "/m" if dyed.provenance["dimension"] == 2 else ""
    assert [panel.title for panel in panels_of(dyed)] == [
        f"kinetic energy [J{per_depth}]",
        "highest speed [m/s]",
        f"dye in all [kg{per_depth}]",
        "dye by height [kg/m³]",
    ]
