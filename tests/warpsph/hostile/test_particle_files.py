"""Particle files that are made to harm: one line, in little time and memory."""

import io
import zipfile

import numpy as np
import pytest

from warpsph.errors import InputError
from warpsph.files.particles import read_particles


def claim(shape: tuple[int, ...], kind: str = "<f8") -> bytes:
    """The head of a NumPy file that claims an array of any shape."""
    head = io.BytesIO()
    np.lib.format.write_array_header_2_0(head, {"shape": shape, "fortran_order": False, "descr": kind})
    return head.getvalue()


def packed_zeros() -> bytes:
    """A packed array of 320 MB in 0.3 MB."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive, archive.open("position.npy", "w") as member:
        member.write(claim((20_000_000, 2)))
        for _ in range(32):
            member.write(bytes(10**7))
    return packed.getvalue()


CODE = b"cbuiltins\nexec\n(S'raise SystemExit(9)'\ntR."
VTP = (
    b'<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="2000000000"><Points>'
    b'<DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0</DataArray>'
    b"</Points></Piece></PolyData></VTKFile>"
)
FILES = {
    "many columns.csv": (
        ",".join(f"c{k}" for k in range(100_000)).encode() + b"\n" + b"1," * 99_999 + b"1\n",
        "columns",
    ),
    "escape codes.csv": (b"x,y\n1," + b"\x1b[31m" * 1000 + b"\n", "a number is needed"),
    "lines in a value.csv": (b'x,y\n1,"2\n3"\n', "a number is needed"),
    "escapes in a name.csv": (b"x,\x1b[31m\n1,2\n", "its columns|has x"),
    "a claim.npy": (claim((10**10, 3)), "damaged"),
    "wide texts.npy": (claim((2, 3), "<U100000000"), "damaged"),
    "code.npy": (CODE, "damaged"),
    "code in an array.npy": (claim((1,), "|O") + CODE, "damaged"),
    "zeros.npz": (packed_zeros(), "unfolds to 3.2e"),
    "a claim.vtp": (VTP, "damaged"),
}


@pytest.mark.parametrize("name", FILES)
def test_harmful_particle_files_give_one_line(tmp_path, capfd, name: str):
    """If it failed, a particle file could run code, take all memory, end the process or write to the terminal."""
    content, words = FILES[name]
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=words) as caught:
        read_particles(tmp_path / name, 2)
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < len(str(tmp_path)) + 400
    assert capfd.readouterr().err == ""


def test_long_names_of_materials_take_no_memory(tmp_path):
    """If it failed, one long name in a table would be stored at its length for every particle."""
    (tmp_path / "a.csv").write_bytes(b"x,y,material\n1,2," + b"s" * 100_000 + b"\n" + b"1,2,steel\n" * 100)
    assert read_particles(tmp_path / "a.csv", 2)["material"].nbytes < 101 * 4 * 200
