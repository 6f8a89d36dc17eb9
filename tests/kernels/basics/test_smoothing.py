"""The smoothing kernels against quadrature, numerical derivatives and lattice sums."""

import math

import numpy as np
import pytest
import warp as wp

from warpsph.kernels.basics import smoothing

NAMES = smoothing.SMOOTHING_KERNELS
wp.set_module_options({"enable_backward": False})


def _sampler(name: str):
    """A Warp kernel that evaluates value, slope and Laplacian of one smoothing kernel."""
    value, slope, laplacian = (getattr(smoothing, f"{name}_{part}") for part in ("value", "slope", "laplacian"))
    if name == "viscosity":

        @wp.kernel(module="unique")
        def sample(r: wp.array[float], H: float, dimension: int, out: wp.array2d[float]):
            k = wp.tid()
            out[0, k] = value(r[k] * r[k], H, dimension)
            out[1, k] = slope(r[k] * r[k], H, dimension)
            out[2, k] = laplacian(r[k] * r[k], H)
    else:

        @wp.kernel(module="unique")
        def sample(r: wp.array[float], H: float, dimension: int, out: wp.array2d[float]):
            k = wp.tid()
            out[0, k] = value(r[k] * r[k], H)
            out[1, k] = slope(r[k] * r[k], H)
            out[2, k] = laplacian(r[k] * r[k], H, dimension)

    return sample


SAMPLERS = {name: _sampler(name) for name in NAMES}


def normalised(name: str, r: np.ndarray, H: float, dimension: int, device: str) -> np.ndarray:
    """W, W'/r and the Laplacian at the distances r: shape (3, n), float64."""
    r = np.asarray(r, dtype=np.float32)
    out = wp.zeros((3, len(r)), dtype=float, device=device)
    wp.launch(
        SAMPLERS[name], dim=len(r), inputs=[wp.array(r, device=device), H, dimension], outputs=[out], device=device
    )
    return out.numpy().astype(np.float64) * smoothing.normalisation(name, dimension, H)


def quadrature(H: float, panels: int = 40, order: int = 20) -> tuple[np.ndarray, np.ndarray]:
    """Gauss points and weights on (0, H), panels split at H/2 where the cubic spline has a kink."""
    x, w = np.polynomial.legendre.leggauss(order)
    edges = np.linspace(0.0, H, panels + 1)
    left, width = edges[:-1, None], np.diff(edges)[:, None]
    return (left + width * (x + 1.0) / 2.0).ravel(), (width * w / 2.0).ravel()


def shell(r: np.ndarray, dimension: int) -> np.ndarray:
    """Circumference or surface of the sphere of radius r."""
    return 2.0 * math.pi * r if dimension == 2 else 4.0 * math.pi * r**2


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", NAMES)
def test_moments(name, dimension, device):
    """Otherwise densities, gradients or Laplacians of smooth fields would carry a constant factor."""
    H = 0.7
    r, weight = quadrature(H)
    W, slope, laplacian = normalised(name, r, H, dimension, device)
    volume = weight * shell(r, dimension)
    assert np.sum(volume * W) == pytest.approx(1.0, abs=2e-5)  # a constant field
    assert np.sum(volume * slope * r**2) == pytest.approx(-dimension, abs=1e-4)  # gradient of a linear field
    assert np.sum(volume * laplacian * r**2) == pytest.approx(2.0 * dimension, abs=3e-4)  # of a quadratic field


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", NAMES)
def test_derivatives(name, dimension, device):
    """Otherwise the gradient or the Laplacian would belong to another kernel than the value."""
    H, step = 1.0, 1e-2
    r = np.arange(0.06, 1.2, 0.02)
    r = r[(np.abs(r - H) > 3 * step) & (np.abs(r - H / 2) > 3 * step)]
    stencil = {k: normalised(name, r + k * step, H, dimension, device)[0] for k in (-2, -1, 0, 1, 2)}
    _, slope, laplacian = normalised(name, r, H, dimension, device)
    first = (8.0 * (stencil[1] - stencil[-1]) - (stencil[2] - stencil[-2])) / (12.0 * step)
    second = (16.0 * (stencil[1] + stencil[-1]) - (stencil[2] + stencil[-2]) - 30.0 * stencil[0]) / (12.0 * step**2)
    scale = smoothing.normalisation(name, dimension, H)
    stiff = 0.02 if name == "viscosity" else 2e-4  # the viscosity kernel is singular at r = 0
    np.testing.assert_allclose(slope * r, first, rtol=stiff, atol=1e-4 * scale)
    expected = second + (dimension - 1) * first / r
    np.testing.assert_allclose(laplacian, expected, rtol=stiff, atol=2e-2 * scale)


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", NAMES)
def test_zero_outside_the_support(name, dimension, device):
    """Otherwise the result would depend on which candidates beyond the support a neighbour list happens to hold."""
    outside = np.array([1.0, 1.0 + 1e-6, 1.1, 3.0])
    assert np.all(normalised(name, 0.3 * outside, 0.3, dimension, device) == 0.0)


