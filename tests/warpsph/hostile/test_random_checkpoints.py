"""Checkpoints with random damage, and whole ones with other values in them: refused in one line, or gone on from."""

import contextlib
import io
import os
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from warpsph.cli import main
from warpsph.errors import InputError
from warpsph.files.checkpoint import Checkpoint, beside
from warpsph.scenarios import HeatGaussian

CAMPAIGN = int(os.environ.get("WARPSPH_CAMPAIGN", 0))  # examples a test, as in CONTRIBUTING.md
some = settings(max_examples=CAMPAIGN or 15, deadline=None, database=None)


@cache
def good() -> tuple[bytes, bytes]:
    """The content of a result and of its checkpoint."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "a.vtkhdf"
        HeatGaussian(spacing=0.05, duration=2.0, output_interval=0.5).run("cpu", 1, output=output, checkpoint_every=0.5)
        return output.read_bytes(), beside(output).read_bytes()


def gone_on(folder: str, checkpoint: bytes | Checkpoint) -> None:
    """A resume that ends with 0, or with 2 and one line."""
    path = Path(folder) / "a.checkpoint"
    Path(folder, "a.vtkhdf").write_bytes(good()[0])
    if isinstance(checkpoint, Checkpoint):
        checkpoint.write(path)
    else:
        path.write_bytes(checkpoint)
    out, error = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        code = main(["run", "heat_gaussian", "--resume", str(path), "--until", "2.5", "--threads", "1", "--quiet"])
    assert code in (0, 2)
    assert error.getvalue().count("\n") == (code == 2)
    assert error.getvalue().replace("\n", "").isprintable()


@some
@given(st.lists(st.tuples(st.integers(0, 2**31), st.binary(min_size=1, max_size=8)), min_size=1, max_size=12))
def test_random_bytes(spots: list[tuple[int, bytes]]):
    """If it failed, a checkpoint with some flipped bytes would end in a traceback, or go on from garbage."""
    content = bytearray(good()[1])
    for place, data in spots:
        content[place % len(content) : place % len(content) + len(data)] = data
    with tempfile.TemporaryDirectory() as folder:
        gone_on(folder, bytes(content))
        with contextlib.suppress(InputError):
            read = Checkpoint.read(Path(folder) / "a.checkpoint")
            (Path(folder) / "right").write_bytes(good()[1])
            right = Checkpoint.read(Path(folder) / "right")
            assert read.saved["enthalpy"].tobytes() == right.saved["enthalpy"].tobytes()


odd = st.sampled_from([None, -1, 0, 10**30, "", "\x1b[31m", True, 1e308, float("nan"), float("-inf"), [], {}, ()])


@some
@given(st.dictionaries(st.integers(0, 100), odd, min_size=1, max_size=3), st.booleans())
def test_other_values(changes: dict[int, object], drop: bool):
    """If it failed, a checkpoint of something else would end in a traceback, or harm the result beside it."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "right").write_bytes(good()[1])
        right = Checkpoint.read(Path(folder) / "right")
        facts, saved = dict(right.facts), dict(right.saved)
        names = [(facts, name) for name in facts] + [(saved, name) for name in ("events", "recorder", "ledgers", "id")]
        for k, value in changes.items():
            where, name = names[k % len(names)]
            where[name] = np.array([1.0]) if drop and name == "id" else value
        gone_on(folder, Checkpoint(facts, saved))
