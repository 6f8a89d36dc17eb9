"""The alloy: what freezes, where the ice goes, and how a mixture of ice and liquid conducts."""

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import DivergenceError, InputError
from warpsph.kernels.basics.host import on_host
from warpsph.kernels.heat.freezing import cooling
from warpsph.run.simulation import Simulation
from warpsph.terms import Alloy, Conduction, HeatWall, Liquidus, PhaseChange, Solute

L, C_ICE, C_LIQUID, GAMMA, C_0 = 334.4e3, 2006.0, 4180.0, 42.28, 0.14
RHO, RHO_ICE, K, K_ICE = 1097.0, 917.0, 0.498, 2.408
STRAIGHT = Liquidus.straight(273.15, GAMMA, 253.15)
BENT = Liquidus((0.0, 0.1, 0.2, 0.4), (273.15, 270.0, 265.0, 250.0))
ICE = solid_material("ice", RHO_ICE, conductivity=K_ICE, heat_capacity=C_ICE)
SOLUTION = fluid_material("solution", RHO, conductivity=K, heat_capacity=C_LIQUID)
SPACING = 0.01


def box(dimension, cells=(8, 4, 4), cold=None):
    """Walls around a block of cells, the one below of given temperature."""
    walls = []
    for axis in range(dimension):
        normal, size = np.eye(3)[axis], SPACING * cells[axis]
        walls += [HeatWall.insulated(normal, 0.0), HeatWall.insulated(-normal, -size)]
    if cold is not None:
        walls[0] = HeatWall.at_temperature((1.0, 0.0, 0.0), 0.0, cold)
    return tuple(walls)


def simulation(device, dimension=2, cells=(8, 4, 4), ice=ICE, liquidus=STRAIGHT, walls=None, support=2.6, **given):
    points = lattice(np.zeros(dimension), SPACING * np.array(cells[:dimension]), SPACING)
    shown = {name: value(points) if callable(value) else value for name, value in given.items() if name != "literal"}
    particles = Particles()
    particles.add(points, Role.FREE, **({"solute": C_0} | shown))
    walls = box(dimension, cells) if walls is None else walls
    alloy = Alloy(ice, L, liquidus, walls, literal=given.get("literal", False))
    model = Model(dimension, SPACING, (SOLUTION,), (Solute(0.0, walls), alloy), support, gravity=(0.0, 0.0, 0.0))
    return Simulation(Executor(device, 2), model, particles)


def heat(state):
    """Heat (without that of freezing) of liquid and ice."""
    return np.sum(state["liquid_heat"] + state["ice_heat"] - state["heat_freed"])


@pytest.mark.parametrize("q", [1.0, 1e2, 1e4, 1e5, 2e5])
@pytest.mark.parametrize("C", [0.02, 0.14, 0.3])
def test_the_root_is_what_the_published_iteration_goes_to(q, C):
    """If it failed, another amount of ice would form than equations (4.4) and (4.9) say."""
    x, ice = 0.0, 0.0
    for _ in range(100):
        # (4.10) with its brackets put right: (1 - ice) / (Gamma C) multiplies all that ice is worth
        x = q / ((L + (C_ICE - C_LIQUID) * x) * (1.0 - ice) / (GAMMA * C) + C_LIQUID)
        before, ice = ice, x / (GAMMA * C + x)
        if abs(ice - before) < 1e-3 * 0.5 * (ice + before):
            break
    found = float(on_host(cooling)(q, GAMMA * C, L, C_LIQUID, C_ICE))
    share = found / (GAMMA * C + found)
    assert share == pytest.approx(ice, rel=2e-3)
    assert share * L + share * C_ICE * found + (1.0 - share) * C_LIQUID * found == pytest.approx(q, rel=1e-12)
    assert found == pytest.approx(0.1694, abs=1e-4) or (q, C) != (1e4, 0.14)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("liquidus", [STRAIGHT, BENT], ids=["straight", "bent"])
