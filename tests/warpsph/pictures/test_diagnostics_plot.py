"""The diagnostics as small multiples."""

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.image import imread

from warpsph.core.quantity import Quantity
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile
from warpsph.pictures import plot_diagnostics


@pytest.fixture
def panels(monkeypatch) -> dict[str, Axes]:
    """The panels of every figure that is saved, by title."""
    found = {}
    save = Figure.savefig

    def remember(figure, *arguments, **options):
        for axes in figure.axes:
            if title := axes.get_title("left"):
                assert title not in found
                found[title] = axes
        save(figure, *arguments, **options)

    monkeypatch.setattr(Figure, "savefig", remember)
    return found


@pytest.fixture
def plotted(tmp_path):
    """Plot the diagnostics of a made-up run: rows of values, and what is known of them."""

    def plot(rows, quantities=None):
        path = tmp_path / "run.vtkhdf"
        with ResultWriter(path, {}, {}) as writer:
            for row, values in enumerate(rows):
                writer.write_diagnostics(0.1 * row, values, quantities)
        plot_diagnostics(ResultFile(path), tmp_path / "plot.png")

    return plot


def legend(axes: Axes) -> list[str]:
    """What the legend of a panel says."""
    return [text.get_text() for text in axes.get_legend().get_texts()] if axes.get_legend() else []


def test_declared_names_get_units_and_company(result, tmp_path, panels):
    """If it failed, curves would lack label or unit, or what was declared for one panel would stand apart."""
    plot_diagnostics(result, tmp_path / "plot.png")
    assert list(panels) == [
        "melt level [m]",
        "mass [kg/m]",
        "enthalpy [J/m]",
        "heat taken away [J/m]",
        "relative error of the heat ledger",
        "kinetic energy [J/m]",
        "highest speed [m/s]",
        "density [kg/m³]",
        "casting speed [m/s]",
        "something else",
        "shell thickness [m]",
        "shell surface temperature [K]",
    ]
    assert legend(panels["mass [kg/m]"]) == ["inside", "in", "out"]
    assert legend(panels["density [kg/m³]"]) == ["lowest", "highest"]
    assert legend(panels["melt level [m]"]) == []
    assert imread(tmp_path / "plot.png").shape[1] > 1000


def test_an_array_is_a_map_over_what_it_was_declared_over(plotted, panels):
    """If it failed, a profile would be drawn over the numbers of its entries, or over something unlabelled."""
    quantities = {
        "wetted": Quantity("wetted share", over="radius"),
        "radius": Quantity("distance from the axis", "m"),
        "modes": Quantity("modes", "m"),
    }
    radius = np.array([0.5, 1.0, 1.5])
    plotted([{"wetted": radius / (1.0 + k), "radius": radius, "modes": np.ones(4)} for k in range(5)], quantities)
    assert list(panels) == ["wetted share", "modes [m]"]
    assert panels["wetted share"].get_ylabel() == "distance from the axis [m]"
    assert panels["wetted share"].get_ylim() == pytest.approx((0.25, 1.75))
    assert panels["modes [m]"].get_ylabel() == "index"


@pytest.mark.parametrize("places", [[0.2, 0.1, 0.3], [0.1, np.nan, 0.3], [0.1, 0.2]])
def test_an_axis_that_cannot_be_one_is_the_index(plotted, panels, places):
    """If it failed, a profile over heights that do not rise, are undefined or too few could not be plotted."""
    values = {"profile": np.ones(3), "place": np.array(places)}
    plotted([values] * 3, {"profile": Quantity("profile", over="place")})
    assert panels["profile"].get_ylabel() == "index"


def test_what_has_another_unit_stands_apart(plotted, panels):
    """If it failed, masses and numbers of particles would share one axis because they share a panel's name."""
    quantities = {
        "weight": Quantity("weight", "kg", panel="drops"),
        "number": Quantity("number", panel="drops"),
        "lost": Quantity("lost", "kg", panel="drops"),
    }
    plotted([{"weight": 1.0, "number": 2.0, "lost": 3.0}] * 3, quantities)
    assert list(panels) == ["drops [kg]", "drops"]
    assert legend(panels["drops [kg]"]) == ["weight", "lost"]
    assert legend(panels["drops"]) == ["number"]


def test_many_curves_in_one_panel_all_differ(plotted, panels):
    """If it failed, the fifth curve of a panel would vanish, or look like the first."""
    quantities = {f"mode_{k}": Quantity(f"mode {k}", panel="modes") for k in range(11)}
    plotted([{name: float(k) for k, name in enumerate(quantities)}] * 3, quantities)
    looks = {(line.get_color(), line.get_linestyle()) for line in panels["modes"].get_lines()}
    assert len(looks) == 11
    assert len(legend(panels["modes"])) == 11


def test_names_of_files_without_declarations(plotted, panels):
    """If it failed, the diagnostics of an older file could not be plotted."""
    plotted([{"mass_inside": 1.0, "shell_thickness": np.ones(3)}] * 3)
    assert list(panels) == ["mass inside", "shell thickness"]


def test_unknown_colours_are_viridis(plotted, panels):
    """If it failed, a scenario that misspells the name of a colour map could not be plotted."""
    plotted([{"profile": np.arange(3.0)}] * 3, {"profile": Quantity("profile", colours="infernal")})
    assert panels["profile"].collections[0].get_cmap().name == "viridis"


def test_long_titles_are_broken(plotted, panels):
    """If it failed, the titles of two neighbouring panels would run into each other."""
    plotted([{"error": 1.0}], {"error": Quantity("largest error of the pressure, over that at the bottom", "Pa")})
    assert list(panels) == ["largest error of the pressure, over that at\nthe bottom [Pa]"]


@pytest.mark.parametrize("rows", [1, 2, 30])
def test_short_and_broken_series(plotted, panels, rows):
    """If it failed, the diagnostics of a run of one frame, or of one that lost its values, could not be plotted."""
    values = {"front": np.nan, "profile": np.arange(4.0), "one": np.ones(1)}
    plotted([values] * rows, {"front": Quantity("front", "m")})
    assert list(panels) == ["front [m]", "profile", "one"]


def test_events_are_told_in_lines_that_fit(tmp_path, monkeypatch):
    """If it failed, what happened in a run would be cut off at the edges of its plot."""
    told, widths = [], []
    save = Figure.savefig

    def remember(figure, *arguments, **options):
        told.append((figure.get_supxlabel(), max(text.get_window_extent().x1 for text in figure.texts)))
        widths.append(figure.bbox.x1)
        save(figure, *arguments, **options)

    monkeypatch.setattr(Figure, "savefig", remember)
    with ResultWriter(tmp_path / "run.vtkhdf", {}, {}) as writer:
        for time in range(3):
            writer.write_diagnostics(time, {"level": 1.0 * time})
        for time in range(10):
            writer.write_event(time, f"in zone {time} " + "the shell thins " * 8)
    plot_diagnostics(ResultFile(tmp_path / "run.vtkhdf"), tmp_path / "plot.png")
    text, right = told[0]
    assert "2 s: in zone 2" in text
    assert text.endswith("and 2 more events")
    assert right < widths[0]
