"""Arrows, streamlines and lines of equal value over the particles, and the vorticity."""

from dataclasses import dataclass

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.image import imread

from warpsph.cli.levels import read_levels
from warpsph.core.labels import Role
from warpsph.core.quantity import Quantity
from warpsph.errors import InputError
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile
from warpsph.pictures import graphics, render_movie, render_still
from warpsph.pictures.gridded import gridded
from warpsph.pictures.lines import Lines, draw_lines
from warpsph.pictures.view import View
from warpsph.pictures.vorticity import vorticity

SPACING = 0.05
VIEW = View(0.0, 1.0, 0.0, 1.0, SPACING)


def disordered(dimension: int) -> np.ndarray:
    """Points (n, 3) of a disturbed lattice that fills the unit square, or cube."""
    random = np.random.default_rng(2)
    axis = np.arange(0.5 * SPACING, 1.0, SPACING * (1 if dimension == 2 else 2))
    points = np.stack(np.meshgrid(*[axis] * dimension), axis=-1).reshape(-1, dimension)
    points += random.normal(0.0, 0.1 * SPACING, points.shape)
    return np.column_stack([points, np.zeros((len(points), 3 - dimension))])


def turning(points: np.ndarray) -> dict[str, np.ndarray]:
    """A body that turns by 1.5 rad/s around the z axis at its middle, with x as its temperature."""
    x, y = points[:, 0] - 0.5, points[:, 1] - 0.5
    role = np.full(len(points), int(Role.FREE))
    return {"velocity": np.stack([-1.5 * y, 1.5 * x, 0.0 * x], axis=1), "role": role, "temperature": points[:, 0]}


def run(path, dimension: int = 2, **without) -> ResultFile:
    """A file with two frames of the body that turns."""
    points = disordered(dimension)
    fields = {name: values for name, values in turning(points).items() if name not in without}
    known = {"velocity": Quantity("velocity", "m/s"), "temperature": Quantity("temperature", "K")}
    quantities = {name: quantity for name, quantity in known.items() if name in fields}
    provenance = {"spacing": SPACING, "dimension": dimension, "materials": ["fluid"]}
    fields |= {"material": np.zeros(len(points), "i4"), "phase": np.zeros(len(points), "i4")}
    with ResultWriter(path, {"scenario": "turning"}, provenance, quantities=quantities) as writer:
        for time in (0.0, 1.0):
            writer.write_frame(time, points.astype("f4"), fields)
        writer.finish(status="complete")
    return ResultFile(path)


@pytest.mark.parametrize("dimension", [2, 3])
def test_the_vorticity_of_a_body_that_turns_is_twice_its_rate(dimension):
    """If it failed, a vortex would be shown too weak, or too weak at the walls."""
    points = disordered(dimension)
    curl = vorticity(points, turning(points))
    np.testing.assert_allclose(curl if dimension == 2 else curl[:, 2], 3.0, rtol=1e-6)


def test_values_on_the_grid_are_those_of_the_particles_around():
    """If it failed, lines of equal value would lie beside the colours, or go on where nothing is."""
    points = disordered(2)
    points = points[points[:, 1] < 0.7]
    x, y, values = gridded(points, turning(points), points[:, 0], VIEW, 0.5, 1.8)
    inside = np.ix_((y > 0.1) & (y < 0.6), (x > 0.1) & (x < 0.9))
    np.testing.assert_allclose(values[inside], np.broadcast_to(x, values.shape)[inside], atol=0.3 * SPACING)
    assert np.all(np.isnan(values[y > 0.8]))


@pytest.mark.parametrize("lines", [Lines(arrows=True), Lines(streamlines=True), Lines(levels=(0.3, 0.7))], ids=str)
def test_what_is_drawn_can_be_removed_again(lines):
    """If it failed, a movie would show the lines of all frames on top of each other."""
    points = disordered(2)
    axes = Figure().subplots()
    axes.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    before = len(axes.get_children())
    drawn = draw_lines(axes, points, turning(points), VIEW, lines, "temperature")
    assert drawn
    assert (axes.get_xlim(), axes.get_ylim()) == ((0.0, 1.0), (0.0, 1.0))
    for thing in drawn:
        thing.remove()
    assert len(axes.get_children()) == before