@pytest.mark.parametrize("walled", [True, False])
def test_what_is_undercooled_freezes_back_to_its_liquidus(device, dimension, liquidus, walled):
    """If it failed, mass, salt or heat would be lost on the way to the ice, or liquid would stay undercooled."""
    start = 273.15 - 12.0
    sim = simulation(
        device,
        dimension,
        liquidus=liquidus,
        walls=None if walled else (),
        temperature=lambda x: np.where(x[:, 0] < 0.04, start, 285.0),
        ice_temperature=start,
    )
    before = sim.snapshot()
    sim.solver.prepare()
    sim.solver.act("after_heat")
    sim.solver.act("find_temperature")
    after = sim.snapshot()
    cold = after["position"][:, 0] < 0.04
    T, C = after["temperature"][cold].astype(float), after["solute"][cold].astype(float)
    np.testing.assert_allclose(T, liquidus.temperature(C), atol=2e-3)
    assert np.all(C > C_0 + 1e-3)
    np.testing.assert_array_equal(after["liquid_mass"][~cold], before["liquid_mass"][~cold])
    total = after["liquid_mass"].sum() + after["ice_mass"].sum()
    assert total == pytest.approx(before["liquid_mass"].sum(), rel=1e-12)
    assert heat(after) == pytest.approx(heat(before), abs=1e-10 * np.abs(before["liquid_heat"]).sum())
    assert after["ice_mass"][~cold].max() > 0.0  # the smoothing kernel carries ice over the edge
    np.testing.assert_allclose(after["ice_temperature"][after["ice_mass"] > 0.0], T[0], atol=1e-4)


@pytest.mark.parametrize("liquidus", [STRAIGHT, BENT], ids=["straight", "bent"])
@pytest.mark.parametrize("C", [0.0999999999999999, 0.1, C_0])
def test_liquid_that_is_a_rounding_below_its_liquidus_freezes_a_rounding(device, liquidus, C):
    """If it failed, a mush in equilibrium would become a place of numbers that are none."""
    sim = simulation(device, liquidus=liquidus, solute=C, temperature=float(liquidus.temperature(C)))
    sim.solver.prepare()
    start = sim.snapshot()
    lost = np.geomspace(1e-16, 1e-4, sim.state.count) * np.abs(start["liquid_heat"])
    sim.state.liquid_heat.assign((start["liquid_heat"] - lost)[sim.state.numpy("id")])
    before = sim.snapshot()
    sim.solver.act("after_heat")
    sim.solver.act("find_temperature")
    after = sim.snapshot()
    assert np.all(np.isfinite(after["liquid_heat"]))
    assert np.all(after["ice_mass"] >= 0.0)
    assert heat(after) == pytest.approx(heat(before), abs=1e-13 * np.abs(before["liquid_heat"]).sum())
    frozen = (before["liquid_mass"] - after["liquid_mass"])[-1] / before["liquid_mass"][0]
    G = (liquidus.temperature(C) - liquidus.temperature(C + 1e-6)) / 1e-6
    expected = lost[-1] / before["liquid_mass"][0] / (L + G * C * C_LIQUID)  # a step so small that all is linear
    assert frozen == pytest.approx(expected, rel=1e-3)


def test_fractions_of_even_ice(device):
    """If it failed, walls would take ice away from the sums of volume fractions, or liquid would not fill the rest."""
    share = 0.3
    volume = SPACING**2
    sim = simulation(
        device, ice_mass=share * RHO_ICE * volume, liquid_mass=(1.0 - share) * RHO * volume, temperature=280.0
    )
    sim.solver.prepare()
    state = sim.snapshot()
    np.testing.assert_allclose(state["solid_fraction"], share, rtol=1e-5)
    np.testing.assert_allclose(state["liquid_fraction"], 1.0 - share, rtol=1e-5)
    np.testing.assert_allclose(state["ice_volume"] + state["liquid_volume"], volume, rtol=1e-6)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.76])