@pytest.mark.parametrize("H", [1e-4, 5e-3, 10.0])
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("name", NAMES)
def test_every_length_scale(name, dimension, H, device):
    """Otherwise single precision would overflow or lose digits for very fine or very coarse particles."""
    q = np.linspace(0.0, 0.99, 100, dtype=np.float32)
    scaled = normalised(name, q * np.float32(H), H, dimension, device)
    unit = normalised(name, q, 1.0, dimension, device)
    for part, power in enumerate((dimension, dimension + 2, dimension + 2)):
        rounding = 1e-5 * np.abs(unit[part, 10:]).max()
        np.testing.assert_allclose(scaled[part] * H**power, unit[part], rtol=1e-4, atol=rounding)
    assert smoothing.normalisation(name, dimension, H) < np.finfo(np.float32).max / 100.0


def test_coincident_particles(device):
    """Otherwise two particles at one place would divide by zero; the cubic spline has a finite limit there."""
    for name in NAMES:
        assert np.all(np.isfinite(normalised(name, np.zeros(1), 0.01, 2, device)))
    h = 0.005
    slope = normalised("cubic_spline", np.zeros(1), 2.0 * h, 2, device)[1, 0]
    assert slope == pytest.approx(-30.0 / (7.0 * math.pi * h**4), rel=1e-6)


# Sums over an infinite square lattice of unit spacing, by kernel, quantity and support (docs/theory.md).
LATTICE = [
    ("poly6", "density", 2.6, 0.995316),
    ("poly6", "density", 3.0, 1.002329),
    ("poly6", "diffusivity", 2.6, 1.023868),
    ("poly6", "diffusivity", 3.0, 1.001359),
    ("spiky", "diffusivity", 2.6, 0.942093),
    ("spiky", "diffusivity", 3.0, 0.962751),
    ("sine", "diffusivity", 2.6, 1.032084),
    ("sine", "diffusivity", 3.0, 0.959049),
    ("cubic_spline", "density", 2.4, 0.999757),
    ("cubic_spline", "diffusivity", 2.4, 0.990793),
    ("viscosity", "laplacian", 2.6, 1.072794),
    ("viscosity", "laplacian", 3.0, 0.952754),
]


@pytest.mark.parametrize(("name", "quantity", "H", "factor"), LATTICE)
def test_lattice_factor(name, quantity, H, factor, device):
    """Otherwise the factors by which the code divides pressure, conduction and viscosity would not be those in use."""
    ticks = np.arange(-4, 5)
    x, y = (a.ravel().astype(float) for a in np.meshgrid(ticks, ticks))
    W, slope, laplacian = normalised(name, np.hypot(x, y), H, 2, device)
    sums = {
        "density": W.sum(),  # sum_j V W
        "diffusivity": -np.sum(slope * x * x),  # sum_j V W'/r x^2: Brookshaw's Laplacian, and the gradient of x
        "laplacian": np.sum(laplacian * x * x) / 2.0,  # Laplacian of x^2
    }
    assert sums[quantity] == pytest.approx(factor, abs=2e-6)


def test_unknown_kernel_is_refused():
    """Otherwise a mistyped kernel or dimension would surface as a wrong number."""
    with pytest.raises(ValueError, match="poly6"):
        smoothing.normalisation("poly7", 2, 1.0)
    with pytest.raises(ValueError, match="dimension"):
        smoothing.normalisation("poly6", 1, 1.0)
