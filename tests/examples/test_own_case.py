"""The example of the manual's Python page: a case without a scenario, from a file of particles to a plot."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from warpsph.errors import InputError

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "docs" / "examples" / "own_case.py"
PAGE = (ROOT / "docs" / "getting-started.md").read_text()
BLOCKS = re.findall(r"```python\n(.*?)```", PAGE, re.S)


def test_the_manual_shows_the_example_as_it_is():
    """If it failed, what a reader copies would not be what has been tested."""
    assert EXAMPLE.read_text() in BLOCKS


def test_the_example_runs_twice_in_one_folder(tmp_path):
    """If it failed, the first script that a reader tries would end in an error, or the second try would."""
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    shutil.copy(EXAMPLE.with_name("basin.csv"), tmp_path)
    script = next(block for block in BLOCKS if "read_particles(" in block)
    for _ in range(2):
        done = subprocess.run(
            [sys.executable, "-c", script],
            cwd=tmp_path,
            env={"PATH": "", "HOME": str(tmp_path), "MPLBACKEND": "agg"},
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stderr
        assert "half of the energy is gone after 0.0" in done.stdout
        assert (tmp_path / "energy.png").stat().st_size > 5000


def test_the_example_is_small():
    """If it failed, writing a case would look harder than it is."""
    assert len(EXAMPLE.read_text().splitlines()) < 40


def test_a_file_that_exists_is_refused_in_the_words_of_python(tmp_path, monkeypatch):
    """If it failed, who runs the page's first lines twice would be told of a flag of the command line."""
    monkeypatch.chdir(tmp_path)
    script = next(block for block in BLOCKS if "HeatGaussian" in block)
    exec(script, {})
    with pytest.raises(InputError, match=r"plate.vtkhdf: exists already; .*overwrite=True") as caught:
        exec(script, {})
    assert "--" not in str(caught.value)