@pytest.mark.parametrize("dimension", [2, 3])
def test_a_mixture_conducts_side_by_side(device, dimension, share):
    """If it failed, ice and liquid of the mush would conduct more than beside each other, as (4.2) does as printed."""
    volume, slope = SPACING**dimension, 100.0
    found = {}
    for literal in (False, True):
        sim = simulation(
            device,
            dimension,
            (12, 6, 6),
            literal=literal,
            ice_mass=share * RHO_ICE * volume,
            liquid_mass=(1.0 - share) * RHO * volume,
            temperature=lambda x: 300.0 + slope * x[:, 0] ** 2,
        )
        sim.solver.prepare()
        sim.solver.act("sum_heat")
        rate = sim.state.numpy("liquid_rate") + sim.state.numpy("ice_rate")
        x = sim.state.numpy("position")[:, 0]
        inner = (x > 0.05) & (x < 0.07)
        found[literal] = rate[inner].mean() / (2.0 * slope * volume)
    beside = share * K_ICE + (1.0 - share) * K
    assert found[False] == pytest.approx(beside, rel=2e-3)
    k_i, k_l = share * K_ICE, (1.0 - share) * K
    assert found[True] == pytest.approx(k_i + k_l + 4.0 * k_i * k_l / (k_i + k_l), rel=2e-3)


@pytest.mark.parametrize("literal", [False, True])
@pytest.mark.parametrize("dimension", [2, 3])
def test_walls_take_what_the_body_loses(device, dimension, literal):
    """If it failed, heat would be made or lost at walls, in corners, or on the way from ice to liquid."""
    sim = simulation(device, dimension, literal=literal, walls=box(dimension, cold=258.0), temperature=275.0)
    before = heat(sim.snapshot())
    result = sim.run(3000.0, 1000.0)
    taken = sim.model.find(Alloy).heat_to_walls()
    assert taken[0] > 0.0
    assert np.all(taken[1:] == 0.0)
    assert heat(sim.snapshot()) - before == pytest.approx(-taken[0], rel=1e-6)
    assert np.ptp(result.fields["temperature"].reshape(8, -1), axis=1).max() < 1e-3  # walls at the sides are mirrors


@pytest.mark.parametrize("literal", [False, True])
@pytest.mark.parametrize("support", [2.0, 2.6, 3.0])
def test_the_longest_step_is_stable(device, literal, support):
    """If it failed, some mixture, such as ice nearly without mass, would swing beyond its surroundings."""
    generator = np.random.default_rng(3)
    volume, share = SPACING**2, np.array([0.0, 1e-6, 1e-3, 0.1, 0.4, 0.76])
    for theta in share:
        start = generator.uniform(280.0, 290.0, (2, 64))
        sim = simulation(
            device,
            cells=(8, 8),
            support=support,
            literal=literal,
            walls=box(2, (8, 8), cold=285.0),
            temperature=start[0],
            ice_temperature=start[1],
            ice_mass=theta * RHO_ICE * volume,
            liquid_mass=(1.0 - theta) * RHO * volume,
        )
        longest = sim.plan.longest
        for _ in range(3):
            fields = sim.run(10.0 * longest, 10.0 * longest).fields
            for name in ("temperature", "ice_temperature"):
                assert fields[name].min() >= 280.0 - 1e-3
                assert fields[name].max() <= 290.0 + 1e-3


def test_equal_phases_freeze_as_one_substance(device):
    """If it failed, ice in liquid of the same conductivity would change how fast heat passes."""
    same = solid_material("ice", RHO, conductivity=K, heat_capacity=C_LIQUID)
    warm = {"temperature": lambda x: 290.0 + 10.0 * np.cos(np.pi * x[:, 0] / 0.08)}
    volume = SPACING**2
    plain = simulation(device, ice=same, **warm).run(2000.0, 2000.0).fields["temperature"]
    mixed = simulation(device, ice=same, ice_mass=0.5 * RHO * volume, liquid_mass=0.5 * RHO * volume, **warm)
    mixed = mixed.run(2000.0, 2000.0).fields
    np.testing.assert_allclose(mixed["temperature"], plain, atol=1e-3)
    np.testing.assert_allclose(mixed["ice_temperature"], plain, atol=1e-3)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"latent_heat": 0.0}, "latent_heat = 0.0: must be positive"),
        ({"ice": "ice"}, "ice = 'ice': must be a Material"),
        ({"liquidus": None}, "liquidus = None: must be a Liquidus"),
        ({"walls": (HeatWall.film((1.0, 0.0, 0.0), 0.0, 10.0, 260.0),)}, "films, fluxes and profiles are left out"),
        ({"walls": (HeatWall.at_temperature((1.0, 0.0, 0.0), 0.0, 250.0),)}, "solid that forms at the eutectic"),
    ],
)
def test_wrong_input(wrong, message):
    """If it failed, a run would go where the model does not."""
    given = {"ice": ICE, "latent_heat": L, "liquidus": STRAIGHT} | wrong
    with pytest.raises(InputError, match=message):
        Alloy(**given)


