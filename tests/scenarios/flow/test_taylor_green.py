"""Vortices that decay, coarse."""

import numpy as np
import pytest

from warpsph.scenarios.flow.formulation import gained_momentum
from warpsph.scenarios.flow.taylor_green import TaylorGreen


def test_the_exact_solution_obeys_its_equations():
    """Otherwise the start would be compressed, and the rate that of another flow."""
    case, step = TaylorGreen(reynolds=20.0), 1e-4
    points = np.random.default_rng(0).random((10, 3))
    ways = step * np.eye(3)[:2]
    plus, minus = (np.array([case.shape(points + sign * way) for way in ways]) for sign in (1, -1))
    slopes = (plus - minus) / (2.0 * step)  # (axis, point, component)
    np.testing.assert_allclose(slopes[0, :, 0] + slopes[1, :, 1], 0.0, atol=1e-6)
    laplacian = ((plus + minus - 2.0 * case.shape(points)) / step**2).sum(axis=0)
    np.testing.assert_allclose(laplacian / 20.0, -case.rate * case.shape(points), atol=1e-5)


@pytest.mark.parametrize("start", ["regular", "disordered"])
def test_vortices_decay_at_their_rate(start, device):
    """Particles that clump, or a lattice that gives way, would stop the vortices too soon."""
    case = TaylorGreen(rows=25, start=start, duration=0.5)
    result = case.run(device=device)
    assert abs(case.excess(result)) < 0.02  # second order: four times as much as with 50 rows
    assert result.diagnostics["velocity_noise"].max() < 0.02
    assert gained_momentum(result) < 2e-3
    energy, amplitude = (result.diagnostics[name] for name in ("energy_over_exact", "amplitude"))
    exact = result.diagnostics["exact_amplitude"]
    np.testing.assert_allclose(energy, (amplitude / exact) ** 2, rtol=1e-3)


@pytest.mark.parametrize("formulation", ["delta", "summed", "continuity"])
def test_forces_in_pairs_keep_momentum(formulation):
    """What the manual says of the formulations that are compared would be wrong."""
    case = TaylorGreen(rows=16, start="disordered", formulation=formulation, duration=0.1)
    assert gained_momentum(case.run(device="cpu")) < 1e-6


def test_checks_name_what_differs():
    """If two runs of verify could not be told apart, nobody would know which of them failed."""
    case = TaylorGreen(rows=16, duration=0.1)
    checks = case.checks(case.run(device="cpu"))
    assert len({check.quantity for check in checks}) == len(checks) == 3
    assert all("Re 100, 16 rows, regular, in 2D" in check.quantity for check in checks)
