"""``warpsph render``."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
from cyclopts import Parameter
from cyclopts.validators import Number
from rich.text import Text

from warpsph.cli.consoles import error_console, output_console
from warpsph.cli.levels import read_levels
from warpsph.cli.target import check_free, check_target
from warpsph.errors import InputError
from warpsph.files.results import ResultFile

if TYPE_CHECKING:  # matplotlib takes long to import, and help must appear at once
    from warpsph.pictures.lines import Lines


def render(
    file: Path,
    /,
    *,
    field: Annotated[str | None, Parameter(metavar="NAME")] = None,
    time: Annotated[float | None, Parameter(metavar="SECONDS", validator=Number(gte=0))] = None,
    movie: bool = False,
    cut: Annotated[str | None, Parameter(metavar="AXIS=METRES")] = None,
    arrows: Annotated[bool, Parameter(negative=())] = False,
    streamlines: Annotated[bool, Parameter(negative=())] = False,
    levels: Annotated[str | None, Parameter(metavar="[NAME=]VALUE,...", allow_leading_hyphen=True)] = None,
    output: Annotated[Path | None, Parameter(metavar="PICTURE")] = None,
    overwrite: bool = False,
) -> None:
    """Draw a frame of a result file as a PNG picture, or all frames as an MP4 movie; no display is needed.

    Parameters
    ----------
    file
        A VTKHDF file written by `warpsph run`.
    field
        Colour the particles by this field, for example temperature, pressure, velocity, vorticity, phase or role; a
        casting as a caster sees it, and else temperature or speed, when not given.
    time
        Physical time in s; the nearest frame is drawn, the last one when not given.
    movie
        Draw all frames as a movie.
    cut
        Cut the picture open: leave out what lies beyond a plane, for example z=0.03 in three dimensions.
    arrows
        Show velocities as arrows, in two dimensions.
    streamlines
        Draw lines that follow the velocity, in two dimensions.
    levels
        Draw lines of equal value, in two dimensions: of the field that the colours show, or of the one that is named,
        for example temperature=1700,1750; or solidus, liquidus, or both, of all that melts.
    output
        The picture to write; when not given it stands beside FILE and is called after it, the field, the time of the
        frame, the cut and the lines, as far as they are given.
    overwrite
        Replace the picture if it exists.
    """
    if movie and time is not None:
        raise InputError("--time and --movie exclude each other: a movie shows all times")
    if movie and cut is not None:
        raise InputError("--cut and --movie exclude each other: a movie shows everything")
    plane = _plane(cut)
    suffix = ".mp4" if movie else ".png"
    if output is not None:
        check_target(output, suffix)
    result = ResultFile(file)
    if time is not None:
        _check_time(result, time)
        time = float(result.times[result.nearest(time)])
    named, values = read_levels(levels, result)
    drawn = [word for word, given in (("arrows", arrows), ("streamlines", streamlines), ("levels", levels)) if given]
    picture = output or _beside(file, field, time, plane, drawn, suffix)
    check_free(picture, overwrite)
    from warpsph.pictures.lines import Lines

    _draw(result, picture, field, time, movie, plane, Lines(arrows, streamlines, values, named))
    output_console().print(Text(f"written: {picture}"), soft_wrap=True)


def _draw(
    result: ResultFile,
    picture: Path,
    field: str | None,
    time: float | None,
    movie: bool,
    plane: tuple[int, float] | None,
    lines: "Lines",
) -> None:
    from warpsph.pictures import render_movie, render_still

    if movie:
        with error_console().status("drawing the movie"):
            render_movie(result, picture, field=field, lines=lines)
    else:
        render_still(result, picture, field=field, time=time, cut=plane, lines=lines)


def _plane(cut: str | None) -> tuple[int, float] | None:
    """Axis and place [m] of a plane from ``AXIS=METRES``."""
    if cut is None:
        return None
    axis, _, place = cut.partition("=")
    try:
        return ("x", "y", "z").index(axis.strip()), float(place)
    except ValueError:
        raise InputError(f"--cut '{cut}': give an axis and a place in metres, for example z=0.03") from None


def _beside(
    file: Path,
    field: str | None,
    time: float | None,
    plane: tuple[int, float] | None,
    lines: list[str],
    suffix: str,
) -> Path:
    """The picture's name, which says what it shows."""
    words = [file.stem]
    words += [field.replace("/", " ")] if field is not None else []
    words += [f"{time:.6g}s"] if time is not None else []
    words += [f"{'xyz'[plane[0]]}={plane[1]:g}"] if plane is not None else []
    return file.with_name("-".join(words + lines) + suffix)


def _check_time(result: ResultFile, time: float) -> None:
    slack = 1e-6 * np.ptp(result.times) if len(result.times) else 0.0
    if len(result.times) and not result.times[0] - slack <= time <= result.times[-1] + slack:
        raise InputError(f"--time {time:g}: {result.path} holds {result.times[0]:g} to {result.times[-1]:g} s")
