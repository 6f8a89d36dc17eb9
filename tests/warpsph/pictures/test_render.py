"""Stills, series and movies of a made-up casting run, and what happens where VTK cannot draw."""

import subprocess
import sys

import imageio_ffmpeg
import numpy as np
import pytest
from matplotlib.image import imread

from warpsph.core.labels import Phase
from warpsph.core.quantity import Quantity
from warpsph.errors import InputError, WarpsphError
from warpsph.files.output import ResultWriter
from warpsph.files.results import ResultFile
from warpsph.pictures import graphics, plot_diagnostics, render_movie, render_series, render_still
from warpsph.pictures.sheet import Sheet, time_text


def share_of(image: np.ndarray, test) -> float:
    """Share of the pixels for which ``test(red, green, blue)`` holds."""
    return float(np.mean(test(*np.moveaxis(image[:, :, :3].astype(float), -1, 0))))


def turquoise(red, green, blue):
    return (green > 0.5) & (blue > 0.45) & (red < 0.4)


def molten(red, green, blue):
    return (red > 0.6) & (blue < 0.4) & (green < red)


@pytest.fixture(params=[True, False], ids=["vtk", "matplotlib"])
def with_graphics(request, monkeypatch):
    """Once as the machine is, once as if it had no graphics libraries."""
    if not request.param:
        monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    return request.param


def test_still_shows_mould_and_melt(result, tmp_path, with_graphics):
    """If it failed, the picture of a casting run would be empty, or in landscape format."""
    picture = tmp_path / "still.png"
    render_still(result, picture)
    image = imread(picture)
    assert image.shape[0] > 1.4 * image.shape[1]
    assert share_of(image, turquoise) > 0.01
    assert share_of(image, molten) > 0.08


@pytest.mark.parametrize("field", ["role", "phase", "material", "speed", "velocity", "pressure", "temperature", "id"])
def test_every_field_can_be_drawn(result, tmp_path, field, monkeypatch):
    """If it failed, a field that is in the file could not be looked at."""
    monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    picture = tmp_path / "still.png"
    render_still(result, picture, field=field, time=6.0)
    assert share_of(imread(picture), lambda red, green, blue: red + green + blue < 2.9) > 0.1


def test_time_chooses_the_frame(result, tmp_path, monkeypatch):
    """If it failed, every picture would show the last frame."""
    monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    levels = []
    for time in (0.0, 12.0):
        render_still(result, tmp_path / "still.png", field="phase", time=time)
        levels.append(share_of(imread(tmp_path / "still.png"), molten))
    assert levels[0] > 1.1 * levels[1]


def test_series_and_vector_formats(result, tmp_path):
    """If it failed, several moments could not be compared in one figure."""
    render_series(result, tmp_path / "series.png", [0.0, 6.0, 12.0])
    render_still(result, tmp_path / "still.png")
    series, still = imread(tmp_path / "series.png"), imread(tmp_path / "still.png")
    assert series.shape[1] > 1.5 * still.shape[1]
    render_still(result, tmp_path / "still.pdf")
    assert (tmp_path / "still.pdf").read_bytes().startswith(b"%PDF")
    with pytest.raises(InputError, match="at least one time"):
        render_series(result, tmp_path / "none.png", [])


def test_movie_has_every_frame(result, tmp_path, with_graphics):
    """If it failed, the movie would lack moments, or a failed one would be left behind."""
    movie, done = tmp_path / "movie.mp4", []
    render_movie(result, movie, progress=lambda frame, frames: done.append((frame, frames)))
    assert done == [(k + 1, 4) for k in range(4)]
    frames, _ = imageio_ffmpeg.count_frames_and_secs(movie)
    assert frames == 4
    assert list(tmp_path.iterdir()) == [movie]


def test_failed_movie_leaves_nothing(result, tmp_path):
    """If it failed, half a movie would look like a whole one."""

    def stop(frame, frames):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        render_movie(result, tmp_path / "movie.mp4", progress=stop)
    assert list(tmp_path.iterdir()) == []


def test_a_movie_that_is_not_whole_is_told(result, tmp_path, monkeypatch):
    """If it failed, a full disk would leave a stump that is called written: the encoder says nothing of it."""
    monkeypatch.setattr(imageio_ffmpeg, "count_frames_and_secs", lambda path: (3, 0.1))
    with pytest.raises(WarpsphError, match=r"movie\.mp4: cannot be written"):
        render_movie(result, tmp_path / "movie.mp4")
    assert list(tmp_path.iterdir()) == []


