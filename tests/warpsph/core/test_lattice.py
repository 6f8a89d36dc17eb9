"""Sums over the lattice, from the one definition of each smoothing kernel."""

import numpy as np
import pytest
import warp as wp
from scipy.integrate import trapezoid

from warpsph.core.lattice import Lattice
from warpsph.kernels.basics import smoothing
from warpsph.kernels.basics.host import on_host
from warpsph.kernels.basics.smoothing import SMOOTHING_KERNELS

wp.set_module_options({"enable_backward": False})


@wp.kernel
def _evaluate(r_squared: wp.array[float], H: float, value: wp.array[float], slope: wp.array[float]):
    i = wp.tid()
    value[i] = smoothing.cubic_spline_value(r_squared[i], H)
    slope[i] = smoothing.sine_slope(r_squared[i], H)


def test_host_and_device_have_the_same_functions(device):
    """If it failed, constants would be computed from another smoothing kernel than the one that the kernels use."""
    r_squared = np.linspace(0.0, 1.2, 50).astype("f4") ** 2
    given = wp.array(r_squared, dtype=float, device=device)
    value, slope = wp.zeros_like(given), wp.zeros_like(given)
    wp.launch(_evaluate, 50, inputs=[given, 1.0, value, slope], device=device)
    assert np.allclose(value.numpy(), on_host(smoothing.cubic_spline_value)(r_squared.astype(float), 1.0), atol=1e-6)
    assert np.allclose(slope.numpy(), on_host(smoothing.sine_slope)(r_squared.astype(float), 1.0), rtol=1e-4, atol=1e-6)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", SMOOTHING_KERNELS)
def test_wide_supports_find_what_the_integral_has(name, dimension):
    """If it failed, a lattice sum would not go to the integral that it stands for, and masses or forces be wrong."""
    lattice = Lattice(dimension, 0.1, 8.0 if dimension == 2 else 6.0)
    if name != "sine":  # whose second derivative jumps at the support
        assert lattice.curvature(name) == pytest.approx(1.0, abs=0.025)
    if name != "viscosity":  # whose value and slope are too singular at the origin for a sum
        assert lattice.slope(name) == pytest.approx(1.0, abs=0.02)
        assert lattice.density(name) == pytest.approx(1.0, abs=0.06)


def test_known_sums():
    """If it failed, results would no longer be those that the tables of the manual give."""
    plane, space = Lattice(2, 0.01, 2.6), Lattice(3, 0.01, 2.6)
    assert plane.slope("spiky") == pytest.approx(0.9421, abs=5e-5)
    assert space.slope("spiky") == pytest.approx(0.9648, abs=5e-5)
    assert 2.0 * plane.surface("poly6", 0.0)[0] == pytest.approx(plane.slope("poly6"), rel=1e-12)


@pytest.mark.parametrize("dimension", [2, 3])
def test_coupling(dimension):
    """If it failed, time steps made of it would be too long. A wide support: sums go to the integral of 2 (-W'/r)."""
    around, here = Lattice(dimension, 0.1, 2.0).coupling("cubic_spline")
    if dimension == 2:
        assert around == pytest.approx(334.65, rel=1e-4)  # nine points, in double precision by hand
        assert here == pytest.approx(269.31, rel=1e-4)
    wide = Lattice(dimension, 0.1, 6.0)
    H = wide.support
    r = np.linspace(0.0, H, 2001)
    shape = on_host(smoothing.cubic_spline_slope)(r**2, H) * smoothing.normalisation("cubic_spline", dimension, H)
    exact = trapezoid(-2.0 * shape * (2.0 * np.pi * r if dimension == 2 else 4.0 * np.pi * r**2), r)
    assert sum(wide.coupling("cubic_spline")) == pytest.approx(exact, rel=0.02)
