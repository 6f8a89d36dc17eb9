"""A strip that freezes from a cold wall, beside the solution of Stefan and Neumann."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import erf

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import melting_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, HeatWall, cut_cells

LENGTH, ROWS = 0.03, 30
WALL, SOLIDUS, LIQUIDUS = 900.0, 1000.0, 1001.0
MELT = melting_material(
    "melt", density=7000.0, heat_capacity=700.0, latent_heat=270e3, solidus=SOLIDUS, liquidus=LIQUIDUS,
    conductivity_solid=30.0, conductivity_liquid=30.0, viscosity=0.006, source="round numbers",
)  # fmt: skip


def front(time: float) -> float:
    """Thickness [m] frozen from melt at its melting point: 2 s sqrt(a t), s exp(s^2) erf(s) = St / sqrt(pi)."""
    stefan = 700.0 * (SOLIDUS - WALL) / 270e3
    depth = brentq(lambda s: s * np.exp(s**2) * erf(s) - stefan / np.sqrt(np.pi), 1e-3, 2.0)
    return float(2.0 * depth * np.sqrt(30.0 / (7000.0 * 700.0) * time))


def frozen(device: str, on_wall: bool) -> tuple[np.ndarray, np.ndarray]:
    """Thickness [m] that has frozen at some times [s], a row standing half a spacing before the wall or on it."""
    dx, breadth = LENGTH / ROWS, 4
    edge = breadth * dx
    walls = (
        HeatWall.at_temperature((1.0, 0.0, 0.0), 0.0, WALL),
        HeatWall.insulated((0.0, 1.0, 0.0), 0.0),
        HeatWall.insulated((0.0, -1.0, 0.0), -edge),
    )
    beyond = 0.5 * dx if on_wall else 0.0
    x = lattice((-beyond, 0.0), (LENGTH - beyond, edge), dx)
    cold = np.abs(x[:, 0]) < 1e-3 * dx
    particles = Particles()
    volume = cut_cells(x, walls, dx, 2)
    particles.add(x, Role.FREE, temperature=np.where(cold, WALL, LIQUIDUS), held=cold, volume=volume)

    def observe(state, time):
        return {"thickness": float(np.sum(state["solid_fraction"] * state["thermal_volume"])) / edge}

    model = Model(2, dx, (MELT,), (Conduction(longest_interval=1e9, walls=walls),), gravity=(0.0, 0.0, 0.0))
    simulation = Simulation(Executor(device), model, particles, observe=observe)
    result = simulation.run(90.0, 10.0)
    return result.diagnostics["time"], result.diagnostics["thickness"]


@pytest.mark.parametrize("on_wall", [False, True], ids=["before", "on"])
def test_a_strip_freezes_in_the_time_of_neumann(device, on_wall):
    """A wall that seems to stand elsewhere than it does, or takes too little, shifts every solidification time.

    With 30 rows 0.6 % was measured: the range of melting is 1 K of 100 K, and one row freezes after the other. With
    three rows held at the temperature of the wall behind it, and open edges, 6 % to 13 % were missing.
    """
    times, thickness = frozen(device, on_wall)
    error = np.array([thickness[k] / front(times[k]) - 1.0 for k in range(3, len(times))])
    assert thickness[-1] > 0.5 * LENGTH
    assert np.abs(error).max() < 0.01
