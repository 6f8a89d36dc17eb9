"""Places that single precision or a periodic box cannot hold are refused when a case is built."""

from dataclasses import dataclass

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice, tank
from warpsph.core.periodic import PeriodicBox
from warpsph.core.term import Term
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, CorrectedFluid, Elasticity, Fluid, PreciseMotion, SummedDensity

dx = 0.1
KINDS = [
    (Fluid(1.0, 10.0), SummedDensity()),
    (CorrectedFluid(1.0, 10.0),),
    (Conduction(),),
    (Elasticity(1.0e3, 0.3),),
    (PreciseMotion(),),
]


@dataclass(frozen=True, eq=False)
class Still(Term):
    """Something that needs a step."""

    def longest_steps(self, model, moving):
        return {"nothing": 1.0}


def build(points, length=0.0, terms=(), other=None, along=0):
    edges = [0.0, 0.0, 0.0]
    edges[along] = length
    box = PeriodicBox((0.0, 0.0, 0.0), edges) if length else None
    materials = (fluid_material("melt", 1.0, conductivity=1.0, heat_capacity=10.0), fluid_material("glass", 1.0))
    model = Model(2, dx, materials, (*terms, Still()), gravity=(0.0, 0.0, 0.0), periodic=box)
    particles = Particles()
    particles.add(points, Role.FREE, "melt")
    if other is not None:
        particles.add(other, Role.DUMMY, "glass")
    return Simulation(Executor("cpu", 1), model, particles)


@pytest.mark.parametrize("terms", KINDS, ids=lambda terms: type(terms[0]).__name__)
def test_a_case_far_from_the_origin_is_refused(terms):
    """At 1000 km particles of a spacing of 10 cm would sit on a grid of 6 cm, and say nothing."""
    block = lattice((1.0e6, 0.0), (1.0e6 + 1.0, 1.0), dx)
    with pytest.raises(
        InputError, match=r"1e\+06 m from the origin .* 0.062 m apart, and the spacing is 0.1 m: at most"
    ):
        build(block, terms=terms)


def test_a_case_at_a_kilometre_is_allowed():
    """There the pressure of a tank at rest is what it is at the origin."""
    build(lattice((1.0e3, 0.0), (1.0e3 + 1.0, 1.0), dx))


@pytest.mark.parametrize("disorder", [0.0, 0.1])
@pytest.mark.parametrize(("length", "what"), [(1.53, r"a gap of 0\.0"), (1.56, "a gap of"), (1.46, "an overlap of")])
def test_a_period_that_does_not_fit_the_rows_is_refused(length, what, disorder):
    """A gap or an overlap across the border is a crack, or a compression, from which the fluid flies off."""
    points = lattice((0.0, 0.0), (1.5, 2.0), dx)
    points[:, :2] += np.random.default_rng(2).uniform(-disorder * dx, disorder * dx, (len(points), 2))
    with pytest.raises(InputError, match=rf"{length} m along x leaves {what}.* 15 rows 0.1\d* m apart fill 1\.\d+ m"):
        build(points, length)


@pytest.mark.parametrize("length", [1.5, 1.75, 3.0])
def test_a_period_that_fits_or_stays_open_is_allowed(length):
    """A body need not fill its box, and the lattice may start anywhere."""
    build(lattice((-0.34, 0.0), (1.16, 1.0), dx), length)


def test_a_stretched_lattice_that_fills_its_period_is_allowed():
    """Rows need not be a spacing apart, but as far across the border as inside."""
    points = lattice((0.0, 0.0), (1.5, 1.0), dx)
    points[:, 0] *= 1.02
    build(points, 1.53)


@pytest.mark.parametrize("along", [0, 1])
def test_walls_beyond_a_periodic_box_are_refused(along):
    """Wrapped into the box they would lie on what is at its other side, and the run end as if it had diverged."""
    walls = tank((0.0, 0.0), (1.5, 1.5), dx)
    with pytest.raises(
        InputError, match=r"length of 1.5 m along [xy] brings 'glass' at \(.*\) m and .* onto each other"
    ):
        build(lattice((0.0, 0.0), (1.5, 1.5), dx), 1.5, other=walls, along=along)
