"""Ways in which a result file can be wrong: each changes a good one, and a reader refuses it or reads what is right."""

import json
import os
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np

from warpsph.core.quantity import Quantity
from warpsph.files.output import ResultWriter

PARTICLES = 12
ESCAPES = "\x1b[31m\x1b]0;owned\x07\x9b5m\u202e$\\frac{$\n\0tab\t\ud800"


def good_file(path: Path) -> None:
    """A small, whole result: three frames of a little block that freezes."""
    x = np.stack(np.meshgrid(np.arange(4), np.arange(3), [0]), axis=-1).reshape(-1, 3).astype("f4") * 0.1
    provenance = {"spacing": 0.1, "dimension": 2, "materials": ["steel", "copper"], "bond": 0.15, "fast": 1.0}
    with ResultWriter(path, {"scenario": "made_up", "zones": [1, 2]}, provenance) as writer:
        for k in range(3):
            fields = {name: np.zeros(PARTICLES, "i4") for name in ("role", "material")}
            fields["phase"] = (np.arange(PARTICLES, dtype="i4") % 2) * 2
            fields["temperature"] = np.linspace(300.0, 400.0, PARTICLES, dtype="f4")
            fields["velocity"] = fields["mean_velocity"] = x + np.float32(k)
            writer.write_frame(float(k), x, fields)
            values = {"level": 0.1 * k, "heights": np.arange(3.0), "profile": np.arange(3.0) * k}
            known = {"profile": Quantity("profile", "m", over="heights")}
            writer.write_diagnostics(float(k), values, known)
            writer.write_event(float(k), "something happened")
        writer.finish(status="complete")


Mutation = Callable[[h5py.File], object]


def replaced(path: str, values: object, **options: object) -> Mutation:
    """Another dataset in the place of one."""

    def mutate(file: h5py.File) -> None:
        del file[path]
        file.create_dataset(path, data=values, **options)

    return mutate


def changed(path: str, rows: object, values: object) -> Mutation:
    """Other values in some rows."""

    def mutate(file: h5py.File) -> None:
        file[path][rows] = values

    return mutate


def counted(path: str, name: str, value: object) -> Mutation:
    """Another attribute."""

    def mutate(file: h5py.File) -> None:
        if name in file[path].attrs:
            del file[path].attrs[name]
        file[path].attrs[name] = value

    return mutate


def told(path: str, text: object) -> Mutation:
    """Another table or text."""

    def mutate(file: h5py.File) -> None:
        file[path][()] = text if isinstance(text, str) else json.dumps(text)

    return mutate


def linked(path: str, link: object) -> Mutation:
    """A link in the place of what was there."""

    def mutate(file: h5py.File) -> None:
        del file[path]
        file[path] = link

    return mutate


def provided(**facts: object) -> Mutation:
    """Other facts in the provenance."""
    return told("warpsph/provenance", {"spacing": 0.1, "dimension": 2, "materials": ["steel"]} | facts)


def huge(path: str, shape: tuple[int, ...], dtype: str = "f4", **options: object) -> Mutation:
    """A dataset of a huge shape of which nothing is in the file."""

    def mutate(file: h5py.File) -> None:
        del file[path]
        file.create_dataset(path, shape, dtype, **({"chunks": (16384, *shape[1:])} | options))

    return mutate


def many_frames(file: h5py.File) -> None:
    """Counts of a thousand million particles, with datasets that claim as many."""
    for path in ("VTKHDF/Points", *(f"VTKHDF/PointData/{name}" for name in file["VTKHDF/PointData"])):
        if file[path].maxshape[0] is None:
            file[path].resize(10**9, axis=0)
    file["VTKHDF/NumberOfPoints"][:] = 10**9
    file["VTKHDF/Steps/PointOffsets"][:] = 0


def bomb(file: h5py.File) -> None:
    """Zeros, compressed to a thousandth."""
    many_frames(file)
    rows, chunk = 10**8, 10**7
    huge("VTKHDF/Points", (rows, 3), chunks=(chunk, 3), compression="gzip", compression_opts=1)(file)
    file["VTKHDF/Points"][:chunk] = 0
    file["VTKHDF/NumberOfPoints"][:] = rows


def one_chunk(file: h5py.File) -> None:
    """A row out of a chunk that unfolds to a gigabyte."""
    huge("VTKHDF/PointData/temperature", (3 * 10**8,), chunks=(3 * 10**8,), compression="gzip")(file)


