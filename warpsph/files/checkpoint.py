"""A checkpoint: all that a run needs to go on later with the same bits, in one file."""

import io
import json
import os
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from warpsph.errors import InputError, shown
from warpsph.files.beside import hidden_until_whole
from warpsph.files.packing import Arrays, pack, unpack

FORMAT = 2
SUFFIX = ".checkpoint"
FACTS = "facts.json"
KINDS = {
    "warpsph": str,
    "warp": str,
    "kind of device": str,
    "parameters": dict,
    "result": dict,
    "wall_time": float,
    "time": float,
    "run_begin": float,
    "begin": float,
    "output_interval": float,
    "cycles": int,
}


@dataclass(frozen=True)
class Checkpoint:
    """What was saved of a run.

    Args:
        facts: what the file says about itself, plain values: versions, the case, where the schedule and the result are.
        saved: what :meth:`warpsph.core.registry.Registry.save` gave.
    """

    facts: dict[str, Any]
    saved: dict[str, Any]

    def write(self, path: Path) -> None:
        """Write the file beside and move it into place; the one that was there is kept as ``<name>.previous``.

        Raises:
            InputError, WarpsphError: it cannot be written; what was there stays.
        """
        arrays: Arrays = {}
        tree = {
            "format": FORMAT,
            "facts": pack(self.facts, arrays, "facts"),
            "saved": pack(self.saved, arrays, "saved"),
        }
        with hidden_until_whole(path) as hidden:
            with zipfile.ZipFile(hidden, "w", zipfile.ZIP_STORED) as archive:
                archive.writestr(FACTS, json.dumps(tree))
                for name, array in arrays.items():
                    with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                        np.lib.format.write_array(member, array, allow_pickle=False)
            _keep_previous(path)

    @classmethod
    def read(cls, path: str | Path) -> "Checkpoint":
        """Read a file of :meth:`write`.

        Raises:
            InputError: it is missing, damaged, or none of ours.
        """
        path = as_path("resume", path)
        with _reading(path), zipfile.ZipFile(path) as archive:
            members = archive.infolist()
            if any(member.compress_type != zipfile.ZIP_STORED for member in members):
                raise ValueError("its parts are compressed")
            if sum(member.file_size for member in members) > path.stat().st_size:
                raise ValueError("its parts are longer than the file")
            tree = json.loads(archive.read(FACTS))
            if tree["format"] != FORMAT:
                raise ValueError(f"format {tree['format']}, this version reads {FORMAT}")
            arrays = {member.filename.removesuffix(".npy"): _array(archive, member) for member in members[1:]}
            facts = unpack(tree["facts"], arrays)
            for name, kind in KINDS.items():
                if type(facts[name]) is not kind:
                    raise ValueError(f"'{name}' is no {kind.__name__}")
            return cls(facts, dict(unpack(tree["saved"], arrays)))


def as_path(name: str, given: str | Path) -> Path:
    """The path that an argument of that name gives.

    Raises:
        InputError: it is none.
    """
    if not isinstance(given, str | Path):
        raise InputError(f"{name} = {shown(given)}: must be the name of a file")
    return Path(given)


def beside(result: Path) -> Path:
    """Where the checkpoint of a result file is by default."""
    return result.with_suffix(SUFFIX)


def result_of(checkpoint: Path) -> Path:
    """The result file that a checkpoint belongs to by default."""
    name = checkpoint.name.removesuffix(".previous").removesuffix(SUFFIX)
    return checkpoint.with_name(f"{name}.vtkhdf")


def previous(path: Path) -> Path:
    """Where the checkpoint before the present one is kept."""
    return path.with_name(f"{path.name}.previous")


def _keep_previous(path: Path) -> None:
    """Give the present file a second name, so that at no moment there is none."""
    if not path.exists():
        return
    previous(path).unlink(missing_ok=True)
    try:
        os.link(path, previous(path))
    except OSError:  # a file system without second names
        os.replace(path, previous(path))


def _array(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> np.ndarray:
    content = io.BytesIO(archive.read(member))  # its checksum is compared here
    return np.lib.format.read_array(content, allow_pickle=False)


@contextmanager
def _reading(path: Path) -> Iterator[None]:
    if not path.is_file():
        raise InputError(f"{path}: {'is a folder' if path.is_dir() else 'no such checkpoint'}")
    try:
        yield
    except PermissionError:
        raise InputError(f"{path}: may not be read") from None
    except Exception as error:  # a damaged file may raise anything in the libraries
        reason = " ".join(str(error).split()) or type(error).__name__
        older = previous(path)
        hint = f"; the one before it is {older}" if older.is_file() else ""
        raise InputError(f"{path}: is damaged or not a checkpoint of warpsph ({reason}){hint}") from None
