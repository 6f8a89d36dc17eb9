"""All frames as a movie."""

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np

from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.pictures.drawing import SURVEYED_FRAMES, Drawing, check_output
from warpsph.pictures.lines import NO_LINES, Lines

DOTS_PER_INCH = 140
LONG_SIDE = 7.2  # inches
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
        InputError: unknown field or folder, a movie that cannot be written, or a file without frames.
    """
    import imageio_ffmpeg

    output = Path(output)
    check_output(output, (".mp4",))
    count = len(result.times)
    framed = np.linspace(0, count - 1, 2 * SURVEYED_FRAMES).round().astype(int).tolist() if count else []
    drawing = Drawing(result, framed, field, 1, LONG_SIDE, DOTS_PER_INCH, lines=lines)
    unfinished = output.with_name(f".{output.stem}.{os.getpid()}.mp4")
    height, width, _ = drawing.sheet.pixels().shape
    rate = min(max(count / SECONDS, SLOWEST), FASTEST)
    video = imageio_ffmpeg.write_frames(
        str(unfinished),
        (width, height),
        fps=rate,
        codec="libx264",
        macro_block_size=2,
        quality=8,
        ffmpeg_log_level="error",
    )
    try:
        video.send(None)
        for k in range(count):
            drawing.draw(0, k)
            video.send(np.ascontiguousarray(drawing.sheet.pixels()))
            if progress:
                progress(k + 1, count)
        video.close()
        os.replace(unfinished, output)
    except OSError as error:
        raise InputError(f"{output}: cannot be written: {error.strerror or error}") from None
    finally:
        video.close()
        unfinished.unlink(missing_ok=True)
