"""What particles start with: temperature, enthalpy and phase, and what is refused."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import melting_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, PhaseChange, WholePhases

MELTING, SPACING = 273.15, 0.01


def start(device="cpu", terms=(), solidus=MELTING, **given):
    water = melting_material(
        "water", density=1000.0, heat_capacity=2090.0, heat_capacity_liquid=4190.0, latent_heat=3.335e5,
        solidus=solidus, liquidus=MELTING, conductivity_solid=2.2, conductivity_liquid=0.591, viscosity=0.0, source="",
    )  # fmt: skip
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.04, 0.04), SPACING), Role.FREE, **given)
    model = Model(2, SPACING, (water,), (Conduction(longest_interval=1e9), *terms), gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor(device, 1), model, particles)
    simulation.prepare()
    return simulation.snapshot()


@pytest.mark.parametrize("terms", [(), (PhaseChange(),), (WholePhases(),)], ids=["curve", "switch", "whole"])
@pytest.mark.parametrize("number", [float, np.float32])
def test_the_phase_decides_at_the_melting_point(device, terms, number):
    """If it failed, ice at 0 degrees would start as water, without a word."""
    half = np.arange(16) < 8
    state = start(device, terms, temperature=number(MELTING), phase=np.where(half, Phase.SOLID, Phase.LIQUID))
    np.testing.assert_array_equal(state["solid_fraction"], np.where(half, 1.0, 0.0))
    assert state["temperature"] == pytest.approx(MELTING, abs=1e-4)
    latent = state["enthalpy"][~half].mean() - state["enthalpy"][half].mean()
    assert latent == pytest.approx(3.335e5, rel=1e-6)


def test_elsewhere_the_temperature_decides(device):
    """If it failed, a phase that contradicts the temperature would bring latent heat with it, or take it away."""
    for temperature, fraction in ((MELTING - 1.0, 1.0), (MELTING + 1.0, 0.0)):
        for phase in (Phase.SOLID, Phase.LIQUID):
            assert np.all(start(device, temperature=temperature, phase=phase)["solid_fraction"] == fraction)
    melting = start(device, solidus=MELTING - 2.0, temperature=MELTING - 1.0, phase=Phase.SOLID)
    assert melting["solid_fraction"] == pytest.approx(0.5)
    given = start(device, temperature=MELTING, phase=Phase.SOLID, enthalpy=2090.0 * MELTING + 0.25 * 3.335e5)
    assert given["solid_fraction"] == pytest.approx(0.75, abs=1e-6)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"temperature": -100.0}, "'temperature' was given -100 K: must not be below 0 K"),
        ({"enthalpy": -5.0}, "'enthalpy' = -5 J/kg: must not be below that of water at 0 K, 0 J/kg"),
    ],
)
def test_nothing_starts_below_zero(given, message):
    """If it failed, a sign or a scale that was forgotten would be simulated."""
    with pytest.raises(InputError, match=message):
        start(**given)
