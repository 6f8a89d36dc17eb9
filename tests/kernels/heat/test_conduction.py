"""Heat conduction: conservation, rate, interfaces, held temperatures, and the enthalpy curve."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import COPPER, Material, melting_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction

SPACING = 0.01
STEEL = melting_material(
    "steel", density=7000.0, heat_capacity=700.0, latent_heat=270e3, solidus=1700.0, liquidus=1750.0,
    conductivity_solid=30.0, conductivity_liquid=40.0, viscosity=0.006, source="round numbers",
)  # fmt: skip


def bar(
    device: str,
    temperature,
    *,
    materials: tuple[Material, ...] = (STEEL,),
    split: bool = False,
    films: dict | None = None,
    held: bool = False,
    dimension: int = 2,
) -> Simulation:
    """A bar along x, 40 particles long; its right half is of the second material if ``split``."""
    size = (40 * SPACING, 12 * SPACING) if dimension == 2 else (20 * SPACING, 8 * SPACING, 8 * SPACING)
    x = lattice((0.0,) * dimension, size, SPACING)
    particles = Particles()
    right = x[:, 0] > 0.5 * size[0]
    for half, mine in enumerate((~right, right)):
        value = temperature(x[mine])
        edge = held & ((x[mine, 0] < 3 * SPACING) | (x[mine, 0] > size[0] - 3 * SPACING))
        material = materials[half if split else 0].name
        particles.add(x[mine], Role.FREE, material, temperature=value, held=edge)
    model = Model(dimension, SPACING, materials, (Conduction(films or {}, longest_interval=1e9),))
    return Simulation(Executor(device), model, particles)


def content(simulation: Simulation) -> float:
    s = simulation.state
    return float(
        np.sum(s.numpy("mass").astype(float) * (s.numpy("enthalpy").astype(float) - s.numpy("enthalpy_carry")))
    )


MIDDLE_HEIGHT = 4 * SPACING


def middle_rows(state) -> np.ndarray:
    """The rows of the bar whose neighbours above and below are complete."""
    return np.abs(state.numpy("position")[:, 1] - 6 * SPACING) < 0.5 * MIDDLE_HEIGHT


@pytest.mark.parametrize("dimension", [2, 3])
def test_heat_of_an_isolated_body_is_kept(device, dimension):
    """A body that gains or loses heat by itself would freeze or melt by itself."""
    generator = np.random.default_rng(1)
    simulation = bar(device, lambda x: generator.uniform(1600.0, 1900.0, len(x)), dimension=dimension)
    before = content(simulation)
    result = simulation.run(60.0, 60.0)
    assert content(simulation) == pytest.approx(before, rel=1e-6)
    assert np.ptp(result.fields["temperature"]) < 150.0


def test_linear_profile_carries_fouriers_flux(device):
    """A wrong factor here is a wrong time for everything to freeze."""
    slope = 1.0e3
    simulation = bar(device, lambda x: 1000.0 + slope * x[:, 0])
    simulation.prepare()
    simulation.solver.act("sum_heat")
    s = simulation.state
    x, rate = s.numpy("position")[:, 0], s.numpy("heat_rate")
    away_from_the_ends = np.abs(x - 20 * SPACING) < 10 * SPACING
    assert np.max(np.abs(rate[away_from_the_ends])) < 1e-3 * 30.0 * slope * SPACING
    into_the_left_half = float(np.sum(rate[middle_rows(s) & (x < 20 * SPACING)]))
    assert into_the_left_half == pytest.approx(30.0 * slope * MIDDLE_HEIGHT, rel=1e-3)


def test_flux_is_continuous_at_a_jump_of_conductivity(device):
    """The arithmetic mean would let a bad conductor take what the good one offers."""
    poor = melting_material(
        "poor", density=7000.0, heat_capacity=700.0, latent_heat=270e3, solidus=1700.0, liquidus=1750.0,
        conductivity_solid=1.0, conductivity_liquid=1.0, viscosity=1.0, source="round numbers",
    )  # fmt: skip
    good = COPPER
    length = 40 * SPACING
    k_poor, k_good = 1.0, 350.0
    middle = 1000.0 - 100.0 * (0.5 / k_poor) / (0.5 / k_poor + 0.5 / k_good)

    def profile(x):
        s = x[:, 0] / length
        return np.where(s < 0.5, 1000.0 + (middle - 1000.0) * 2.0 * s, middle + (900.0 - middle) * (2.0 * s - 1.0))

    simulation = bar(device, profile, materials=(poor, good), split=True)
    simulation.prepare()
    simulation.solver.act("sum_heat")
    s = simulation.state
    x = s.numpy("position")[:, 0]
    through = (1000.0 - middle) / (0.5 * length) * k_poor * 12 * SPACING
    across = float(np.sum(s.numpy("heat_rate")[(x > 0.5 * length) & (x < length - 4 * SPACING)]))
    assert abs(across) < 0.1 * through


def test_no_heat_passes_a_film_without_conductance(device):
    """Water on copper would cool the mould from outside although the case says that it does not."""
    films = {(STEEL.name, COPPER.name): 0.0}
    halves = lambda x: np.where(x[:, 0] > 20 * SPACING, 400.0, 1400.0)  # noqa: E731
    result = bar(device, halves, materials=(STEEL, COPPER), split=True, films=films).run(30.0, 30.0)
    assert set(np.round(result.fields["temperature"], 2)) == {400.0, 1400.0}


def test_held_particles_account_for_their_heat(device):
    """Heat that the cooled wall swallows must stand in the ledger."""
    simulation = bar(device, lambda x: np.where(x[:, 0] < 3 * SPACING, 400.0, 1400.0), held=True)
    before = content(simulation)
    result = simulation.run(30.0, 30.0)
    taken = float(np.sum(result.fields["heat_held"]))
    assert taken + content(simulation) - before == pytest.approx(0.0, abs=1e-6 * before)
    assert abs(taken) > 1e-3 * before
    held = result.fields["held"] == 1
    assert set(np.round(result.fields["temperature"][held])) == {400.0, 1400.0}


def test_temperature_follows_the_curve_through_melting(device):
    """Latent heat that is skipped would double the speed of freezing."""
    simulation = bar(device, lambda x: np.full(len(x), 1600.0))
    enthalpy = np.linspace(STEEL.enthalpy(1500.0), STEEL.enthalpy(1900.0), simulation.state.count)
    simulation.state.enthalpy.assign(enthalpy.astype(np.float32))
    simulation.solver.act("find_temperature")
    expected = STEEL.temperature(enthalpy)
    assert np.allclose(simulation.state.numpy("temperature"), expected, atol=0.01)
    assert np.allclose(simulation.state.numpy("solid_fraction"), np.clip((1750.0 - expected) / 50.0, 0, 1), atol=1e-3)
