"""Smoothing kernels W(r) of compact support, as device functions without their normalisation.

Every function takes ``r_squared`` [m^2] and the support radius ``H`` [m] (W = 0 for r >= H; the cubic spline with
smoothing length h has H = 2h) and gives a shape that is exactly zero outside the support. The sum over neighbours is
multiplied once by :func:`normalisation`, which knows the dimension:

* ``<name>_value``: W;
* ``<name>_slope``: W'(r) / r, so that grad W = slope * r_vector;
* ``<name>_laplacian``: W'' + (dimension - 1) W' / r.

Where W'(r) / r or W itself has no limit at r = 0 (spiky, sine, viscosity), the distance is taken to be at least
``NEAREST * H``: the force between coincident particles is then zero, and nothing is divided by zero.

All shapes and normalisations fit in single precision for supports between 1e-4 m and 10 m.

Sources: Vijaykumar (2012), sections 2.4 and 4.5, after Mueller et al. (2003, 2004), with the corrections listed in
docs/errata.md; Monaghan (1992) for the cubic spline; Wendland (1995) for his C2 function.
"""

import math

import warp as wp

wp.set_module_options({"enable_backward": False})

NEAREST = wp.constant(1.0e-3)  # smallest distance, in supports, at which a singular shape is evaluated
HALF_PI = wp.constant(0.5 * math.pi)
QUARTER_PI = wp.constant(0.25 * math.pi)

# Normalisation = coefficient / H^power, by kernel and dimension.
_COEFFICIENT_AND_POWER = {
    "poly6": {2: (4.0 / math.pi, 8), 3: (315.0 / (64.0 * math.pi), 9)},  # Vijaykumar (2.13)
    "spiky": {2: (10.0 / math.pi, 5), 3: (15.0 / math.pi, 6)},  # Vijaykumar (2.18)
    "viscosity": {2: (40.0 / math.pi, 5), 3: (45.0 / math.pi, 6)},  # Vijaykumar (2.25), corrected
    "sine": {
        2: (math.pi**2 / (2.0 * (math.pi**2 - 8.0)), 3),  # Vijaykumar (4.17) is the three-dimensional one: corrected
        3: (math.pi / (8.0 * (math.pi / 3.0 - 8.0 / math.pi + 16.0 / math.pi**2)), 4),  # Vijaykumar (4.17)
    },
    "wendland_c2": {2: (7.0 / math.pi, 7), 3: (21.0 / (2.0 * math.pi), 8)},  # Wendland (1995)
    "cubic_spline": {2: (80.0 / (7.0 * math.pi), 5), 3: (16.0 / math.pi, 6)},  # Monaghan (1992), with H = 2h
}

SMOOTHING_KERNELS = tuple(_COEFFICIENT_AND_POWER)


def normalisation(name: str, dimension: int, H: float) -> float:
    """Factor by which sums over the shapes of the smoothing kernel ``name`` are multiplied.

    Args:
        name: one of ``SMOOTHING_KERNELS``.
        dimension: 2 or 3.
        H: support radius [m].

    Raises:
        ValueError: the kernel or the dimension is unknown, or H is not positive.
    """
    if name not in _COEFFICIENT_AND_POWER:
        raise ValueError(f"unknown smoothing kernel '{name}'; known are {', '.join(SMOOTHING_KERNELS)}")
    if dimension not in (2, 3) or not H > 0.0:
        raise ValueError(f"a smoothing kernel needs dimension 2 or 3 and a positive support, not {dimension} and {H}")
    coefficient, power = _COEFFICIENT_AND_POWER[name][dimension]
    return coefficient / H**power


@wp.func
def _distance(r_squared: float, H: float):
    nearest = NEAREST * H
    return wp.sqrt(wp.max(r_squared, nearest * nearest))


@wp.func
def poly6_value(r_squared: float, H: float):
    """(H^2 - r^2)^3 [m^6]."""
    b = wp.max(H * H - r_squared, 0.0)
    return b * b * b  # Vijaykumar (2.11)


@wp.func
def poly6_slope(r_squared: float, H: float):
    """-6 (H^2 - r^2)^2 [m^4]."""
    b = wp.max(H * H - r_squared, 0.0)
    return -6.0 * b * b  # Vijaykumar (2.14)


@wp.func
def poly6_laplacian(r_squared: float, H: float, dimension: int):
    """-6 (H^2 - r^2) (d H^2 - (d + 4) r^2) [m^4]."""
    d = float(dimension)
    b = wp.max(H * H - r_squared, 0.0)
    return -6.0 * b * (d * H * H - (d + 4.0) * r_squared)  # Vijaykumar (2.15), corrected in two dimensions


@wp.func
def spiky_value(r_squared: float, H: float):
    """(H - r)^3 [m^3]."""
    b = wp.max(H - wp.sqrt(r_squared), 0.0)
    return b * b * b  # Vijaykumar (2.16)


@wp.func
def spiky_slope(r_squared: float, H: float):
    """-3 (H - r)^2 / r [m]; singular."""
    r = _distance(r_squared, H)
    b = wp.max(H - r, 0.0)
    return -3.0 * b * b / r  # Vijaykumar (2.19)


