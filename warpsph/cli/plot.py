"""``warpsph plot``."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter
from rich.text import Text

from warpsph.cli.consoles import output_console
from warpsph.cli.target import check_free, check_target
from warpsph.files.results import ResultFile


def plot(
    file: Path,
    /,
    *,
    output: Annotated[Path | None, Parameter(metavar="PICTURE")] = None,
    overwrite: bool = False,
) -> None:
    """Draw the diagnostics of a result file over time as a PNG picture.

    Parameters
    ----------
    file
        A VTKHDF file written by `warpsph run`.
    output
        The picture to write; FILE-diagnostics.png beside FILE when not given.
    overwrite
        Replace the picture if it exists.
    """
    if output is not None:
        check_target(output, ".png")
    result = ResultFile(file)
    picture = output or file.with_name(f"{file.stem}-diagnostics.png")
    check_free(picture, overwrite)

    from warpsph.pictures import plot_diagnostics

    plot_diagnostics(result, picture)
    output_console().print(Text(f"written: {picture}"), soft_wrap=True)
