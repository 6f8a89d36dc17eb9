"""A strained solid on which melt freezes."""

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Phase, Role
from warpsph.core.materials import thesis_steel
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction, Elasticity, Fluid, PhaseChange, SummedDensity

SPACING, STEEL, ROWS = 0.01, thesis_steel(), 6


class Growing:
    """A solid block, deformed, beside a row of melt of no pressure that can be made to freeze or melt."""

    def __init__(self, device: str, dimension: int, F: np.ndarray):
        size = (ROWS * SPACING,) * dimension
        x = lattice((0.0,) * dimension, size, SPACING)
        cold = x[:, 0] < (ROWS - 1) * SPACING
        particles = Particles()
        particles.add(x, Role.FREE, temperature=np.where(cold, STEEL.solidus - 100.0, STEEL.liquidus + 100.0))
        terms = (Fluid(2100.0, 10.0), SummedDensity(), Conduction(), PhaseChange(), Elasticity(4e5, 0.3, hourglass=0.0))
        model = Model(dimension, SPACING, (STEEL,), terms, gravity=(0.0, 0.0, 0.0))
        self.simulation = Simulation(Executor(device), model, particles)
        self.simulation.prepare()
        self.state, self.act = self.simulation.state, self.simulation.solver.act
        self.solid = self.state.numpy("phase") == Phase.SOLID
        self.state.pressure.zero_()
        self.move(F)

    def move(self, F: np.ndarray) -> None:
        self.state.position.assign((self.state.numpy("position").astype(float) @ F.T).astype(np.float32))

    def solidify(self, fraction: float) -> None:
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
@pytest.mark.parametrize("angle", [0.0, 1.0])
def test_what_freezes_on_a_strained_solid_leaves_its_stress_alone(device, dimension, angle):
    """The bonds that come in would wipe out part of the strain, and the shell would jerk with every particle."""
    block = Growing(device, dimension, turned(angle) @ STRETCHED)
    block.force()
    strain = block.strain()[block.solid]
    assert np.abs(strain).max() > 0.02
    block.solidify(1.0)
    force = block.force()
    assert np.all(block.state.numpy("phase") == Phase.SOLID)
    assert np.allclose(block.strain()[block.solid], strain, atol=1e-5)
    assert np.allclose(block.strain()[~block.solid], 0.0, atol=1e-5)
    assert np.abs(np.sum(force, axis=0)).max() < 1e-4 * np.abs(force).sum()


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
