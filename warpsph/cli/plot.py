"""``warpsph plot``."""

from pathlib import Path

from rich.text import Text

from warpsph.cli.consoles import output_console
from warpsph.files.results import ResultFile


def plot(file: Path, /) -> None:
    """Draw the diagnostics of a result file over time; the picture FILE-diagnostics.png stands beside the file.

    Parameters
    ----------
    file
        A VTKHDF file written by `warpsph run`.
    """
    result = ResultFile(file)
    picture = file.with_name(f"{file.stem}-diagnostics.png")

    from warpsph.pictures import plot_diagnostics

    plot_diagnostics(result, picture)
    output_console().print(Text(f"written: {picture}"), soft_wrap=True)
