"""A pure substance: latent heat at one temperature, by the enthalpy curve and by whole phases."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import melting_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, HeatSources, PhaseChange, PointSource, WholePhases

MELTING, LATENT = 273.15, 3.335e5
CAPACITY, CONDUCTIVITY = {"solid": 2090.0, "liquid": 4190.0}, {"solid": 2.2, "liquid": 0.591}
WATER = melting_material(
    "water", density=1000.0, heat_capacity=CAPACITY["solid"], heat_capacity_liquid=CAPACITY["liquid"],
    latent_heat=LATENT, solidus=MELTING, liquidus=MELTING, conductivity_solid=CONDUCTIVITY["solid"],
    conductivity_liquid=CONDUCTIVITY["liquid"], viscosity=0.0, source="round numbers",
)  # fmt: skip
SPACING, SINK = 0.02, PointSource((0.08, 0.1, 0.0), -150.0)


def pool(device: str, *terms, start: float = MELTING + 2.0, source: PointSource = SINK) -> Simulation:
    particles = Particles()
    x = lattice((0.0, 0.0), (0.24, 0.2), SPACING)
    particles.add(x, Role.FREE, temperature=start)
    conduction = Conduction(longest_interval=1e9, smoothing="cubic_spline", support_ratio=2.6, exact_on_lattice=False)
    model = Model(2, SPACING, (WATER,), (conduction, HeatSources((source,)), *terms), gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device), model, particles)


def stored(steps: int, dt: float) -> dict[str, np.ndarray]:
    """The bookkeeping of the paper as it is told: temperature, heat stored at the melting point, tag of the phase.

    All pairs, double precision, and no enthalpy anywhere.
    """
    x, h = lattice((0.0, 0.0), (0.24, 0.2), SPACING), 1.3 * SPACING
    V = SPACING**2
    mass = 1000.0 * V

    def spline(d):
        q = np.linalg.norm(d, axis=-1) / h
        W = np.where(q < 1.0, 1.0 - 1.5 * q**2 + 0.75 * q**3, 0.25 * np.maximum(2.0 - q, 0.0) ** 3)
        F = np.where(q < 1.0, -3.0 + 2.25 * q, -0.75 * np.maximum(2.0 - q, 0.0) ** 2 / np.maximum(q, 1e-9))
        return 10.0 / (7.0 * np.pi * h**2) * W, 10.0 / (7.0 * np.pi * h**4) * F

    F = spline(x[:, None] - x[None, :])[1]
    W = spline(x - np.asarray(SINK.position))[0]
    T, heat_lost, is_ice = np.full(len(x), MELTING + 2.0), np.zeros(len(x)), np.zeros(len(x), bool)
    for _ in range(steps):
        k = np.where(is_ice, CONDUCTIVITY["solid"], CONDUCTIVITY["liquid"])
        pair = 4.0 * k[:, None] * k[None, :] / (k[:, None] + k[None, :])
        rate = V**2 * np.sum(pair * (T[:, None] - T[None, :]) * F, axis=1) + SINK.strength * W / W.sum()
        lost = -rate * dt / mass
        for i in range(len(x)):
            if is_ice[i]:
                T[i] -= lost[i] / CAPACITY["solid"]
                continue
            spare = max(CAPACITY["liquid"] * (T[i] - MELTING), 0.0)
            T[i] -= min(lost[i], spare) / CAPACITY["liquid"]
            heat_lost[i] += max(lost[i] - spare, 0.0)
            if heat_lost[i] >= LATENT:
                is_ice[i] = True
                T[i] = MELTING - (heat_lost[i] - LATENT) / CAPACITY["solid"]
    return {"temperature": T, "solid_fraction": np.minimum(heat_lost / LATENT, 1.0), "is_ice": is_ice}


def test_whole_phases_do_what_the_paper_tells(device):
    """Otherwise the freezing by enthalpies would be another method than the published one, not its equal."""
    simulation = pool(device, WholePhases())
    dt, steps = simulation.plan.longest, 900
    told = stored(steps, dt)
    result = simulation.run(steps * dt, steps * dt)
    assert result.steps == steps
    assert told["is_ice"].sum() > 15
    assert np.sum((told["solid_fraction"] > 0.0) & ~told["is_ice"]) > 5
    assert np.array_equal(result.fields["phase"] == Phase.SOLID, told["is_ice"])
    assert result.fields["temperature"] == pytest.approx(told["temperature"], abs=5e-3)
    assert result.fields["solid_fraction"] == pytest.approx(told["solid_fraction"], abs=1e-3)
    conductivity = np.where(told["is_ice"], CONDUCTIVITY["solid"], CONDUCTIVITY["liquid"])
    assert result.fields["conductivity"] == pytest.approx(conductivity)


@pytest.mark.parametrize("terms", [(), (PhaseChange(),), (WholePhases(),)], ids=["curve", "switch", "whole"])
def test_the_heat_of_both_ways_is_the_same(device, terms):
    """A way that lost latent heat would freeze too fast."""
    simulation = pool(device, *terms)
    mass = 1000.0 * SPACING**2
    before = float(np.sum(simulation.snapshot()["enthalpy"].astype(float)))
    result = simulation.run(2e5, 2e5)
    lost = mass * (before - float(np.sum(result.fields["enthalpy"].astype(float))))
    assert lost == pytest.approx(150.0 * 2e5, rel=1e-5)
    frozen = result.fields["solid_fraction"] >= 1.0
    melting = ~frozen & (result.fields["solid_fraction"] > 0.0)
    assert frozen.sum() > 100
    assert np.all(result.fields["temperature"][frozen] <= MELTING)
    assert result.fields["temperature"][melting] == pytest.approx(np.full(melting.sum(), MELTING), abs=1e-4)


def test_the_solid_fraction_follows_the_enthalpy(device):
    """At one temperature there is everything from ice to water; a fraction by temperature would know two of them."""
    simulation = pool(device)
    frozen, molten = WATER.melting_enthalpies
    n = simulation.state.count
    share = np.linspace(-0.2, 1.2, n)
    simulation.state.enthalpy.assign((molten + share * (frozen - molten)).astype(np.float32))
    simulation.solver.act("find_temperature")
    assert simulation.state.numpy("solid_fraction") == pytest.approx(np.clip(share, 0.0, 1.0), abs=1e-6)
    within = (share > 0.0) & (share < 1.0)
    assert simulation.state.numpy("temperature")[within] == pytest.approx(np.full(within.sum(), MELTING), abs=1e-4)
    k = CONDUCTIVITY["liquid"] + np.clip(share, 0.0, 1.0) * (CONDUCTIVITY["solid"] - CONDUCTIVITY["liquid"])
    assert simulation.state.numpy("conductivity") == pytest.approx(k, rel=1e-5)


def test_ice_melts_when_all_its_heat_is_back(device):
    """Ice that turned to water at the first warmth would conduct like water too early."""
    simulation = pool(device, WholePhases())
    frozen, molten = WATER.melting_enthalpies
    seen = []
    for share in (0.0, 0.5, 1.0, 0.5, 0.01, 0.0, 0.5):
        simulation.state.enthalpy.fill_(molten + share * (frozen - molten))
        simulation.solver.act("find_temperature")
        simulation.solver.act("change_phases")
        seen.append(Phase(int(simulation.state.numpy("phase")[0])))
    L, M, S = Phase.LIQUID, Phase.MUSHY, Phase.SOLID
    assert seen == [L, M, S, S, S, L, M]
