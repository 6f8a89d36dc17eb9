"""Lines between bonded particles and arrows on fast ones."""

import numpy as np
from matplotlib.figure import Figure

from warpsph.core.labels import Phase
from warpsph.pictures.bonds import Bonds, bonded_pairs, bonds_of, draw_bonds

POINTS = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.5, 0.9, 0.0), (0.5, -0.9, 0.0), (9.0, 0.0, 0.0)])
FIELDS = {
    "phase": np.array([Phase.SOLID, Phase.SOLID, Phase.SOLID, Phase.LIQUID, Phase.LIQUID]),
    "mean_velocity": np.array([(9.0, 0.0, 0.0)] * 3 + [(0.0, 3.0, 0.0), (0.0, 1.0, 0.0)]),
}


def test_solid_pairs_are_bonded():
    """If it failed, a fluid particle would look as if it hung on the solid."""
    pairs = {frozenset(pair) for pair in bonded_pairs(POINTS, FIELDS, Bonds(1.5, None)).tolist()}
    assert pairs == {frozenset(pair) for pair in ((0, 1), (0, 2), (1, 2))}


def test_fast_fluid_particles_have_arrows():
    """If it failed, a picture would not show where what has melted goes."""
    lines, arrows = draw_bonds(Figure().add_subplot(), POINTS, FIELDS, Bonds(1.5, 2.0))
    assert len(lines.get_segments()) == 3
    np.testing.assert_allclose(arrows.get_offsets(), [POINTS[3, :2]])
    assert len(draw_bonds(Figure().add_subplot(), POINTS, FIELDS, Bonds(1.5, None))) == 1


def test_only_small_runs_in_the_plane_show_bonds():
    """If it failed, a picture of a large body would be black with lines."""

    class File:
        provenance = {"bond": 1.5, "dimension": 2}

    assert bonds_of(File(), 28) == Bonds(1.5, None)
    assert bonds_of(File(), 100_000) is None
