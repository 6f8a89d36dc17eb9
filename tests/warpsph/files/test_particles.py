"""Particle files as a start: each kind of file gives what it holds; a bad one gives one line."""

from pathlib import Path

import numpy as np
import pytest
import pyvista

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.files.particles import read_particles
from warpsph.files.results import ResultFile
from warpsph.run.simulation import Simulation
from warpsph.terms import Conduction

DX = 0.1
KINDS = ("csv", "npy", "npz", "vtk", "vtp", "vtu")


def written(path: Path, x: np.ndarray, **columns: np.ndarray) -> Path:
    """A file of particles at ``x`` (n, 2) or (n, 3), with columns (n,) or a velocity (n, 3)."""
    flat = dict(zip("xyz", x.T, strict=False))
    for name, values in columns.items():
        flat |= {f"v{axis}": values[:, k] for k, axis in enumerate("xyz")} if name == "velocity" else {name: values}
    kind = path.suffix[1:]
    if kind == "csv":
        rows = zip(*flat.values(), strict=True)
        path.write_text("\n".join([",".join(flat), *(",".join(map(repr, map(float, row))) for row in rows)]))
    elif kind == "npy":
        table = np.zeros(len(x), [(name, "f8") for name in flat])
        for name, values in flat.items():
            table[name] = values
        np.save(path, table)
    elif kind == "npz":
        np.savez(path, position=x, **columns)
    else:
        mesh = pyvista.PolyData(np.column_stack([x, np.zeros(len(x))]) if x.shape[1] == 2 else x)
        for name, values in columns.items():
            mesh[name] = values
        (mesh.cast_to_unstructured_grid() if kind == "vtu" else mesh).save(path)
    return path


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_every_kind_of_file_gives_the_same_particles(tmp_path, kind, dimension):
    """If it failed, the start of a case would depend on the format in which somebody handed it over."""
    random = np.random.default_rng(1)
    x, temperature = random.random((7, dimension)), 300.0 + random.random(7)
    velocity = np.column_stack([random.random((7, dimension)), np.zeros((7, 3 - dimension))])
    path = written(tmp_path / f"start.{kind}", x, temperature=temperature, velocity=velocity)
    table = read_particles(path, dimension)
    assert set(table) == {"position", "velocity", "temperature"}
    assert table["position"].dtype == np.float64
    assert np.array_equal(table["position"][:, :dimension], x)
    assert table["position"].shape == (7, 3)
    assert np.array_equal(table["velocity"], velocity)
    assert np.array_equal(table["temperature"], temperature)
    assert set(read_particles(path, dimension, fields=("temperature",))) == {"position", "temperature"}
    assert set(read_particles(path, dimension, fields=())) == {"position"}


def test_bare_positions(tmp_path):
    """If it failed, an array of places, the least that a file can be, would not be a start."""
    x = np.random.default_rng(2).random((5, 3))
    np.save(tmp_path / "x.npy", x)
    assert np.array_equal(read_particles(tmp_path / "x.npy", 3)["position"], x)
    np.save(tmp_path / "x.npy", x[:, :2])
    assert np.array_equal(read_particles(tmp_path / "x.npy", 2)["position"], x * [1.0, 1.0, 0.0])
    pyvista.PolyData(x.astype("f4")).save(tmp_path / "x.ply")
    assert np.array_equal(read_particles(tmp_path / "x.ply", 3)["position"], x.astype("f4"))


def case(dimension: int, particles: Particles) -> Simulation:
    copper = {"conductivity": 400.0, "heat_capacity": 387.0}
    materials = (solid_material("plate", 8900.0, **copper), fluid_material("oil", 900.0, **copper))
    gravity = (0.0, 0.0, 0.0)
    return Simulation(Executor("cpu", 1), Model(dimension, DX, materials, (Conduction(),), gravity=gravity), particles)