def virtual(file: h5py.File) -> None:
    """Values that lie in a pipe."""
    layout = h5py.VirtualLayout((36, 3), "f4")
    layout[:] = h5py.VirtualSource(f"{file.filename}.pipe", "x", (36, 3))
    del file["VTKHDF/Points"]
    file.create_virtual_dataset("VTKHDF/Points", layout)


def unlimited_virtual(file: h5py.File) -> None:
    """Values in a pipe, of a number that the pipe decides on."""
    layout = h5py.VirtualLayout((36, 3), "f4", maxshape=(None, 3))
    source = h5py.VirtualSource(f"{file.filename}.pipe", "x", (36, 3), maxshape=(None, 3))
    layout[: h5py.h5s.UNLIMITED, :] = source[: h5py.h5s.UNLIMITED, :]
    del file["VTKHDF/Points"]
    file.create_virtual_dataset("VTKHDF/Points", layout)


def outside(file: h5py.File) -> None:
    """Values that lie in a file of passwords."""
    del file["VTKHDF/Points"]
    file.create_dataset("VTKHDF/Points", (36, 3), "f4", external=[("/etc/passwd", 0, 432)])


def pipe_link(file: h5py.File) -> None:
    """A link to a pipe that nobody writes to."""
    linked("warpsph/events", h5py.ExternalLink(f"{file.filename}.pipe", "/x"))(file)


def references(file: h5py.File) -> None:
    """References in the place of numbers."""
    replaced("VTKHDF/PointData/phase", np.array([file.ref] * 36, h5py.ref_dtype))(file)


def crowd(count: int) -> Mutation:
    """As many series."""

    def mutate(file: h5py.File) -> None:
        for k in range(count):
            file[f"warpsph/diagnostics/s{k}"] = np.arange(3.0)

    return mutate


def same_place(file: h5py.File) -> None:
    """Hundreds of names for one large dataset."""
    file["VTKHDF/PointData/more"] = np.zeros((200_000, 9))
    many_frames(file)
    file["VTKHDF/NumberOfPoints"][:] = 200_000
    for k in range(500):
        file[f"VTKHDF/PointData/m{k}"] = file["VTKHDF/PointData/more"]


def texts(file: h5py.File) -> None:
    """Escape codes wherever a text can be."""
    named = "x\x1b[31m$\\frac{$"
    file.move("warpsph/diagnostics/level", f"warpsph/diagnostics/{named}")
    for name in ("label", "unit", "colours", "panel"):
        file[f"warpsph/diagnostics/{named}"].attrs[name] = ESCAPES[:-1].replace("\0", "")
        file["VTKHDF/PointData/temperature"].attrs[name] = ESCAPES[:-1].replace("\0", "")
    file["warpsph/events/text"][0] = ESCAPES[:-1].replace("\0", "")
    told("warpsph/parameters", {ESCAPES: ESCAPES, "list": [ESCAPES]})(file)
    provided(materials=[ESCAPES])(file)


def without(path: str) -> Mutation:
    """Something is missing."""

    def mutate(file: h5py.File) -> None:
        del file[path]

    return mutate


def every_place(value: float) -> Mutation:
    """All particles at one place."""
    return changed("VTKHDF/Points", slice(None), value)


POINTS, ROLE = "VTKHDF/Points", "VTKHDF/PointData/role"
TEMPERATURE, VELOCITY = "VTKHDF/PointData/temperature", "VTKHDF/PointData/velocity"
DEEP = '{"a":' + "[" * 900 + "]" * 900 + "}"

