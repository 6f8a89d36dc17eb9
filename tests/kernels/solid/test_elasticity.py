"""Elastic forces of bonded particles: rotation, energy, momentum, Hooke's law."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles
from warpsph.core.term import Term
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, PhaseChange, SummedDensity

SPACING = 0.01
E = 1.0e6


def disc(dimension: int, radius: float = 0.055) -> np.ndarray:
    axis = np.arange(-8, 9) * SPACING
    x = np.stack(np.meshgrid(axis, axis, axis if dimension == 3 else [0.0], indexing="ij"), -1).reshape(-1, 3)
    return x[np.linalg.norm(x, axis=1) < radius] + np.array([0.3, -0.2, 0.0])


def freezing() -> tuple[Term, ...]:
    """A fluid that turns solid at once, because such a material is solid at any temperature."""
    return Fluid(1000.0, 50.0), SummedDensity(), Conduction(), PhaseChange()


class Body:
    """A solid body whose particles are bonded as they stand; gives the elastic force in other positions."""

    def __init__(self, device: str, dimension: int, corrected: bool = True, hourglass: float = 0.0, guest=None):
        particles = Particles()
        particles.add(disc(dimension), Role.FREE, phase=Phase.SOLID)
        if guest is not None:
            particles.add(np.array([guest]), Role.FREE, phase=Phase.SOLID)
        model = Model(
            dimension,
            SPACING,
            (solid_material("rubber", 1000.0),),
            (*freezing(), Elasticity(E, 0.3, corrected, hourglass)),
            gravity=(0.0, 0.0, 0.0),
        )
        self.simulation = Simulation(Executor(device), model, particles)
        self.state, self.solver = self.simulation.state, self.simulation.solver
        self.simulation.prepare()
        self.rest = self.state.numpy("position").astype(float)
        self.mass = self.state.numpy("mass").astype(float)

    def force(self, x: np.ndarray) -> np.ndarray:
        self.state.position.assign(x.astype(np.float32))
        self.state.acceleration.zero_()
        for moment in ("sum_forces", "add_forces"):
            ((elasticity, launch),) = [act for act in self.solver._acts[moment] if isinstance(act[0], Elasticity)]
            getattr(elasticity, moment)(launch)
        return self.state.numpy("acceleration").astype(float) * self.mass[:, None]

    def energy(self, x: np.ndarray) -> float:
        """Strain energy in double precision from the bonds as the device has them (Vijaykumar 4.12)."""
        bonds, model = self.state.bonds, self.simulation.model
        lame_lambda, lame_mu = model.the(Elasticity).lame
        scale = normalisation("sine", model.dimension, model.support)
        count = bonds.count.numpy()
        partner = bonds.partner.numpy().reshape(len(count), -1)
        separation = bonds.separation.numpy().reshape(len(count), bonds.capacity, 3).astype(float)
        volume = self.state.numpy("body_volume").astype(float)
        correction = self.state.numpy("correction").astype(float)
        total = 0.0
        for i in range(len(count)):
            j, X = partner[i, : count[i]], separation[i, : count[i]]
            r = np.linalg.norm(X, axis=1)
            slope = -scale * np.cos(0.5 * np.pi * r / model.support) / r
            u = x[j] - x[i] + X
            gradient = np.einsum("k,ka,kb->ab", volume[j] * slope, u, X) @ correction[i]
            F = np.eye(3) + gradient
            strain = 0.5 * (F.T @ F - np.eye(3))
            sigma = 2.0 * lame_mu * strain + lame_lambda * np.trace(strain) * np.eye(3)
            total += 0.5 * volume[i] * np.sum(strain * sigma)
        return total


def turned(x: np.ndarray, angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    centre = x.mean(axis=0)
    return (x - centre) @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) + centre


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("hourglass", [0.0, 0.1])
def test_a_turned_body_feels_no_force(device, dimension, hourglass):
    """A force under rotation would hold a turning shell back or tear it."""
    body = Body(device, dimension, hourglass=hourglass)
    force = body.force(turned(body.rest, 0.5 * np.pi))
    area_over_length = SPACING ** (dimension - 1)
    assert np.max(np.abs(force)) < 1e-4 * E * area_over_length


def test_the_published_form_does_feel_rotation(device):
    """If it did not, the correction would be useless and this test suite could not see it."""
    body = Body(device, 2, corrected=False)
    assert np.max(np.abs(body.force(turned(body.rest, 0.3)))) > 1e-3 * E * SPACING


@pytest.mark.parametrize("corrected", [True, False])
@pytest.mark.parametrize("dimension", [2, 3])
def test_force_is_minus_the_gradient_of_the_strain_energy(device, dimension, corrected):
    """Forces without an energy would heat or cool a vibrating shell for ever."""
    body = Body(device, dimension, corrected)
    generator = np.random.default_rng(3)
    noise = generator.normal(0.0, 0.03 * SPACING, body.rest.shape)
    noise[:, dimension:] = 0.0
    x = turned(body.rest, 0.2) * [1.05, 0.97, 1.0] + noise
    force = body.force(x)
    step = 1e-6 * SPACING
    for i in generator.choice(len(x), 4, replace=False):
        for axis in range(dimension):
            shift = np.zeros_like(x)
            shift[i, axis] = step
            slope = (body.energy(x + shift) - body.energy(x - shift)) / (2.0 * step)
            assert force[i, axis] == pytest.approx(-slope, abs=2e-3 * np.max(np.abs(force)))


@pytest.mark.parametrize("hourglass", [0.0, 0.1])
def test_momentum_is_kept(device, hourglass):
    """Forces of a bond that do not cancel would move the strand by themselves."""
    body = Body(device, 2, hourglass=hourglass)
    noise = np.random.default_rng(5).normal(0.0, 0.05 * SPACING, body.rest.shape) * [1, 1, 0]
    force = body.force(body.rest + noise)
    assert np.max(np.abs(force.sum(axis=0))) < 1e-5 * np.sum(np.abs(force))


def test_stress_is_hookes_law_in_plane_strain(device):
    """A wrong constant would give the shell another stiffness than asked for."""
    body = Body(device, 2)
    strain = 1e-3
    body.force((body.rest - body.rest.mean(0)) * [1.0 + strain, 1.0, 1.0] + body.rest.mean(0))
    middle = np.argmin(np.linalg.norm(body.rest - body.rest.mean(0), axis=1))
    stress = body.state.numpy("stress")[middle] @ np.linalg.inv(body.state.numpy("correction")[middle])
    stretch = E * 0.7 / (1.3 * 0.4) * strain
    assert stress[0, 0] == pytest.approx(stretch, rel=1e-2)
    assert stress[1, 1] == pytest.approx(stretch * 0.3 / 0.7, rel=1e-2)


def test_hourglass_control_resists_a_checkerboard(device):
    """Without it a checkerboard displacement costs no energy and grows."""
    free, held = (Body(device, 2, hourglass=strength) for strength in (0.0, 0.5))
    sign = np.where(np.sum(np.round(free.rest / SPACING), axis=1) % 2 == 0, 1.0, -1.0)
    x = free.rest + 0.05 * SPACING * sign[:, None] * [1.0, 0.0, 0.0]
    inner = np.linalg.norm(free.rest - free.rest.mean(0), axis=1) < 0.025
    restoring = [np.mean((-body.force(x)[:, 0] * sign)[inner]) for body in (free, held)]
    assert restoring[1] > 3.0 * abs(restoring[0])
    assert np.all(free.state.numpy("phase") == Phase.SOLID)


def test_bonds_are_mutual(device):
    """A bond that only one end knows would break the third law."""
    body = Body(device, 3)
    count = body.state.bonds.count.numpy()
    partner = body.state.bonds.partner.numpy().reshape(len(count), -1)
    bonds = {(i, int(j)) for i in range(len(count)) for j in partner[i, : count[i]]}
    assert bonds == {(j, i) for i, j in bonds}
    assert len(bonds) > 20 * len(count)


def test_particles_that_froze_on_top_of_each_other_stay_calm(device):
    """Without a bound on the stiffness of such a bond it tears the body apart at any time step."""
    body = Body(device, 2, hourglass=0.1, guest=[0.3 + 0.003 * SPACING, -0.2 + 0.009 * SPACING, 0.0])
    simulation, solver = body.simulation, body.solver
    solver.set_steps(simulation.plan.longest, simulation.plan.longest)
    velocity = np.random.default_rng(4).normal(0.0, 1e-3, body.rest.shape) * [1, 1, 0]
    simulation.state.velocity.assign(velocity.astype(np.float32))
    for _ in range(300):
        solver.step()
    assert np.max(np.abs(simulation.state.numpy("velocity"))) < 0.1


def test_a_body_that_starts_solid_needs_no_melt(device):
    """A body must fall as one piece, with the volume of its particles, where there is neither fluid nor heat."""
    particles = Particles()
    particles.add(disc(2), Role.FREE, phase=Phase.SOLID)
    model = Model(2, SPACING, (solid_material("rubber", 1000.0),), (Elasticity(E, 0.3),))
    simulation = Simulation(Executor(device), model, particles)
    start = simulation.snapshot()["position"]
    result = simulation.run(0.05, 0.05)
    assert np.allclose(result.fields["body_volume"], SPACING**2)
    assert simulation.state.bonds.count.numpy().min() > 4
    assert np.allclose(result.fields["velocity"], [0.0, -9.81 * 0.05, 0.0], atol=1e-3)
    assert np.allclose(result.positions - start, [0.0, -0.5 * 9.81 * 0.05**2, 0.0], atol=2e-4)


def test_a_solid_start_with_phase_change_is_bonded_once(device):
    """A body that starts solid must not lose its bonds when the phases are looked at for the first time."""
    particles = Particles()
    particles.add(disc(2), Role.FREE, phase=Phase.SOLID)
    elasticity = Elasticity(E, 0.3)
    model = Model(2, SPACING, (solid_material("rubber", 1000.0),), (*freezing(), elasticity))
    simulation = Simulation(Executor(device), model, particles)
    simulation.prepare()
    assert simulation.state.bonds.count.numpy().min() > 4
    assert elasticity.bond_events.numpy()[0] == 1
    assert np.allclose(simulation.state.numpy("body_volume"), simulation.state.numpy("mass") / 1000.0)
