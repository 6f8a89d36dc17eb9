"""The layout of a VTKHDF file of particles: PolyData with steps, in which every particle is one vertex.

Format: https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/index.html. What VTK leaves out there: all
four topologies must be present, and the offsets of a step count from 0 and are one longer than its cells. VTK finds the
place of a step's offsets by counting cells, so a step without particles gets one cell without points.
"""

from collections.abc import Mapping
from math import prod

import h5py
import numpy as np

from warpsph.files.guarded import GuardedFile, whole_number

ROOT = "VTKHDF"
STEPS = f"{ROOT}/Steps"
MOST_COMPONENTS = 9  # of a field: a tensor
TOPOLOGIES = ("Vertices", "Lines", "Polygons", "Strips")
PARTICLES_PER_CHUNK = 16384
STEPS_PER_CHUNK = 256
TIMES_PER_CHUNK = 4096

Attributes = Mapping[str, Mapping[str, str | int]]


def extendable(group: h5py.Group, name: str, tail: tuple[int, ...], dtype, rows_per_chunk: int) -> None:
    """Make an empty dataset of shape (0, *tail) that can grow."""
    group.create_dataset(name, (0, *tail), dtype, maxshape=(None, *tail), chunks=(rows_per_chunk, *tail))


def put(dataset: h5py.Dataset, start: int, rows) -> None:
    """Let ``dataset`` end with ``rows`` (n, ...) from ``start`` on, in place of what a failed writing left there."""
    dataset.resize(start + len(rows), axis=0)
    dataset[start:] = rows


def put_cells(group: h5py.Group, step: int, first_cell: int, first_id: int, offsets: np.ndarray) -> None:
    """Add the cells of one step, made of the ids 0, 1, 2, ... in this order, to a topology."""
    cells, ids = len(offsets) - 1, int(offsets[-1])
    put(group["Offsets"], first_cell + step, offsets)
    put(group["Connectivity"], first_id, np.arange(ids))
    put(group["NumberOfCells"], step, [cells])
    put(group["NumberOfConnectivityIds"], step, [ids])


def create_layout(file: h5py.File) -> None:
    """Write the groups of a file that holds no step yet."""
    root = file.create_group(ROOT)
    root.attrs["Version"] = np.array([2, 0], dtype="i8")
    root.attrs["Type"] = np.bytes_("PolyData")
    extendable(root, "Points", (3,), "f4", PARTICLES_PER_CHUNK)
    extendable(root, "NumberOfPoints", (), "i8", STEPS_PER_CHUNK)
    root.create_group("PointData")
    for topology in TOPOLOGIES:
        group = root.create_group(topology)
        extendable(group, "NumberOfCells", (), "i8", STEPS_PER_CHUNK)
        extendable(group, "NumberOfConnectivityIds", (), "i8", STEPS_PER_CHUNK)
        rows_per_chunk = PARTICLES_PER_CHUNK if topology == "Vertices" else STEPS_PER_CHUNK
        extendable(group, "Offsets", (), "i8", rows_per_chunk)
        extendable(group, "Connectivity", (), "i8", rows_per_chunk)
    steps = root.create_group("Steps")
    steps.attrs["NSteps"] = np.int64(0)
    extendable(steps, "Values", (), "f8", TIMES_PER_CHUNK)
    for name in ("PartOffsets", "NumberOfParts", "PointOffsets"):
        extendable(steps, name, (), "i8", STEPS_PER_CHUNK)
    for name in ("CellOffsets", "ConnectivityIdOffsets"):
        extendable(steps, name, (len(TOPOLOGIES),), "i8", STEPS_PER_CHUNK)
    steps.create_group("PointDataOffsets")