def some_particles(dimension: int) -> Particles:
    particles = Particles()
    depth = (0.2,) * (dimension - 2)
    x = lattice((0.0, 0.0, *(0.0 for _ in depth)), (0.5, 0.3, *depth), DX) + 0.123456789 * np.array(
        [1, 1, dimension - 2]
    )
    particles.add(x, Role.FREE, "oil", temperature=300.0 + 100.0 * x[:, 0])
    particles.add(x + np.array([1.0, 0.0, 0.0]), Role.WALL, "plate", temperature=500.0)
    return particles


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_result_read_as_a_start_is_where_it_ended(tmp_path, dimension):
    """If it failed, a run could not be taken up where another one has ended."""
    path = tmp_path / "run.vtkhdf"
    result = case(dimension, some_particles(dimension)).run(0.2, 0.1, output=path)
    particles = Particles()
    particles.add_table(read_particles(path, dimension))
    again = case(dimension, particles).snapshot()
    assert np.array_equal(again["position"], result.positions)
    for name in ("role", "material", "phase", "velocity", "temperature", "enthalpy"):
        assert np.array_equal(again[name], result.fields[name]), name
    first = read_particles(path, dimension, fields=("temperature",), time=0.04)
    assert np.array_equal(first["temperature"], ResultFile(path).frame(0)[1]["temperature"])
    assert np.array_equal(read_particles(path, dimension, time=9.0)["temperature"], result.fields["temperature"])


@pytest.mark.parametrize("dimension", [2, 3])
def test_the_table_of_a_result_read_as_a_start_is_where_it_ended(tmp_path, dimension):
    """If it failed, a state could leave for a spreadsheet and not come back."""
    pytest.importorskip("pandas")
    result = case(dimension, some_particles(dimension)).run(0.1, 0.1)
    frame = result.particles_to_pandas()
    assert len(frame) == len(result.positions)
    assert frame["material"].iloc[-1] == "plate"
    frame.to_csv(tmp_path / "end.csv", index=False)
    particles = Particles()
    particles.add_table(read_particles(tmp_path / "end.csv", dimension))
    again = case(dimension, particles).snapshot()
    for name, values in (result.fields | {"position": result.positions}).items():
        assert np.array_equal(again[name], values), name


def test_what_is_given_takes_the_place_of_a_column(tmp_path):
    """If it failed, a file that says too much could not be used without being changed."""
    path = written(tmp_path / "start.csv", np.zeros((3, 2)), temperature=np.full(3, 300.0), role=np.full(3, 1.0))
    particles = Particles()
    particles.add_table(read_particles(path, 2), Role.FREE, material="oil", temperature=400.0)
    state = case(2, particles).snapshot()
    assert np.all(state["role"] == Role.FREE)
    assert np.all(state["temperature"] == 400.0)


def test_a_column_that_no_term_knows_is_refused_with_what_is_known(tmp_path):
    """If it failed, a misspelt column would be left out, and the case start with the default."""
    path = written(tmp_path / "start.csv", np.zeros((3, 2)), temprature=np.full(3, 300.0))
    particles = Particles()
    particles.add_table(read_particles(path, 2), Role.FREE, material="oil")
    with pytest.raises(InputError, match="no term of this case has a field 'temprature'; did you mean 'temperature'"):
        case(2, particles)


TEXTS = [
    ("a.csv", b"", "is empty"),
    ("a.csv", b"\n \n", "first line must name the columns"),
    ("a.csv", b"x,y,temperature\n", "holds no particles"),
    ("a.csv", b"0.1,0.2\n0.3,0.4\n", "has no header; its first line must name the columns"),
    ("a.csv", b"x;y\n1;2\n", "its columns are not parted by commas"),
    ("a.csv", b"x,y,temperature\n0,0,1\n\n0,1,hot\n", "line 4: 'temperature' is 'hot'; a number is needed"),
    ("a.csv", b"x,y\n0,0\n1,nan\n", "'y' is not a finite number in 1 of 2 rows, first in row 2"),
    ("a.csv", b"x,y,pressure\n0,0,inf\n", "'pressure' is not a finite number in 1 of 1 rows"),
    ("a.csv", b"x,y,T\n1,2,3\n1,2\n", "line 3 has 2 values; the header names 3 columns"),
    ("a.csv", b"x,y,y\n1,2,3\n", "two columns are called 'y'"),
    ("a.csv", b"x,,y\n1,2,3\n", "a column has no name"),
    ("a.csv", b"x,z\n1,2\n", "has x, z; give x, y and in 3D z"),
    ("a.csv", b"x,y,vx\n1,2,3\n", "has vx; give vx, vy and in 3D vz"),
    ("a.csv", b"x,y,z\n1,2,3\n", "z other than 0; the case has two dimensions"),
    ("a.csv", b"x,y,\xb5\n1,2,3\n", "is damaged or no file of particles"),
    *((f"a.{kind}", b"\x00 nothing of the kind", "is damaged or n") for kind in (*KINDS[1:], "vtkhdf")),
]