# a good picture can be drawn
DRAWN: dict[str, Mutation] = {
    "some places are no numbers": changed(POINTS, slice(0, 36, 5), np.nan),
    "no places": changed(POINTS, slice(None), np.nan),
    "places far away": changed(POINTS, slice(0, 36, 5), 1e38),
    "all places far away": every_place(-1e38),
    "half of the places rather far": changed(POINTS, slice(0, 18), 9e8),
    "one place": every_place(0.5),
    "one place far away": every_place(1e8),
    "no role": without(ROLE),
    "role 99": changed(ROLE, slice(None), 99),
    "role -1": changed(ROLE, slice(0, 36, 2), -1),
    "roles that are fractions": replaced(ROLE, np.zeros(36)),
    "roles of three parts": replaced(ROLE, np.zeros((36, 3), "i4")),
    "no phase": without("VTKHDF/PointData/phase"),
    "temperatures of three parts": replaced(TEMPERATURE, np.ones((36, 3))),
    "temperatures that are no numbers": changed(TEMPERATURE, slice(0, 36, 3), np.nan),
    "huge temperatures": replaced(TEMPERATURE, np.geomspace(1e-300, 1e308, 36)),
    "velocities of one part": replaced(VELOCITY, np.zeros(36)),
    "36 materials": changed("VTKHDF/PointData/material", slice(None), np.arange(36) * 10**6),
    "another spacing": provided(spacing=1e-300, bond=1e300, fast="x"),
    "a spacing of many digits": provided(spacing=10**400),
    "materials that are no names": provided(materials={"a": 1}, dimension=[3]),
    "in space": provided(dimension=3),
    "a wild box": provided(periodic_lengths=[1e30, 0, 0]),
    "a box of text": provided(periodic_lengths="abc", periodic_lower={}),
    "escape codes": texts,
    "300 series": crowd(300),
    "a series without rows": replaced("warpsph/diagnostics/level", np.zeros(0)),
    "a short series": replaced("warpsph/diagnostics/profile", np.zeros((1, 3))),
    "a series of matrices": replaced("warpsph/diagnostics/profile", np.zeros((3, 2, 2))),
    "times of diagnostics that are no numbers": changed("warpsph/diagnostics/time", slice(0, 2), np.nan),
    "huge diagnostics": changed("warpsph/diagnostics/level", slice(None), (-1.7e308, 0.0, 1.7e308)),
    "a profile that is no number": changed("warpsph/diagnostics/profile", slice(None), np.inf),
}

# nothing is read: one line
REFUSED: dict[str, Mutation] = {
    "points of one column": replaced(POINTS, np.zeros(36, "f4")),
    "points of two columns": replaced(POINTS, np.zeros((36, 2), "f4")),
    "points of text": replaced(POINTS, np.array([b"abc"] * 36)),
    "points of complex numbers": replaced(POINTS, np.zeros((36, 3), "c8")),
    "points of records": replaced(POINTS, np.zeros(36, [("x", "f4"), ("y", "f4")])),
    "points that are one number": replaced(POINTS, 1.0),
    "points that are nothing": replaced(POINTS, h5py.Empty("f4")),
    "references": references,
    "a field of many parts": replaced(TEMPERATURE, np.zeros((36, 1000))),
    "points are a group": linked(POINTS, h5py.SoftLink("/VTKHDF/Steps")),
    "a link to itself": linked("warpsph/diagnostics", h5py.SoftLink("/warpsph/diagnostics")),
    "a link within the file": linked(POINTS, h5py.SoftLink("/VTKHDF/PointData/velocity")),
    "a link to a pipe": pipe_link,
    "a link to a device": linked("warpsph", h5py.ExternalLink("/dev/zero", "/")),
    "values in a pipe": virtual,
    "a number of values in a pipe": unlimited_virtual,
    "values in another file": outside,
    "lists in lists": told("warpsph/parameters", DEEP),
    "long parameters": told("warpsph/parameters", "[" + "1," * 10**6 + "1]"),
    "counts that are fractions": replaced("VTKHDF/NumberOfPoints", np.full(3, 12.0)),
    "times that are no numbers": changed("VTKHDF/Steps/Values", 1, np.nan),
    "steps that are text": counted("VTKHDF/Steps", "NSteps", "three"),
    "rows that are many": counted("warpsph/diagnostics", "Rows", [3, 3]),
    "more events than there are": counted("warpsph/events", "Rows", 2**62),
    "5000 series": crowd(5000),
    "diagnostics are a dataset": replaced("warpsph/diagnostics", 1.0),
}

# larger than memory
HUGE: dict[str, Mutation] = {
    "many particles": many_frames,
    "compressed zeros": bomb,
    "a chunk of zeros": one_chunk,
    "wide profile": huge("warpsph/diagnostics/profile", (3, 10**9), "f8", chunks=(1, 10**6)),
    "long series": lambda file: (
        huge("warpsph/diagnostics/time", (10**9,), "f8")(file),
        counted("warpsph/diagnostics", "Rows", 10**9)(file),
    ),
    "many times": lambda file: (
        [huge(f"VTKHDF/{name}", (10**9,), "i8")(file) for name in ("NumberOfPoints", "Steps/PointOffsets")],
        huge("VTKHDF/Steps/Values", (10**9,), "f8")(file),
        counted("VTKHDF/Steps", "NSteps", 10**9)(file),
    ),
    "many names of one dataset": same_place,
}


def mutated(path: Path, mutation: Mutation) -> Path:
    """The good file, changed; beside it is a pipe that nobody writes to."""
    good_file(path)
    os.mkfifo(f"{path}.pipe")
    with h5py.File(path, "r+") as file:
        mutation(file)
    return path
