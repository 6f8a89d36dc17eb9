"""Result and particle files with random damage: the commands that read them answer, and never with a traceback."""

import contextlib
import io
import os
import tempfile
from functools import cache
from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mutations import DRAWN, REFUSED, good_file, mutated

from warpsph.cli import main
from warpsph.errors import InputError
from warpsph.files.particles import read_particles
from warpsph.files.results import ResultFile

CAMPAIGN = int(os.environ.get("WARPSPH_CAMPAIGN", 0))  # examples a test, as in CONTRIBUTING.md
some = settings(max_examples=CAMPAIGN or 25, deadline=None, database=None)


@cache
def good_bytes() -> bytes:
    """The content of a good file."""
    with tempfile.TemporaryDirectory() as folder:
        good_file(Path(folder) / "a.vtkhdf")
        return (Path(folder) / "a.vtkhdf").read_bytes()


def check(path: Path, pictures: bool) -> None:
    """Read a file in every way."""
    with contextlib.suppress(InputError):
        result = ResultFile(path)
        for k in range(len(result.times)):
            result.frame(k)
        result.to_pandas()
    with contextlib.suppress(InputError):
        read_particles(path, 2)
    answered("info", str(path))
    if pictures:
        answered("plot", str(path), "--overwrite")
        answered("render", str(path), "--overwrite")


def answered(*words: str) -> None:
    """A command that ends with 0, or with 2 and one line."""
    out, error = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        code = main(words)
    assert code in (0, 2)
    assert error.getvalue().count("\n") == 1 or code == 0
    assert (out.getvalue() + error.getvalue()).replace("\n", "").isprintable()


damage = st.lists(st.tuples(st.integers(0, len(good_bytes()) - 1), st.binary(min_size=1, max_size=8)), max_size=12)
near = st.integers(0, 20_000)  # where most of the structure lies


@some
@given(damage | st.lists(st.tuples(near, st.binary(min_size=1, max_size=4)), max_size=30), st.integers(0, 300))
def test_random_bytes(spots: list[tuple[int, bytes]], dice: int):
    """If it failed, a file with some flipped bytes would end in a traceback, hang or take all memory."""
    content = bytearray(good_bytes())
    for place, data in spots:
        content[place : place + len(data)] = data
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.vtkhdf"
        path.write_bytes(content)
        check(path, pictures=dice == 1)


@some
@given(
    st.lists(st.sampled_from(sorted((DRAWN | REFUSED).keys() - {"300 series", "5000 series"})), max_size=4),
    st.integers(0, 100),
)
def test_random_pairs_of_faults(names: list[str], dice: int):
    """If it failed, two faults that are found alone would together pass to where they do harm."""

    def mutate(file: h5py.File) -> None:
        for name in names:
            with contextlib.suppress(Exception):
                (DRAWN | REFUSED)[name](file)  # which may not fit after another one

    with tempfile.TemporaryDirectory() as folder:
        check(mutated(Path(folder) / "a.vtkhdf", mutate), pictures=dice == 1)


values = st.sampled_from([0.0, -1.0, 1e-38, 1e38, -1e38, np.nan, np.inf, -np.inf, 1e9, 1e-9]) | st.floats(width=32)
DATASETS = [f"VTKHDF/PointData/{name}" for name in ("temperature", "velocity", "role", "material", "phase")]
DATASETS += ["VTKHDF/Points", "VTKHDF/Steps/Values", "VTKHDF/Steps/PointOffsets", "VTKHDF/NumberOfPoints"]
DATASETS += [f"warpsph/diagnostics/{name}" for name in ("time", "level", "heights", "profile")]


@some
@given(
    st.lists(st.tuples(st.sampled_from(DATASETS), st.lists(values, min_size=1, max_size=5)), max_size=5),
    st.integers(0, 50),
)
def test_random_values(changes: list[tuple[str, list[float]]], dice: int):
    """If it failed, numbers that no simulation writes would end a picture or a plot in a traceback."""

    def mutate(file: h5py.File) -> None:
        for path, numbers in changes:
            with np.errstate(all="ignore"):
                file[path][...] = np.resize(numbers, file[path].shape).astype(file[path].dtype)

    with tempfile.TemporaryDirectory() as folder:
        check(mutated(Path(folder) / "a.vtkhdf", mutate), pictures=dice == 1)


@some
@given(
    st.sampled_from([".csv", ".npy", ".npz"]),
    st.binary(max_size=200) | st.text(alphabet='xyz,0123456789.e-\n\t";v\x1b ', max_size=80).map(str.encode),
)
def test_random_particle_files(suffix: str, content: bytes):
    """If it failed, some particle file would end in a traceback."""
    head = {".npy": b"\x93NUMPY\x01\x00", ".npz": b"PK\x03\x04", ".csv": b"x,y\n"}[suffix]
    with tempfile.TemporaryDirectory() as folder:
        for start in (b"", head):
            path = Path(folder) / f"a{suffix}"
            path.write_bytes(start + content)
            try:
                read_particles(path, 2)
            except InputError as error:
                if not str(error).isprintable():
                    pytest.fail(f"unprintable: {error!r}")
