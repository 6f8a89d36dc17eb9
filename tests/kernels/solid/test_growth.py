"""A strained solid on which melt freezes."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import fluid_material, solid_material, thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, PhaseChange, SummedDensity
from warpsph.terms.elasticity import FADING, LONGEST_FADE

SPACING, STEEL, ROWS = 0.01, thesis_steel(), 6


class Growing:
    """A solid block, deformed, beside a row of melt of no pressure that can be made to freeze or melt."""

    def __init__(self, device: str, dimension: int, F: np.ndarray, squeeze: float = 1.0, rows: int = ROWS):
        size = (rows * SPACING,) * dimension
        x = lattice((0.0,) * dimension, size, SPACING)
        cold = x[:, 0] < (rows - 1) * SPACING
        x *= squeeze
        particles = Particles()
        particles.add(x, Role.FREE, temperature=np.where(cold, STEEL.solidus - 100.0, STEEL.liquidus + 100.0))
        terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
        model = Model(dimension, SPACING, (STEEL,), terms, gravity=(0.0, 0.0, 0.0))
        self.simulation = Simulation(Executor(device), model, particles)
        self.simulation.prepare()
        self.state, self.act = self.simulation.state, self.simulation.solver.act
        self.solid = self.state.numpy("phase") == Phase.SOLID
        if squeeze == 1.0:
            self.state.pressure.zero_()
        self.move(F)

    def move(self, F: np.ndarray) -> None:
        self.state.position.assign((self.state.numpy("position").astype(float) @ F.T).astype(np.float32))

    def solidify(self, fraction: float | np.ndarray) -> None:
        self.state.solid_fraction.assign(np.where(self.solid, 1.0, fraction).astype(np.float32))
        self.act("change_phases")

    def force(self) -> np.ndarray:
        self.state.acceleration.zero_()
        for moment in ("sum_forces", "add_forces"):
            self.act(moment)
        return self.state.numpy("acceleration") * self.state.numpy("mass")[:, None]

    def strain(self) -> np.ndarray:
        """Of Green and Saint-Venant, that the stress is made of."""
        F = self.state.numpy("deformation") @ self.state.numpy("settled")
        return 0.5 * (np.swapaxes(F, 1, 2) @ F - np.eye(3))


def turned(angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


STRETCHED = np.diag([1.03, 1.0, 1.0]) + 0.02 * np.eye(3)[[1, 0, 2]] * [1.0, 1.0, 0.0]


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("angle", [0.0, 0.3, 1.57, 3.1])
def test_what_freezes_on_a_strained_solid_leaves_its_stress_alone(device, dimension, angle):
    """The bonds that come in would wipe out part of the strain, and the shell would jerk with every particle."""
    block = Growing(device, dimension, turned(angle) @ STRETCHED)
    block.force()
    strain = block.strain()[block.solid]
    assert np.abs(strain).max() > 0.02
    block.solidify(1.0)
    force = block.force()
    assert np.all(block.state.numpy("phase") == Phase.SOLID)
    assert np.allclose(block.strain()[block.solid], strain, atol=2e-5)
    assert np.allclose(block.strain()[~block.solid], 0.0, atol=2e-5)
    assert np.abs(np.sum(force, axis=0)).max() < 1e-4 * np.abs(force).sum()


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("angle", [0.0, 1.57])
def test_what_freezes_on_a_strained_solid_is_not_pushed_by_it(device, dimension, angle):
    """The stress of what it joins would act on it at once: a blow of 500 m/s^2 in a casting mould."""
    rows = 8
    block = Growing(device, dimension, np.eye(3), rows=rows)
    across = block.state.numpy("position")[:, 1:dimension] / SPACING - 0.5 * rows
    amid = np.all(np.abs(across) < 1.2, axis=1)  # out of reach of the corners, which are held badly
    block.move(turned(angle) @ STRETCHED)
    before = block.force()
    block.solidify(1.0)
    assert np.abs(block.force() - before)[amid].max() < 1e-3 * np.abs(before).max()


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("rows", [2, 3, ROWS])
def test_what_freezes_on_a_skin_under_little_strain_is_not_pushed_by_it(device, dimension, rows):
    """Corners and skins, which few bonds hold, would start at a decimetre a second in a casting mould."""
    block = Growing(device, dimension, np.eye(3) + 0.05 * (STRETCHED - np.eye(3)), rows=rows)
    before = block.force()
    block.solidify(1.0)
    assert np.abs(before).max() > 0.0
    assert np.abs(block.force() - before).max() < 1e-3 * np.abs(before).max()


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("rows", [2, 4])
@pytest.mark.parametrize("pressure", [0.005, 0.1])
def test_a_skin_that_freezes_piece_by_piece_under_a_deep_melt_bears_it(device, dimension, rows, pressure):
    """Corners and skins would be rid of the pressure as soon as it is more than what they may bear of a strain."""
    block = Growing(device, dimension, np.eye(3), rows=rows)
    block.state.pressure.fill_(pressure * 4e5)
    order = np.random.default_rng(1).random(len(block.solid))
    before = block.force()
    for part in (0.3, 0.6, 1.0):
        block.solidify(np.where(order < part, 1.0, 0.0))
        assert np.abs(block.force() - before).max() < 1e-4 * np.abs(before).max()


def test_what_bonds_bear_fades(device):
    """A shell that bore for good what it was frozen under could not be emptied of its melt."""
    block = Growing(device, 2, STRETCHED)
    block.solidify(1.0)
    solver, bonds = block.simulation.solver, block.state.bonds
    fading_time = Elasticity(4e5, 0.3).fading_time(block.simulation.model, 0)
    borne = [np.linalg.norm(bonds.borne.numpy(), axis=1)]
    for times in (0.5, 0.5, 20.0):
        solver.set_steps(1e-4, times * fading_time)
        block.act("change_phases")
        borne.append(np.linalg.norm(bonds.borne.numpy(), axis=1))
    assert np.max(borne[0]) > 0.01
    assert np.allclose(borne[2], np.exp(-1.0) * borne[0], rtol=1e-4, atol=2e-6 * np.max(borne[0]))
    assert np.all(borne[3] == 0.0)


def test_the_wave_in_what_moves_says_how_fast_it_fades():
    """Water or gas beside the machine, lighter than the steel, would make the shell forget its load in a jerk."""
    terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
    model = Model(2, SPACING, (STEEL, fluid_material("gas", 1.2), solid_material("wall", 8000.0)), terms)
    particles = Particles()
    for name, role, x in (("steel", Role.FREE, 0.0), ("gas", Role.DUMMY, 0.1), ("wall", Role.DUMMY, 0.2)):
        particles.add(np.array([[x, 0.0, 0.0]]), role, name, temperature=STEEL.liquidus + 100.0)
    simulation = Simulation(Executor("cpu"), model, particles)
    wave = Elasticity(4e5, 0.3).wave_speed(STEEL.density)
    assert simulation.model.the(Elasticity).constants(model, simulation.state)["fading_time"] == pytest.approx(
        FADING * SPACING / wave
    )


@pytest.mark.parametrize("youngs_modulus", [1e3, 4e5, 1e9, 1e12])
def test_what_bonds_bear_does_not_fade_in_one_step(youngs_modulus):
    """A stiff solid would be rid of all that it bears at the first step with heat, a millisecond after it froze."""
    terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(youngs_modulus, 0.3))
    model = Model(2, SPACING, (STEEL,), terms)
    particles = Particles()
    particles.add(np.zeros((1, 3)), Role.FREE, temperature=STEEL.liquidus + 100.0)
    simulation = Simulation(Executor("cpu"), model, particles)
    plan = simulation.plan
    fading_time = simulation.model.the(Elasticity).fading_time(model, 0)
    assert plan.heat_every * plan.longest <= LONGEST_FADE * fading_time * (1.0 + 1e-6)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("angle", [0.3, 1.57, 3.1])
def test_freezing_on_a_solid_that_has_only_turned_makes_no_force(device, dimension, angle):
    """Bonds that do not know of the turn would pull at those that do; a stretch by 3 % stands for comparison."""
    stretched = Growing(device, dimension, STRETCHED)
    stretched.solidify(1.0)
    block = Growing(device, dimension, turned(angle))
    block.solidify(1.0)
    assert np.abs(block.force()).max() < 1e-4 * np.abs(stretched.force()).max()


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("angle", [0.0, 0.3, 1.57, 2.5])
def test_freezing_under_pressure_makes_no_torque(device, dimension, angle):
    """A body that freezes as it turns would spin itself up."""
    block = Growing(device, dimension, turned(angle), squeeze=0.98)
    before = block.force()
    block.solidify(1.0)
    after = block.force()
    x = block.state.numpy("position").astype(float)
    torques = np.cross(x - x.mean(axis=0), after)
    assert np.abs(before).max() > 0.1
    assert np.abs(after - before).max() < 1e-3 * np.abs(before).max()
    assert np.abs(torques.sum(axis=0)).max() < 1e-4 * np.abs(torques).sum()


@pytest.mark.parametrize("dimension", [2, 3])
def test_freezing_and_melting_again_changes_nothing(device, dimension):
    """A solid that has grown and shrunk in between must feel the force it had."""
    block = Growing(device, dimension, STRETCHED)
    before = block.force()
    for _ in range(5):
        block.solidify(1.0)
        block.solidify(0.0)
    block.state.pressure.zero_()
    assert np.abs(block.force() - before).max() < 1e-3 * np.abs(before).max()


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_solid_that_has_grown_under_strain_turns_without_force(device, dimension):
    """What was settled at freezing must turn with the body, or a turned shell would feel a force that is not there."""
    block = Growing(device, dimension, STRETCHED)
    block.solidify(1.0)
    block.state.pressure.zero_()
    before = block.force()
    block.move(turned(1.0))
    assert np.allclose(block.force(), before @ turned(1.0).T, atol=2e-3 * np.abs(before).max())


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_solid_that_spins_keeps_its_angular_momentum(device, dimension):
    """The viscosity of the melt it was would stop it after a radian."""
    x = lattice((-4 * SPACING,) * dimension, (4 * SPACING,) * dimension, SPACING)
    x = x[np.linalg.norm(x, axis=1) < 4 * SPACING]
    particles = Particles()
    spin = 20.0 * np.cross([0.0, 0.0, 1.0], x)
    particles.add(x, Role.FREE, temperature=STEEL.solidus - 100.0, velocity=spin)
    terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3))
    simulation = Simulation(
        Executor(device), Model(dimension, SPACING, (STEEL,), terms, gravity=(0.0, 0.0, 0.0)), particles
    )

    def momentum() -> np.ndarray:
        s = simulation.snapshot()
        return np.sum(s["mass"][:, None] * np.cross(s["position"].astype(float), s["velocity"]), axis=0)

    before = momentum()
    simulation.run(0.1, 0.1)
    assert np.allclose(momentum(), before, atol=1e-3 * before[2])
