"""Lines between bonded particles and arrows on fast ones."""

import numpy as np
from matplotlib.figure import Figure

from warpsph.core.labels import Phase
from warpsph.files.results import ResultFile
from warpsph.pictures.bonds import Bonds, bonded_pairs, bonds_of, draw_bonds
from warpsph.pictures.drawing import Drawing
from warpsph.scenarios.bonded_solid.melting_block import MeltingBlock

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

    assert bonds_of(File(), 28, scale=20.0) == Bonds(1.5, None)
    assert bonds_of(File(), 100_000, scale=20.0) is None


def test_bonds_do_not_cover_the_particles_of_a_body_that_is_small_in_the_picture(tmp_path):
    """If it failed, a block whose melt has flown far would be black, whatever its phases and colours."""
    path = tmp_path / "block.vtkhdf"
    case = MeltingBlock(columns=30, rows=10, settling=0.1, duration=0.2, output_interval=0.1)
    case.run(device="cpu", output=path)
    result = ResultFile(path)
    with_bonds = Drawing(result, [0], None, 1, 10.0, 100)
    assert with_bonds.bonds is not None
    assert Drawing(result, [0], None, 1, 3.0, 100).bonds is None
    wide = Figure(figsize=(10.0, 1.0)).add_subplot(xlim=(0.0, 1000.0))
    _, arrows = draw_bonds(wide, POINTS, FIELDS, Bonds(1.5, 2.0))
    assert arrows.units == "xy"
    assert arrows.width < 0.1 * 1.5