def append_step(
    file: h5py.File, time: float, points: np.ndarray, fields: dict[str, np.ndarray], attributes: Attributes
) -> None:
    """Add one step: the data and the counts; when they are on the disk, ``NSteps``; and at the very end its time.

    Args:
        points: (n, 3) float32 [m].
        fields: (n,) or (n, 3) float32 or int32; the first step decides on the names.
        attributes: of the datasets of the fields, by name, given to them at the first step.
    """
    root, steps = file[ROOT], file[ROOT]["Steps"]
    step, count = int(steps.attrs["NSteps"]), len(points)
    if step == 0:
        first = first_cell = 0
        for name, values in fields.items():
            extendable(root["PointData"], name, values.shape[1:], values.dtype, PARTICLES_PER_CHUNK)
            root["PointData"][name].attrs.update(attributes.get(name, {}))
            extendable(steps["PointDataOffsets"], name, (), "i8", STEPS_PER_CHUNK)
    else:
        first = int(steps["PointOffsets"][step - 1] + root["NumberOfPoints"][step - 1])
        first_cell = int(steps["CellOffsets"][step - 1, 0] + root["Vertices/NumberOfCells"][step - 1])
    if set(fields) != set(root["PointData"]) or any(len(values) != count for values in fields.values()):
        raise ValueError(f"a frame of {count} particles needs {count} rows of each of {', '.join(root['PointData'])}")

    put(root["Points"], first, points)
    for name, values in fields.items():
        put(root["PointData"][name], first, values)
        put(steps["PointDataOffsets"][name], step, [first])
    vertices = np.arange(count + 1) if count else np.zeros(2)
    put_cells(root["Vertices"], step, first_cell, first, vertices)
    for topology in TOPOLOGIES[1:]:
        put_cells(root[topology], step, 0, 0, np.zeros(1))
    put(root["NumberOfPoints"], step, [count])
    put(steps["PartOffsets"], step, [step])
    put(steps["NumberOfParts"], step, [1])
    put(steps["PointOffsets"], step, [first])
    put(steps["CellOffsets"], step, [[first_cell, 0, 0, 0]])
    put(steps["ConnectivityIdOffsets"], step, [[first, 0, 0, 0]])
    commit(steps, "NSteps", step + 1)
    put(steps["Values"], step, [time])  # last: VTK crashes on more times than NSteps, and bears fewer
    file.flush()


def commit(group: h5py.Group, counter: str, count: int) -> None:
    """Let ``counter`` say that ``count`` rows are whole, once they are.

    A flush writes its parts in any order, the end of the file among them. Whoever is killed in the first one leaves an
    older count, and what that counts was there before.
    """
    group.file.flush()
    group.attrs.modify(counter, np.int64(count))
    group.file.flush()


def read_times(file: GuardedFile) -> np.ndarray:
    """Times of the steps of which everything has been written (S,) [s]."""
    counted = (f"{STEPS}/Values", f"{STEPS}/PointOffsets", f"{ROOT}/NumberOfPoints")
    written = whole_number(file.group(STEPS), "NSteps")
    complete = max(0, min(written, *(_rows(file, path) for path in counted)))
    rows = min(_rows(file, path) for path in (f"{ROOT}/Points", *file.members(f"{ROOT}/PointData").values()))
    first, count = (file.numbers(path, 0, complete, "iu").astype("i8") for path in counted[1:])
    whole = (first >= 0) & (count >= 0) & (count <= rows - first)
    times = file.numbers(counted[0], 0, complete if np.all(whole) else int(np.argmin(whole)), "f").astype("f8")
    if times.ndim != 1 or not np.all(np.isfinite(times)):
        raise ValueError("times of its frames are no finite numbers")
    return times


def read_step(file: GuardedFile, step: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Points (n, 3) and fields of one step."""
    first, count = (
        int(file.numbers(path, step, step + 1, "iu")[0]) for path in (f"{STEPS}/PointOffsets", f"{ROOT}/NumberOfPoints")
    )
    points = file.numbers(f"{ROOT}/Points", first, first + count, "f")
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"its positions have the shape {points.shape}")
    fields = {}
    for name, path in file.members(f"{ROOT}/PointData").items():
        fields[name] = file.numbers(path, first, first + count)
        if fields[name].ndim > 2 or not 0 < prod(fields[name].shape[1:]) <= MOST_COMPONENTS:
            raise ValueError(f"{name} has the shape {fields[name].shape}")
    return points, fields


def _rows(file: GuardedFile, path: str) -> int:
    shape = file.dataset(path).shape
    if not shape:
        raise ValueError(f"{path} has no rows")
    return int(shape[0])