def test_three_dimensions(tmp_path, with_graphics):
    """If it failed, a three-dimensional case could not be drawn."""
    points = 0.1 * np.stack([axis.ravel() for axis in np.indices((6, 8, 4))], axis=1)
    n = len(points)
    fields = {"role": np.zeros(n, "i4"), "velocity": points.astype("f4")}
    with ResultWriter(tmp_path / "run.vtkhdf", {}, {"spacing": 0.1, "dimension": 3}) as writer:
        writer.write_frame(0.0, points, fields)
    render_still(ResultFile(tmp_path / "run.vtkhdf"), tmp_path / "still.png")
    assert share_of(imread(tmp_path / "still.png"), lambda red, green, blue: red + green + blue < 2.7) > 0.3


def test_a_cut_needs_the_depth_that_it_cuts(result, tmp_path):
    """If it failed, a cut that leaves nothing out would look like one that shows what is inside."""
    with pytest.raises(InputError, match=r"cut = z=0.03: this run is two-dimensional"):
        render_still(result, tmp_path / "still.png", cut=(2, 0.03))
    render_still(result, tmp_path / "still.png", cut=(1, 0.3))


def test_axes_in_space_have_names_and_numbers(tmp_path, monkeypatch):
    """If it failed, nobody could tell how large a body in space is."""
    texts = []
    save = Sheet.save

    def remember(sheet, output):
        texts.extend(text.get_text() for text in sheet.figure.axes[0].texts)
        save(sheet, output)

    monkeypatch.setattr(Sheet, "save", remember)
    monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    points = 0.1 * np.stack([axis.ravel() for axis in np.indices((6, 8, 4))], axis=1)
    with ResultWriter(tmp_path / "run.vtkhdf", {}, {"spacing": 0.1, "dimension": 3}) as writer:
        writer.write_frame(0.0, points, {"role": np.zeros(len(points), "i4")})
    render_still(ResultFile(tmp_path / "run.vtkhdf"), tmp_path / "still.png")
    assert {"x [m]", "y [m]", "z [m]", "0", "0.4", "0.2"} <= set(texts)


def test_a_cut_shows_what_is_inside(tmp_path, with_graphics):
    """If it failed, nobody could see the melt inside a block of shell."""
    points = 0.1 * np.stack([axis.ravel() for axis in np.indices((8, 8, 8))], axis=1)
    inside = np.all((points > 0.15) & (points < 0.55), axis=1)
    fields = {"role": np.zeros(len(points), "i4"), "phase": np.where(inside, Phase.LIQUID, Phase.SOLID).astype("i4")}
    with ResultWriter(tmp_path / "run.vtkhdf", {}, {"spacing": 0.1, "dimension": 3}) as writer:
        writer.write_frame(0.0, points, fields)
    shares = []
    for cut in (None, (2, 0.35)):
        render_still(ResultFile(tmp_path / "run.vtkhdf"), tmp_path / "still.png", field="phase", cut=cut)
        shares.append(share_of(imread(tmp_path / "still.png"), molten))
    assert shares[1] > 3.0 * shares[0]
    with pytest.raises(InputError, match="lie beyond"):
        render_still(ResultFile(tmp_path / "run.vtkhdf"), tmp_path / "still.png", cut=(0, -1.0))


def test_a_long_name_stays_on_the_sheet(tmp_path, monkeypatch):
    """If it failed, the name of a field of more than two words would be cut off at the edge of the picture."""
    monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    saved = []
    monkeypatch.setattr(Sheet, "save", lambda sheet, output: saved.append(sheet))
    quantities = {"dye": Quantity("concentration of the dye that was poured in", "kg/m^3")}
    with ResultWriter(tmp_path / "run.vtkhdf", {}, {"spacing": 0.1}, quantities=quantities) as writer:
        writer.write_frame(0.0, np.zeros((1, 3)), {"role": np.zeros(1, "i4"), "dye": np.ones(1, "f4")})
    render_still(ResultFile(tmp_path / "run.vtkhdf"), tmp_path / "still.png", field="dye")
    [sheet] = saved
    sheet.canvas.draw()
    [title] = [text for text in sheet.figure.texts if "dye" in text.get_text()]
    assert " ".join(title.get_text().split()) == "concentration of the dye that was poured in [kg/m³]"
    box = title.get_window_extent()
    assert box.x1 < sheet.figure.bbox.x1
    bar = next(axes for axes in sheet.figure.axes if hasattr(axes, "_colorbar"))
    assert bar.get_window_extent().y1 < box.y0


