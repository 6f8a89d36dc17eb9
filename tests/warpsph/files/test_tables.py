"""Diagnostics as tables of pandas and xarray, from a run and from its file."""

import sys

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, lattice
from warpsph.errors import InputError
from warpsph.files.results import ResultFile
from warpsph.run.measured import Measured
from warpsph.run.simulation import Simulation

HEIGHTS = np.array([0.1, 0.2, 0.3])


def observe(state, time):
    return {
        "height": Measured(HEIGHTS, "m", "height above the floor"),
        "profile": Measured(HEIGHTS + time, "K", "temperature of the wall", over="height"),
        "depth": Measured(HEIGHTS * (1.0 + time), "m", "depth"),
        "salt": Measured(HEIGHTS * time, "", "share of salt", over="depth"),
        "centre": Measured(np.array([time, 0.0]), "m", "centre of mass"),
        "corners": np.zeros((2, 2)),
        "flow": Measured(2.0 * time, "kg/s", "flow", per_depth=True),
    }


@pytest.fixture(params=["result", "file"])
def diagnosed(request, tmp_path):
    """A result, and the file that was written of it."""
    particles = Particles()
    particles.add(lattice((0.0, 0.0), (0.3, 0.3), 0.1), Role.FREE)
    model = Model(2, 0.1, (fluid_material("water", 1000.0),))
    path = tmp_path / "run.vtkhdf"
    result = Simulation(Executor("cpu", 1), model, particles, dt=0.1, observe=observe).run(0.3, 0.1, output=path)
    return result if request.param == "result" else ResultFile(path)


def test_numbers_over_time_are_a_data_frame(diagnosed):
    """If it failed, whoever analyses with pandas would have to take the series together by hand."""
    pytest.importorskip("pandas")
    frame = diagnosed.to_pandas()
    assert frame.index.name == "time"
    assert np.allclose(frame.index, [0.0, 0.1, 0.2, 0.3])
    assert set(frame.columns) == {"kinetic_energy", "highest_speed", "flow"}
    assert np.allclose(frame["flow"], 2.0 * frame.index)
    assert frame.attrs["units"]["flow"] == "(kg/s)/m"
    assert frame.attrs["labels"]["highest_speed"] == "highest speed"


def test_all_diagnostics_are_a_dataset(diagnosed):
    """If it failed, profiles would have to be put beside their heights by hand, and units be looked up."""
    pytest.importorskip("xarray")
    data = diagnosed.to_xarray()
    assert data["time"].attrs == {"units": "s", "long_name": "time"}
    assert data["profile"].dims == ("time", "height")
    assert data["profile"].attrs == {"units": "K", "long_name": "temperature of the wall"}
    assert data["height"].attrs["units"] == "m"
    assert float(data["profile"].sel(height=0.2, time=0.1, method="nearest")) == pytest.approx(0.3)
    assert data["salt"].dims == data["depth"].dims == ("time", "depth_index")
    assert "depth" in data.coords
    assert data["centre"].dims == ("time", "centre_index")
    assert data["corners"].dims == ("time", "corners_index_0", "corners_index_1")
    assert np.array_equal(data["flow"].values, diagnosed.diagnostics["flow"])
    assert data["flow"].attrs["units"] == "(kg/s)/m"


def test_what_was_not_measured_at_first_is_over_its_heights_all_the_same(diagnosed):
    """If it failed, one row without a measurement would take the heights away from a profile."""
    pytest.importorskip("xarray")
    diagnosed.diagnostics["height"][0] = np.nan
    assert diagnosed.to_xarray()["profile"].dims == ("time", "height")


@pytest.mark.parametrize(("library", "method"), [("pandas", "to_pandas"), ("xarray", "to_xarray")])
def test_a_library_that_is_not_installed_is_named(diagnosed, monkeypatch, library, method):
    """If it failed, who has installed warpsph alone would not know what is missing."""
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(InputError, match=rf"{library} is not installed; 'pip install warpsph\[analysis\]'"):
        getattr(diagnosed, method)()
