"""All frames as a movie."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from warpsph.errors import WarpsphError
from warpsph.files.beside import hidden_until_whole
from warpsph.files.results import ResultFile
from warpsph.pictures.drawing import SURVEYED_FRAMES, Drawing, check_output
from warpsph.pictures.lines import NO_LINES, Lines

DOTS_PER_INCH = 140
LONG_SIDE = 7.2  # inches
WORTH_A_TRY = 1 << 22  # bytes
SECONDS, FASTEST, SLOWEST = 10, 30, 4  # length to aim at; frames a second


def render_movie(
    result: ResultFile,
    output: Path,
    *,
    field: str | None = None,
    lines: Lines = NO_LINES,
    progress: Callable[[int, int], None] | None = None,
) -> None:
    """Draw every frame into an mp4 file (H.264), with one view and one colour scale.

    Args:
        result: the run.
        output: a file that ends in ".mp4"; it appears when it is complete.
        field, lines: as in :func:`warpsph.pictures.render_still`.
        progress: called with (frames done, frames) after each.

    Raises:
        InputError: unknown field or folder, a movie that may not be written, or a file without frames.
        WarpsphError: the disk is full or broken.
    """
    output = Path(output)
    check_output(output, (".mp4",))
    count = len(result.times)
    framed = np.linspace(0, count - 1, 2 * SURVEYED_FRAMES).round().astype(int).tolist() if count else []
    drawing = Drawing(result, framed, field, 1, LONG_SIDE, DOTS_PER_INCH, lines=lines)
    with hidden_until_whole(output) as hidden:
        _film(drawing, hidden, output, count, progress)


def _film(
    drawing: Drawing, hidden: Path, output: Path, count: int, progress: Callable[[int, int], None] | None
) -> None:
    """Write the movie to a hidden file, and see that it is whole: the encoder says nothing of a full disk."""
    import imageio_ffmpeg

    height, width, _ = drawing.sheet.pixels().shape
    rate = min(max(count / SECONDS, SLOWEST), FASTEST)
    video = imageio_ffmpeg.write_frames(
        str(hidden),
        (width, height),
        fps=rate,
        codec="libx264",
        macro_block_size=2,
        quality=8,
        ffmpeg_log_level="quiet",
    )
    try:
        video.send(None)
        for k in range(count):
            drawing.draw(0, k)
            video.send(np.ascontiguousarray(drawing.sheet.pixels()))
            if progress:
                progress(k + 1, count)
        video.close()
        written, _ = imageio_ffmpeg.count_frames_and_secs(str(hidden))
    except (OSError, RuntimeError):
        written = 0
    finally:
        video.close()
    if written != count:
        raise WarpsphError(f"{output}: cannot be written: {_what_is_wrong(hidden)}")


def _what_is_wrong(hidden: Path) -> str:
    """Why a movie is not whole, as far as another file in its place tells."""
    try:
        hidden.write_bytes(b"\0" * WORTH_A_TRY)
    except OSError as error:
        return str(error.strerror)
    return "its encoder has failed; the disk may be full"
