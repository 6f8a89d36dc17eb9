"""Going on with the result file of a run that is resumed."""

from typing import Any

import h5py
import numpy as np

from warpsph.errors import InputError
from warpsph.files.results import ResultFile

Counts = dict[str, Any]


def refuse_other_run(result: ResultFile, counts: Counts) -> None:
    """Refuse a result file to which a checkpoint does not belong.

    Args:
        result: the file.
        counts: what it held at the checkpoint, by :meth:`warpsph.files.output.ResultWriter.counts`.

    Raises:
        InputError: it is of another run, or holds less than that.
    """
    if counts.get("run") != result.provenance.get("run"):
        raise InputError(f"{result.path}: is not the result of the run of this checkpoint; name another --output")
    held = {"frames": len(result.times), "diagnostics": len(result.diagnostics["time"]), "events": len(result.events)}
    for name, rows in held.items():
        if not 0 <= counts.get(name, -1) <= rows:
            raise InputError(
                f"{result.path}: holds {rows} {name}, the checkpoint is after {counts.get(name)}; name another "
                "--output to begin a file from there on"
            )


def cut_back(file: h5py.File, counts: Counts) -> None:
    """Let a result file hold no more than ``counts`` says.

    Times go first: VTK bears fewer of them than ``NSteps``, and crashes on more.
    """
    steps = file["VTKHDF/Steps"]
    steps["Values"].resize(counts["frames"], axis=0)
    file.flush()
    steps.attrs.modify("NSteps", np.int64(counts["frames"]))
    for series in ("diagnostics", "events"):
        file[f"warpsph/{series}"].attrs.modify("Rows", np.int64(counts[series]))
    file.flush()
