"""Friction on walls along which the fluid slips, beside the law that it follows."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.kernels.basics.host import on_host
from warpsph.kernels.flow.corrected.friction import friction_of_speed
from warpsph.run.simulation import Simulation
from warpsph.terms import CorrectedFluid, DeltaFluid, WallFriction

DX, ROWS, SPEED = 0.1, 10, 2.0
WATER = 1.0e-6  # m^2/s


def layer(device, dimension=2, viscosity=WATER, wall_viscosity=0.0, flow=CorrectedFluid, plates=0.0, times=1):
    """Fluid that moves along two plates, with one velocity everywhere, in a periodic box."""
    depth = (1.0,) * (dimension - 2)
    model = Model(
        dimension=dimension,
        spacing=DX,
        materials=(fluid_material("fluid", 1.0, viscosity), solid_material("plate", 1.0, wall_viscosity)),
        terms=(flow(1.0, 20.0), *(WallFriction() for _ in range(times))),
        gravity=(0.0, 0.0, 0.0),
        periodic=PeriodicBox((0.0, 0.0, 0.0), (1.0, 0.0, sum(depth))),
    )
    places = lattice((0.0, -3 * DX, *(0.0 for _ in depth)), (1.0, ROWS * DX + 3 * DX, *depth), DX)
    way = way_to_box(places, (-np.inf, 0.0, -np.inf), (np.inf, ROWS * DX, np.inf))
    walls = np.linalg.norm(way, axis=1) > 0.0
    particles = Particles()
    particles.add(places[~walls], Role.FREE, "fluid", velocity=(SPEED, 0.0, 0.0))
    particles.add(places[walls], Role.DUMMY, "plate", velocity=(plates, 0.0, 0.0), to_surface=way[walls])
    return Simulation(Executor(device), model, particles)


def braking(simulation):
    """Mean acceleration [m/s^2] of the fluid along the plates, in a short time."""
    duration = 0.02
    simulation.run(duration, duration)
    state = simulation.snapshot()
    return (state["velocity"][state["role"] == Role.FREE, 0].astype(float).mean() - SPEED) / duration


def test_the_law_is_that_of_smooth_walls():
    """A friction of another size would brake waves of water in their boundary layer too little or too much."""
    law = on_host(friction_of_speed)
    for speed, height in ((2.0, 4.0e-3), (1.0, 1.0e-3), (0.5, 2.0e-3)):
        shear = np.sqrt(speed * law(speed, height, WATER))
        logarithmic = shear * (np.log(height * shear / WATER) / 0.41 + 5.0)
        assert logarithmic == pytest.approx(speed, rel=0.06)
    assert law(0.01, 1.0e-3, WATER) == pytest.approx(WATER / 1.0e-3)  # viscous, close to the wall
    assert law(0.0, 1.0e-3, WATER) == pytest.approx(WATER / 1.0e-3)
    assert law(1.0, 1.0e-3, 0.0) == 0.0


@pytest.mark.parametrize("dimension", [2, 3])
def test_the_stress_is_that_of_the_law(dimension, device):
    """Sums before a face that do not add up to the face would make the friction one of the arrangement."""
    stress = SPEED * on_host(friction_of_speed)(SPEED, 0.5 * DX, WATER)
    assert braking(layer(device, dimension)) == pytest.approx(-2.0 * stress / (ROWS * DX), rel=0.1)


def test_plates_that_move_along_do_not_rub():
    """Friction by the speed in space, and not beside the wall, would brake what rests on a wall that moves."""
    assert abs(braking(layer("cpu", plates=SPEED))) < 1e-6


def test_what_it_cannot_do_is_refused():
    """A term without effect would let a case seem to have friction, and two would rub twice."""
    with pytest.raises(InputError, match="WallFriction: the fluid slips along no wall"):
        layer("cpu", wall_viscosity=1.0)
    with pytest.raises(InputError, match="WallFriction: it acts in the flow of CorrectedFluid"):
        layer("cpu", flow=DeltaFluid)
    with pytest.raises(InputError, match="friction at walls"):
        layer("cpu", times=2)
