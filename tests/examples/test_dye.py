"""The example of CONTRIBUTING.md: a term, from its kernels to a picture."""

import re
import sys
from pathlib import Path

import numpy as np
import pytest

from warpsph.cases import scenario as registry
from warpsph.files.results import ResultFile
from warpsph.pictures import render_still

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "docs" / "examples" / "dye"
FILES = ("kernels.py", "term.py", "scenario.py")


@pytest.fixture
def dyed_water(monkeypatch: pytest.MonkeyPatch):
    """The scenario of the example, imported as a newcomer would, and forgotten afterwards."""
    monkeypatch.setattr(registry, "_registry", dict(registry._registry))
    monkeypatch.syspath_prepend(EXAMPLE.parent)
    from dye.scenario import DyedWater

    yield DyedWater
    for name in [name for name in sys.modules if name.partition(".")[0] == "dye"]:
        del sys.modules[name]


def test_the_dye_diffuses_as_the_exact_solution(dyed_water, device):
    """If it failed, the example that newcomers start from would teach something wrong."""
    case = dyed_water()
    result = case.run(device=device)
    (check,) = case.checks(result)
    assert check.passed, check.error
    mean = result.diagnostics["dye_in_all"]
    assert np.allclose(mean, mean[0], rtol=1e-6)


def test_the_dye_is_in_the_file_and_in_a_picture(dyed_water, tmp_path):
    """If it failed, a field declared by a newcomer's term would be computed and never seen."""
    path, picture = tmp_path / "dye.vtkhdf", tmp_path / "dye.png"
    dyed_water(duration=0.5).run(device="cpu", output=path)
    stored = ResultFile(path)
    assert stored.frame(-1)[1]["dye"].max() == pytest.approx(1.0, abs=1e-3)
    assert stored.field_quantities["dye"].label == "concentration of the dye"
    render_still(stored, picture, field="dye")
    assert picture.stat().st_size > 5000


def test_the_manual_shows_the_files_as_they_are():
    """If it failed, what a newcomer copies would not be what has been tested."""
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "CONTRIBUTING.md").read_text(), re.S)
    for name in FILES:
        assert (EXAMPLE / name).read_text() in blocks, name


def test_the_example_is_small():
    """If it failed, adding a term would look harder than it is."""
    assert len((EXAMPLE / "scenario.py").read_text().splitlines()) < 60