@wp.func
def spiky_laplacian(r_squared: float, H: float, dimension: int):
    """-3 (H - r) ((d - 1) H - (d + 1) r) / r [m]; singular."""
    d = float(dimension)
    r = _distance(r_squared, H)
    b = wp.max(H - r, 0.0)
    return -3.0 * b * ((d - 1.0) * H - (d + 1.0) * r) / r  # Vijaykumar (2.20), corrected in two dimensions


@wp.func
def viscosity_value(r_squared: float, H: float, dimension: int):
    """The function with Laplacian H - r, zero with its slope at r = H [m^3]; singular, another in each dimension."""
    r = wp.min(_distance(r_squared, H), H)
    if dimension == 2:
        # Vijaykumar (2.21) has the Laplacian (2.25) in three dimensions only: corrected.
        inside = H * r * r / 4.0 - r * r * r / 9.0 - H * H * H * (wp.log(r / H) / 6.0 + 5.0 / 36.0)
        return wp.where(r < H, inside, 0.0)
    b = H - r
    return b * b * b * (H + r) / (12.0 * r)  # Vijaykumar (2.21), factored


@wp.func
def viscosity_slope(r_squared: float, H: float, dimension: int):
    """W'(r) / r of :func:`viscosity_value` [m]; singular."""
    r = wp.min(_distance(r_squared, H), H)
    b = H - r
    if dimension == 2:
        return -b * b * (H + 2.0 * r) / (6.0 * r * r)
    return -b * b * (H * H + 2.0 * H * r + 3.0 * r * r) / (12.0 * r * r * r)  # Vijaykumar (2.24), corrected


@wp.func
def viscosity_laplacian(r_squared: float, H: float):
    """H - r [m], in two and in three dimensions."""
    return wp.max(H - wp.sqrt(r_squared), 0.0)  # Vijaykumar (2.25), corrected


@wp.func
def sine_value(r_squared: float, H: float):
    """(2 H / pi) (1 - sin(pi r / 2 H)) [m]."""
    s = wp.sin(QUARTER_PI * wp.max(1.0 - wp.sqrt(r_squared) / H, 0.0))  # 1 - sin x = 2 sin^2(pi/4 - x/2)
    return 2.0 * H / HALF_PI * s * s  # Vijaykumar (4.15)


@wp.func
def sine_slope(r_squared: float, H: float):
    """-cos(pi r / 2 H) / r [1/m]; singular."""
    r = _distance(r_squared, H)
    return -wp.sin(HALF_PI * wp.max(1.0 - r / H, 0.0)) / r  # Vijaykumar (4.16)


@wp.func
def sine_laplacian(r_squared: float, H: float, dimension: int):
    """(pi / 2 H) sin(pi r / 2 H) - (d - 1) cos(pi r / 2 H) / r [1/m]; singular."""
    r = _distance(r_squared, H)
    second = wp.where(r < H, HALF_PI / H * wp.sin(HALF_PI * r / H), 0.0)
    return second + (float(dimension) - 1.0) * sine_slope(r_squared, H)


@wp.func
def cubic_spline_value(r_squared: float, H: float):
    """(H - r)^3 - 4 (H/2 - r)^3, each bracket zero where negative [m^3]."""
    r = wp.sqrt(r_squared)
    outer = wp.max(H - r, 0.0)
    inner = wp.max(0.5 * H - r, 0.0)
    return outer * outer * outer - 4.0 * inner * inner * inner


@wp.func
def cubic_spline_slope(r_squared: float, H: float):
    """-3 (2 H - 3 r) within r < H/2, -3 (H - r)^2 / r beyond [m]; -6 H at r = 0."""
    r = wp.sqrt(r_squared)
    outer = wp.max(H - r, 0.0)
    return -3.0 * wp.where(r < 0.5 * H, 2.0 * H - 3.0 * r, outer * outer / wp.max(r, NEAREST * H))


@wp.func
def cubic_spline_laplacian(r_squared: float, H: float, dimension: int):
    """6 ((H - r) - 4 (H/2 - r)) + (d - 1) slope, each bracket zero where negative [m]."""
    r = wp.sqrt(r_squared)
    second = 6.0 * (wp.max(H - r, 0.0) - 4.0 * wp.max(0.5 * H - r, 0.0))
    return second + (float(dimension) - 1.0) * cubic_spline_slope(r_squared, H)


@wp.func
def wendland_c2_value(r_squared: float, H: float):
    """(H - r)^4 (H + 4 r) [m^5]."""
    r = wp.sqrt(r_squared)
    b = wp.max(H - r, 0.0)
    return b * b * b * b * (H + 4.0 * r)


@wp.func
def wendland_c2_slope(r_squared: float, H: float):
    """-20 (H - r)^3 [m^3]."""
    b = wp.max(H - wp.sqrt(r_squared), 0.0)
    return -20.0 * b * b * b


@wp.func
def wendland_c2_laplacian(r_squared: float, H: float, dimension: int):
    """-20 (H - r)^2 (d H - (d + 3) r) [m^3]."""
    d = float(dimension)
    r = wp.sqrt(r_squared)
    b = wp.max(H - r, 0.0)
    return -20.0 * b * b * (d * H - (d + 3.0) * r)