@pytest.mark.parametrize(("name", "content", "words"), TEXTS, ids=[f"{k}-{t[0]}" for k, t in enumerate(TEXTS)])
def test_a_bad_file_gives_one_line(tmp_path, capfd, name, content, words):
    """If it failed, whoever exports a file wrongly would be answered with a traceback, or with VTK's."""
    path = tmp_path / name
    path.write_bytes(content)
    text = refused(path)
    assert words in text
    assert capfd.readouterr().err == ""


def refused(path: Path, dimension: int = 2, **options) -> str:
    with pytest.raises(InputError) as caught:
        read_particles(path, dimension, **options)
    text = str(caught.value)
    assert text.startswith(str(path))
    assert "\n" not in text
    assert len(text) < len(str(path)) + 220
    return text


def test_bad_arrays_give_one_line(tmp_path):
    """If it failed, an array of another shape or kind would be spread over the particles, or end in a traceback."""
    x = np.zeros((4, 2))
    for content, words in (
        (x[:, 0], "its positions have the shape (4,); give (n, 2) or (n, 3)"),
        (np.zeros((4, 5)), "its positions have the shape (4, 5)"),
        (np.zeros((0, 2)), "holds no particles"),
        (np.array(["a", "b"]), "'position' holds <U1 values"),
        (x.astype(complex), "'position' holds complex128 values"),
        (np.array([{}, {}], object), "is damaged or no file of particles"),
        (np.full((4, 2), np.nan), "'position' is not a finite number in 4 of 4 rows"),
    ):
        np.save(tmp_path / "a.npy", content)
        assert words in refused(tmp_path / "a.npy")
    for columns, words in (
        ({}, "its columns: none"),
        ({"position": x, "x": x[:, 0]}, "has x, position; give x, y"),
        ({"position": x, "temperature": np.zeros(3)}, "'temperature' has 3 rows and 'position' has 4"),
        ({"position": x, "temperature": 3.0}, "'temperature' has 1 rows and 'position' has 4"),
    ):
        np.savez(tmp_path / "a.npz", **columns)
        assert words in refused(tmp_path / "a.npz")


def test_what_a_file_is_asked_for_must_be_there(tmp_path):
    """If it failed, a slip in the call would be blamed on the file, or on nothing."""
    path = written(tmp_path / "a.csv", np.zeros((3, 2)), temperature=np.ones(3))
    assert "no such file" in refused(tmp_path / "missing.csv")
    assert "is a folder" in refused(tmp_path)
    assert "has no column 'temprature'; did you mean 'temperature'?" in refused(path, fields=("temprature",))
    assert "two coordinates; the case has three dimensions: give x, y, z" in refused(path, 3)
    assert "dimension = 4: must be 2 or 3" in refused(path, 4)
    assert "time = 1.0: only a result of warpsph" in refused(path, time=1.0)


def test_a_result_that_does_not_fit_is_refused(tmp_path):
    """If it failed, a strand in the plane would be a sheet in space."""
    path = tmp_path / "run.vtkhdf"
    case(2, some_particles(2)).run(0.1, 0.1, output=path)
    assert "is a result in 2 dimensions; the case has 3" in refused(path, 3)
    assert "time = nan: must be a number" in refused(path, time=float("nan"))


@pytest.mark.parametrize("suffix", [".vtm", ".pvd", ".pkl", ".txt"])
def test_files_that_lead_to_others_are_refused(tmp_path, suffix):
    """If it failed, one block would silently stand for all, and a file could have another one read, or run code."""
    pyvista.MultiBlock([pyvista.PolyData(np.zeros((2, 3)))]).save(tmp_path / "a.vtm")
    path = (tmp_path / "a.vtm").rename(tmp_path / f"a{suffix}")
    assert "files of particles end in .csv, " in refused(path)
