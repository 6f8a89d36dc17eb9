"""The file that ``--output`` names, refused before anything is computed or drawn."""

from pathlib import Path

from warpsph.errors import InputError

LONGEST_NAME = 200  # bytes, with which every file system agrees


def check_target(output: Path, suffix: str, made_by_us: bool = False) -> None:
    """Refuse a file that could not be written, or would not be what its name says.

    Args:
        output: the file.
        suffix: that its name must have.
        made_by_us: whether its folder will be made where it is missing.

    Raises:
        InputError: it has another suffix, is a folder, or its folder is missing.
    """
    if output.suffix.lower() != suffix:
        raise InputError(f"--output '{output}': give a name that ends in {suffix}")
    if len(output.name.encode()) > LONGEST_NAME:
        raise InputError(
            f"--output: a name of {len(output.name)} letters is too long; give one of at most {LONGEST_NAME}"
        )
    if output.is_dir():
        raise InputError(f"--output '{output}': is a folder; give the name of a file")
    if not (made_by_us or output.parent.is_dir()):
        raise InputError(f"--output '{output}': there is no folder '{output.parent}'; make it first")


def check_free(target: Path, overwrite: bool) -> None:
    """Refuse to replace a file that nobody allowed to be replaced.

    Raises:
        InputError: it exists.
    """
    if target.exists() and not overwrite:
        raise InputError(f"{target}: exists already; choose another name with --output, or give --overwrite")