def test_wrong_liquidus_and_model():
    """If it failed, a curve that rises, or a capacity that changes, would freeze something else than was meant."""
    for curve in (
        ((0.0, 0.1), (270.0, 271.0)),
        ((0.1, 0.2), (270.0, 260.0)),
        ((0.0,), (270.0,)),
        ((0.0, 0.1), (270.0,)),
        (0.1, (270.0, 260.0)),
        ((0.0, 0.1), None),
        ("abc", (270.0, 260.0)),
    ):
        with pytest.raises(InputError, match="strictly"):
            Liquidus(*curve)
    changing = replace(ICE, temperatures=(0.0, 200.0, 300.0), enthalpies=(0.0, 1e5, 3e5))
    with pytest.raises(InputError, match="heat capacity of ice changes"):
        simulation("cpu", ice=changing)
    model = Model(2, SPACING, (SOLUTION, ICE), (Solute(), Alloy(ICE, L, STRAIGHT)), gravity=(0.0, 0.0, 0.0))
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE, "solution")
    with pytest.raises(InputError, match="2 materials; it needs a model of one"):
        Simulation(Executor("cpu"), model, particles)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ((273.15, 0.0, 255.0), "slope = 0.0: must be more than pure - lowest"),
        ((273.15, -42.0, 255.0), "slope = -42.0: must be more than pure - lowest"),
        ((273.15, 10.0, 255.0), "slope = 10.0: must be more than pure - lowest"),
        ((273.15, "a", 255.0), "slope = 'a': must be"),
        (("a", 42.0, 255.0), "pure = 'a': must be a temperature"),
        ((np.nan, 42.0, 255.0), "pure = nan: must be a temperature"),
        ((273.15, 42.0, 280.0), "lowest = 280.0: must be a temperature .K. below that of the pure solvent"),
        ((273.15, 42.0, None), "lowest = None: must be a temperature"),
    ],
)
def test_a_straight_liquidus_names_its_own_arguments(given, message):
    """If it failed, somebody would be told of nodes that he has not given, or of a division by zero."""
    with pytest.raises(InputError, match=f"Liquidus.straight: {message}") as caught:
        Liquidus.straight(*given)
    assert "\n" not in str(caught.value)


def test_one_or_the_other_conducts():
    """If it failed, heat would be conducted twice, or a part would look for an enthalpy that an alloy does not have."""
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE, "solution")
    for further, message in (
        (Conduction(), "Alloy and Conduction exclude each other: both provide temperature"),
        (PhaseChange(), "PhaseChange needs conduction in the same case: add Conduction"),
    ):
        terms = (Solute(), Alloy(ICE, L, STRAIGHT), further)
        with pytest.raises(InputError, match=message):
            Simulation(Executor("cpu"), Model(2, SPACING, (SOLUTION,), terms), particles)


def test_a_broken_run_is_noticed(device):
    """If it failed, a run that has blown up would go on writing frames of nothing."""
    sim = simulation(device, temperature=275.0)
    values = sim.state.numpy("liquid_heat")
    values[3] = np.nan
    sim.state.liquid_heat.assign(wp.array(values, dtype=wp.float64, device=sim.state.device))
    with pytest.raises(DivergenceError, match="the heat is not a number"):
        sim.solver.check()
