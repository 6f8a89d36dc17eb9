"""One picture of one moment, or several moments side by side."""

from pathlib import Path

from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.pictures.drawing import Cut, Drawing, check_output
from warpsph.pictures.lines import NO_LINES, Lines
from warpsph.pictures.sheet import STILL_SUFFIXES

DOTS_PER_INCH = 200
LONG_SIDE, LONG_SIDE_IN_SERIES = 7.2, 4.5  # inches


def render_still(
    result: ResultFile,
    output: Path,
    *,
    field: str | None = None,
    time: float | None = None,
    cut: Cut | None = None,
    lines: Lines = NO_LINES,
) -> None:
    """Draw the frame nearest to a time.

    Without ``field`` a run in which something has frozen is drawn as a caster sees it: melt from dark red to pale
    yellow and shell from navy to pale blue by temperature, beside mould, rolls and water in colours of their own. Other
    runs show temperature, where it varies, or speed.

    Args:
        result: the run.
        output: the picture; its suffix is one of ``STILL_SUFFIXES``.
        field: "role", "phase", "speed", "vorticity", or any stored field; vectors by magnitude.
        time: [s]; None for the last frame.
        cut: axis (0, 1, 2) and place [m] of a plane, beyond which nothing is drawn.
        lines: arrows, streamlines and lines of equal value over the particles, in the plane.

    Raises:
        InputError: unknown field, format or folder, or a file without frames.
    """
    times = [result.times[-1] if time is None and len(result.times) else time or 0.0]
    _render(result, output, field, times, LONG_SIDE, cut, lines)


def render_series(
    result: ResultFile, output: Path, times: list[float], *, field: str | None = None, lines: Lines = NO_LINES
) -> None:
    """Draw the frames nearest to several times [s] side by side with one colour bar; see :func:`render_still`."""
    if not times:
        raise InputError("times = []: a series needs at least one time")
    _render(result, output, field, times, LONG_SIDE_IN_SERIES, lines=lines)


def _render(
    result: ResultFile,
    output: Path,
    field: str | None,
    times: list[float],
    long_side: float,
    cut: Cut | None = None,
    lines: Lines = NO_LINES,
) -> None:
    output = Path(output)
    check_output(output, STILL_SUFFIXES)
    frames = [result.nearest(time) for time in times]
    drawing = Drawing(result, frames, field, len(frames), long_side, DOTS_PER_INCH, cut, lines)
    for panel, k in enumerate(frames):
        drawing.draw(panel, k)
    drawing.sheet.save(output)
