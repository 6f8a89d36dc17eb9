"""The file that ``--output`` names, refused before anything is computed or drawn."""

from pathlib import Path

from warpsph.errors import InputError


def check_target(output: Path, suffix: str) -> None:
    """Refuse a file that could not be written, or would not be what its name says.

    Raises:
        InputError: it has another suffix, is a folder, or its folder is missing.
    """
    if output.suffix.lower() != suffix:
        raise InputError(f"--output '{output}': give a name that ends in {suffix}")
    if output.is_dir():
        raise InputError(f"--output '{output}': is a folder; give the name of a file")
    if not output.parent.is_dir():
        raise InputError(f"--output '{output}': there is no folder '{output.parent}'; make it first")
