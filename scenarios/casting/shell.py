"""The shell along the height of the strand: how thick it is, and how hot on its surface."""

import numpy as np

from warpsph.scenarios.casting.parameters import CastingParameters

SOLID = 0.5  # solid fraction at the inner side of the shell
WINDOW = 2.0  # spacings above and below a height within which particles tell of it
FINE = 16  # parts of a spacing in which the inner side is looked for


def profile_heights(case: CastingParameters, about: int = 22) -> np.ndarray:
    """Evenly spaced heights [m] between outflow and level, the lower end of the mould among them."""
    step = case.level / about
    if case.mould_bottom > 0.0:
        step = case.mould_bottom / max(round(case.mould_bottom / step), 1)
    heights = step * np.arange(1, int(case.level / step) + 1)
    return heights[(heights > WINDOW * case.spacing) & (heights < case.level - WINDOW * case.spacing)]


def shell_profile(
    case: CastingParameters,
    heights: np.ndarray,
    position: np.ndarray,
    solid_fraction: np.ndarray,
    temperature: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Thickness [m] and surface temperature [K] (heights,) of the shell at the face at x = half width.

    The thickness is the depth below the cold face at which the solid fraction falls below a half, linear between the
    particles; those within two spacings of a height tell of it, the nearest ones most. In 3D, of the half of the face
    next to the axis. No particles, no number.

    Args:
        case: the scenario.
        heights: (heights,) [m].
        position: (n, 3) of the free particles of steel [m].
        solid_fraction, temperature: (n,) of them, [K].
    """
    dx = case.spacing
    here = position[:, 0] > 0.5 * case.half_width
    if case.dimension == 3:
        here &= position[:, 2] < 0.5 * case.half_width
    x, y, solid, warmth = position[here, 0], position[here, 1], solid_fraction[here], temperature[here]
    depths = np.arange(0.0, 0.5 * case.half_width, dx / FINE)
    thickness, surface = np.full(len(heights), np.nan), np.full(len(heights), np.nan)
    for k, height in enumerate(heights):
        nearness = np.maximum(1.0 - np.abs(y - height) / (WINDOW * dx), 0.0)
        mine = nearness > 0.0
        if not np.any(mine):
            continue
        weight, depth = nearness[mine], np.max(x[mine]) - x[mine]
        outermost = depth < 0.6 * dx
        surface[k] = np.average(warmth[mine][outermost], weights=weight[outermost])
        depth += 0.5 * dx - np.average(depth[outermost], weights=weight[outermost])
        hats = weight * np.maximum(1.0 - np.abs(depths[:, None] - depth) / dx, 0.0)
        total = np.sum(hats, axis=1)
        inside = total > 0.0
        fraction = (hats @ solid[mine])[inside] / total[inside]
        thickness[k] = _first_below(SOLID, depths[inside], fraction)
    return thickness, surface


def _first_below(threshold: float, depth: np.ndarray, fraction: np.ndarray) -> float:
    """Depth [m] at which a fraction first falls below a threshold, linear between the depths."""
    below = np.flatnonzero(fraction < threshold)
    if len(below) == 0:
        return float(depth[-1])
    k = below[0]
    if k == 0:
        return 0.0
    share = (fraction[k - 1] - threshold) / (fraction[k - 1] - fraction[k])
    return float(depth[k - 1] + share * (depth[k] - depth[k - 1]))
