"""The thickness of the shell, on particles placed by hand."""

import numpy as np
import pytest

from warpsph.core.particles import lattice
from warpsph.scenarios.casting.casting import Casting
from warpsph.scenarios.casting.shell import profile_heights, shell_profile

CASE = Casting()
DX, W = CASE.spacing, CASE.half_width
HEIGHTS = profile_heights(CASE)


def measured(thickness: float, *, bulge: float = 0.0, slope: float = 1.0 / 0.012, case: Casting = CASE) -> np.ndarray:
    """Thickness (heights,) [m] that is measured where the solid fraction is 1/2 at a depth ``thickness`` [m]."""
    upper = (W, 0.44) if case.dimension == 2 else (W, 0.44, W)
    x = lattice((0.0,) * case.dimension, upper, DX)
    depth = W - x[:, 0]
    fraction = np.clip(0.5 + slope * (thickness - depth), 0.0, 1.0)
    x[:, 0] += bulge * np.sin(np.pi * x[:, 1] / 0.04)
    return shell_profile(case, HEIGHTS, x, fraction, np.full(len(x), 1500.0))[0]


@pytest.mark.parametrize("thickness", [0.0032, 0.006, 0.0085, 0.01, 0.0113, 0.016])
def test_a_flat_shell_is_as_thick_as_it_is(thickness):
    """Whole layers of particles would say 25 % less shell where it is a twentieth thinner."""
    assert np.allclose(measured(thickness), thickness, atol=0.05 * DX)


def test_a_front_within_one_layer_is_found_to_a_part_of_it():
    """Between two layers the solid fraction is known only as linear: half a spacing is the most that can be wrong."""
    assert np.allclose(measured(0.01, slope=1.0 / 0.002), 0.01, atol=0.5 * DX)


def test_a_shell_that_bulges_is_not_thicker():
    """Depth counts from where the cold face is, not from where it was."""
    assert np.allclose(measured(0.01, bulge=0.002), 0.01, atol=0.12 * DX)


def test_the_billet_is_measured_at_its_face():
    """In 3D the corner is colder, and is not what is compared with one-dimensional conduction."""
    assert np.allclose(measured(0.01, case=CASE.model_copy(update={"dimension": 3})), 0.01, atol=0.05 * DX)


def test_no_shell_and_no_steel_are_told_apart():
    """A hole is no thin shell, and the height above the melt is none at all."""
    x = lattice((0.0, 0.0), (W, 0.2), DX)
    thickness, surface = shell_profile(CASE, HEIGHTS, x, np.zeros(len(x)), np.full(len(x), 1800.0))
    there = HEIGHTS < 0.2
    assert np.all(thickness[there] == 0.0)
    assert np.allclose(surface[there], 1800.0)
    assert np.all(np.isnan(thickness[HEIGHTS > 0.2 + 2 * DX]))


@pytest.mark.parametrize(
    "change", [{}, {"mould_bottom": 0.3, "nozzle_mouth": 0.38}, {"level": 0.3, "nozzle_mouth": 0.27}]
)
def test_the_end_of_the_mould_is_one_of_the_heights(change):
    """Engineers ask for the shell at the exit of the mould, not a centimetre above."""
    case = Casting(**change)
    heights = profile_heights(case)
    assert np.min(np.abs(heights - case.mould_bottom)) < 1e-9
    assert np.all(np.diff(heights) > 0.0)
    assert heights[0] > 0.0
    assert heights[-1] < case.level
