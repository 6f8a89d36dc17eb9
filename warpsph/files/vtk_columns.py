"""The points of a VTK file and their data, read by a process that may die instead of ours.

``python -m warpsph.files.vtk_columns FILE SIZE`` writes them to standard output as NumPy's npz.
"""

import io
import logging
import sys
import warnings

import numpy as np

MEMORY, MEMORY_PER_BYTE = 2**31, 32  # that it may take: of its own, and for each byte of the file


def main(path: str, size: int) -> None:
    """Read and write.

    Raises:
        ValueError: what is wrong with the file.
    """
    _take_no_more(MEMORY + MEMORY_PER_BYTE * size)
    import pyvista

    logging.disable(logging.ERROR)
    warnings.simplefilter("ignore")
    with pyvista.vtk_verbosity("off"), pyvista.VtkErrorCatcher(send_to_logging=False) as found:
        mesh = pyvista.read(path)
    if found.error_events:
        raise ValueError(found.error_events[0].alert)
    if not isinstance(mesh, pyvista.DataSet):
        raise ValueError(f"it holds a {type(mesh).__name__}, not one set of points")
    columns = {"position": np.asarray(mesh.points), **{name: np.asarray(mesh[name]) for name in mesh.point_data}}
    texts = {name: values.astype(str) for name, values in columns.items() if values.dtype.kind == "O"}
    packed = io.BytesIO()
    np.savez(packed, allow_pickle=False, **(columns | texts))
    sys.stdout.buffer.write(packed.getbuffer())


def _take_no_more(memory: int) -> None:
    """Bound the memory of this process, where the system can."""
    try:
        import resource
    except ImportError:
        return
    resource.setrlimit(resource.RLIMIT_DATA, (memory, memory))


if __name__ == "__main__":
    try:
        main(sys.argv[1], int(sys.argv[2]))
    except Exception as error:  # a damaged file may raise anything inside VTK
        sys.exit(print(" ".join(str(error).split()) or type(error).__name__, file=sys.stderr) or 2)
