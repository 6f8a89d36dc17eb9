"""A viscosity that depends on the temperature, beside the exact profile of a flow between a hot and a cold plate."""

import numpy as np
import pytest

from warpsph.core.composition import compose
from warpsph.core.executor import Executor
from warpsph.core.faces import way_to_box
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.core.periodic import PeriodicBox
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, CorrectedConduction, CorrectedFluid, DeltaFluid, HeatWall, ThermalViscosity

COLD, HOT = 300.0, 400.0
THICK, THIN = 0.4, 0.1  # Pa s, at the cold plate below and at the hot one above
CURVE = ((COLD, THICK), (HOT, THIN))


def profile(y):
    """Velocity over that of the plate, for a viscosity that is linear in y; straight for a constant one."""
    return np.log(1.0 + (THIN / THICK - 1.0) * y) / np.log(THIN / THICK)


def couette(
    device, rows, dimension=2, flow=CorrectedFluid, conduction=CorrectedConduction, curve=CURVE, viscosity=THICK
):
    """A layer 1 m high between a cold plate at rest and a hot one at 1 m/s, at first with the exact profile."""
    dx = 1.0 / rows
    ends = (1.0,) * (dimension - 2)
    depth = ends[0] if ends else 0.0
    fluid = fluid_material("fluid", 1.0, viscosity, conductivity=0.1, heat_capacity=1.0)
    faces = (
        HeatWall.at_temperature((0, 1, 0), 0.0, COLD),
        HeatWall.at_temperature((0, -1, 0), -1.0, HOT),
    )
    model = Model(
        dimension=dimension,
        spacing=dx,
        materials=(fluid, solid_material("plate", 1.0, viscosity)),
        terms=(ThermalViscosity({"fluid": curve}), flow(1.0, 10.0), conduction(walls=faces, longest_interval=0.02)),
        gravity=(0.0, 0.0, 0.0),
        periodic=PeriodicBox((0.0, 0.0, 0.0), (1.0, 0.0, depth)),
    )
    x = lattice((0.0,) * dimension, (1.0, 1.0, *ends), dx)
    outside = lattice((0.0, -3 * dx, *(0.0,) * len(ends)), (1.0, 1.0 + 3 * dx, *ends), dx)
    way = way_to_box(outside, (-np.inf, 0.0, -np.inf), (np.inf, 1.0, np.inf))
    walls = np.linalg.norm(way, axis=1) > 0.0
    particles = Particles()
    warmth = COLD + (HOT - COLD) * x[:, 1]
    particles.add(x, Role.FREE, "fluid", temperature=warmth, velocity=np.outer(profile(x[:, 1]), (1.0, 0.0, 0.0)))
    lid = np.outer(outside[walls, 1] > 1.0, (1.0, 0.0, 0.0))
    particles.add(outside[walls], Role.DUMMY, "plate", velocity=lid, to_surface=way[walls])
    return Simulation(Executor(device), model, particles)


def error_of(simulation):
    """RMS error of the velocity over that of the plate, and the largest of the viscosity over the highest."""
    state = simulation.snapshot()
    fluid = state["role"] == Role.FREE
    y = state["position"][fluid, 1].astype(float)
    viscosity = THICK + (THIN - THICK) * y
    error = float(np.sqrt(np.mean((state["velocity"][fluid, 0] - profile(y)) ** 2)))
    return error, float(np.abs(state["viscosity"][fluid] - viscosity).max() / THICK)


@pytest.mark.parametrize("dimension", [2, 3])
def test_shear_between_a_hot_and_a_cold_plate_is_exact(dimension, device):
    """One viscosity for all, or pairs that forget its slope, would lead to the straight profile, which is 12 % off."""
    simulation = couette(device, 10, dimension)
    simulation.run(1.5, 1.5)
    error, of_viscosity = error_of(simulation)
    assert error < 0.005  # 0.4 % with 10 rows, 0.1 % with 20: of second order
    assert of_viscosity < 0.005


def test_a_plain_flow_follows_the_temperature_too(device):
    """The term would be one of the corrected flow only."""
    simulation = couette(device, 10, flow=DeltaFluid, conduction=Conduction)
    simulation.run(1.5, 1.5)
    error, of_viscosity = error_of(simulation)
    assert error < 0.04  # its walls act some way inside the fluid
    assert of_viscosity < 0.005


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"viscosity": 0.2}, "fluid has a viscosity of 0.2 Pa s and a curve up to 0.4 Pa s: give the material 0.4"),
        ({"curve": ((400.0, 0.4), (300.0, 0.1))}, "the temperatures rising strictly"),
        ({"curve": ((300.0, -0.4),)}, r"curves = .* must be nodes \(T \[K\], mu \[Pa s\]\) by name of a material"),
        ({"curve": "thin"}, r"curves = .* must be nodes \(T \[K\], mu \[Pa s\]\) by name of a material"),
    ],
)
def test_a_curve_that_cannot_be_is_refused(given, message):
    """The step would be too long for what is thicker than the material says, or a number be read between none."""
    with pytest.raises(InputError, match=f"ThermalViscosity: .*{message}"):
        couette("cpu", 10, **given)


def test_a_case_without_temperature_is_refused():
    """The viscosity would stay what it is at the start, and nobody be told."""
    terms = (CorrectedFluid(1.0, 10.0), ThermalViscosity({"fluid": CURVE}))
    with pytest.raises(InputError, match="ThermalViscosity needs temperature in the same case: add"):
        compose(Model(2, 0.1, (fluid_material("fluid", 1.0, THICK),), terms))
