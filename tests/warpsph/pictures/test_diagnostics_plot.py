"""The diagnostics as small multiples."""

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.image import imread

from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile
from warpsph.pictures import plot_diagnostics


@pytest.fixture
def titles(monkeypatch):
    """Titles of the panels of every figure that is saved."""
    found = []
    save = Figure.savefig

    def remember(figure, *arguments, **options):
        found.extend(axes.get_title("left") for axes in figure.axes if axes.get_title("left"))
        save(figure, *arguments, **options)

    monkeypatch.setattr(Figure, "savefig", remember)
    return found


def test_known_names_get_units_and_company(result, tmp_path, titles):
    """If it failed, curves would lack their unit, or what belongs together would stand apart."""
    plot_diagnostics(result, tmp_path / "plot.png")
    for title in ("melt level [m]", "mass [kg/m]", "density [kg/m³]", "heat taken away [J/m]", "shell thickness [m]"):
        assert titles.count(title) == 1
    assert "something else" in titles
    assert not any("height" in title or "time" in title for title in titles)
    assert imread(tmp_path / "plot.png").shape[1] > 1000


@pytest.mark.parametrize(("dimension", "title"), [(2, "kinetic energy [J/m]"), (3, "kinetic energy [J]")])
def test_depth_is_counted_where_there_is_one(tmp_path, titles, dimension, title):
    """If it failed, energies of a three-dimensional run would be given per metre of a depth that it has already."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {"dimension": dimension}) as writer:
        writer.write_diagnostics(0.0, {"kinetic_energy": 1.0})
    plot_diagnostics(ResultFile(path), tmp_path / "plot.png")
    assert titles == [title]


@pytest.mark.parametrize("rows", [1, 2, 30])
def test_short_and_broken_series(tmp_path, titles, rows):
    """If it failed, the diagnostics of a run of one frame, or of one that lost its values, could not be plotted."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        for row in range(rows):
            writer.write_diagnostics(0.1 * row, {"front": np.nan, "profile": np.arange(4.0), "one": np.ones(1)})
    plot_diagnostics(ResultFile(path), tmp_path / "plot.png")
    assert titles[0] == "front [m]"
    assert sorted(titles[1:]) == ["one", "profile"]