def test_a_line_lies_where_its_value_is():
    """If it failed, a solidus would be drawn at another place than the temperature has it."""
    points = disordered(2)
    axes = Figure().subplots()
    lines = Lines(levels=(0.3, 9.0), field="temperature")
    contours = draw_lines(axes, points, turning(points), VIEW, lines, "speed")[0]
    places = np.concatenate([path.vertices for path in contours.get_paths()])
    inside = places[(places[:, 1] > 0.1) & (places[:, 1] < 0.9)]
    np.testing.assert_allclose(inside[:, 0], 0.3, atol=0.4 * SPACING)


def test_pictures_and_movies_have_them(tmp_path, monkeypatch):
    """If it failed, one could ask for lines and get a picture without."""
    monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    result, pictures = run(tmp_path / "run.vtkhdf"), []
    every = Lines(arrows=True, streamlines=True, levels=(0.3, 0.7), field="temperature")
    for number, lines in enumerate((Lines(), every)):
        render_still(result, tmp_path / f"{number}.png", field="vorticity", lines=lines)
        pictures.append(imread(tmp_path / f"{number}.png"))
    dark = [np.mean(picture[:, :, :3].sum(axis=2) < 0.6) for picture in pictures]
    assert dark[1] > dark[0] + 0.01
    render_movie(result, tmp_path / "run.mp4", lines=every)
    assert (tmp_path / "run.mp4").stat().st_size > 1000


def test_what_cannot_be_drawn_is_refused(tmp_path):
    """If it failed, a picture in space would have lines of the plane, and a misspelt field no line at all."""
    picture = tmp_path / "picture.png"
    with pytest.raises(InputError, match="three-dimensional"):
        render_still(run(tmp_path / "space.vtkhdf", 3), picture, lines=Lines(arrows=True))
    flat = run(tmp_path / "flat.vtkhdf")
    with pytest.raises(InputError, match="temperature"):
        render_still(flat, picture, lines=Lines(levels=(1.0,), field="temperatur"))
    with pytest.raises(InputError, match="velocity"):
        render_still(run(tmp_path / "still.vtkhdf", velocity=None), picture, lines=Lines(arrows=True))
    with pytest.raises(InputError, match="finite"):
        Lines(levels=(float("nan"),))
    assert not picture.exists()


@dataclass
class Made:
    """What a result file says of the run that made it."""

    provenance: dict
    path: str = "a.vtkhdf"


STEEL = Made({"melting_ranges": {"steel": [1723.15, 1773.15]}})


@pytest.mark.parametrize(
    ("text", "read"),
    [
        (None, (None, ())),
        ("0.1,-2", (None, (0.1, -2.0))),
        ("temperature=1723.15,1773.15", ("temperature", (1723.15, 1773.15))),
        ("liquidus", ("temperature", (1773.15,))),
        ("solidus, liquidus", ("temperature", (1723.15, 1773.15))),
    ],
)
def test_levels_are_read_from_the_line(text, read):
    """If it failed, the field before the equals sign, or the ends of melting, would be taken for something else."""
    assert read_levels(text, STEEL) == read


@pytest.mark.parametrize(
    ("text", "made", "why"),
    [
        ("temperature=hot", STEEL, "give numbers"),
        ("solidus,1700", STEEL, "give numbers"),
        ("solidus", Made({}), "nothing is known in it that melts"),
        ("solidus", Made({"melting_ranges": {"steel": "hot"}}), "nothing is known in it that melts"),
    ],
)
def test_levels_that_nothing_has_are_refused(text, made, why):
    """If it failed, a line would be missing from a picture, without a word."""
    with pytest.raises(InputError, match=why):
        read_levels(text, made)