def test_wrong_requests_leave_nothing(result, tmp_path):
    """If it failed, a typo would cost a rendering, or end in a traceback."""
    with pytest.raises(InputError, match="did you mean 'pressure'"):
        render_still(result, tmp_path / "still.png", field="presure")
    with pytest.raises(InputError, match=r"\.png, \.pdf"):
        render_still(result, tmp_path / "still.docx")
    with pytest.raises(InputError, match=r"\.mp4"):
        render_movie(result, tmp_path / "movie.avi")
    with pytest.raises(InputError, match="there is no folder"):
        plot_diagnostics(result, tmp_path / "missing" / "plot.png")
    assert list(tmp_path.iterdir()) == []


def test_unwritable_pictures(result, tmp_path, monkeypatch):
    """If it failed, a full disk or a protected folder would end in a traceback."""
    monkeypatch.setattr(graphics, "graphics_available", lambda: False)
    (tmp_path / "still.png").mkdir()
    (tmp_path / "movie.mp4").mkdir()
    with pytest.raises(InputError, match="cannot be written"):
        render_still(result, tmp_path / "still.png")
    with pytest.raises(InputError, match="cannot be written"):
        plot_diagnostics(result, tmp_path / "still.png")
    with pytest.raises(InputError, match="cannot be written"):
        render_movie(result, tmp_path / "movie.mp4")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["movie.mp4", "still.png"]


def test_a_file_without_frames_is_refused(tmp_path):
    """If it failed, a run that ended at once would end the picture in a traceback."""
    path = tmp_path / "run.vtkhdf"
    with ResultWriter(path, {}, {}) as writer:
        writer.write_event(0.0, "nothing to begin with")
    for render in (render_still, render_movie, plot_diagnostics):
        with pytest.raises(InputError, match=r"holds no (frame|diagnostics)"):
            render(ResultFile(path), tmp_path / ("picture.mp4" if render is render_movie else "picture.png"))


def test_missing_libraries_are_noticed_and_named(result, tmp_path, monkeypatch, capsys):
    """If it failed, VTK would die with a segmentation fault on a bare machine, or nobody would know what to install."""
    monkeypatch.delenv("VTK_DEFAULT_OPENGL_WINDOW", raising=False)
    monkeypatch.setattr(graphics, "_loads", lambda library: False)
    monkeypatch.setattr(graphics, "graphics_available", graphics.graphics_available.__wrapped__)
    if sys.platform.startswith("linux"):
        assert not graphics.graphics_available()
    monkeypatch.setattr(graphics, "_child_draws", lambda environment: False)
    from warpsph.pictures import drawing

    drawing._tell_once.cache_clear()
    render_still(result, tmp_path / "a.png")
    render_still(result, tmp_path / "b.png")
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert "libegl1" in error
    assert "libgl1-mesa-dri" in error


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the choice of a window is for Linux only")
def test_osmesa_is_chosen_where_nothing_else_is(monkeypatch):
    """If it failed, a machine with OSMesa alone would lose shaded pictures, or VTK would die."""
    monkeypatch.setenv("VTK_DEFAULT_OPENGL_WINDOW", "to be removed at the end")
    monkeypatch.delenv("VTK_DEFAULT_OPENGL_WINDOW")
    monkeypatch.setattr(graphics, "_child_draws", lambda environment: "OSMesa" in environment[graphics.CHOICE])
    monkeypatch.setattr(graphics, "_loads", lambda library: True)
    assert graphics.graphics_available.__wrapped__()
    assert graphics.os.environ["VTK_DEFAULT_OPENGL_WINDOW"] == "vtkOSMesaRenderWindow"


def test_drawing_libraries_are_loaded_late():
    """If it failed, every command would start a second later, and VTK would be loaded unasked."""
    code = (
        "import sys, warpsph.pictures, warpsph.files.results; from warpsph.pictures.graphics import graphics_available;"
        "print([name for name in ('pyvista', 'vtkmodules', 'matplotlib') if name in sys.modules])"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "[]\n"


@pytest.mark.parametrize(
    ("time", "last", "text"),
    [
        (3.0, 12.0, "3.0 s"),
        (0.25, 2.0, "0.25 s"),
        (0.0125, 0.05, "12.5 ms"),
        (3e-5, 1e-4, "30.0 µs"),
        (0.0, 0.0, "0.00 µs"),
    ],
)
def test_time_stamps_read_well(time, last, text):
    """If it failed, all time stamps of a short run would read 0.0 s."""
    assert time_text(time, last) == text
