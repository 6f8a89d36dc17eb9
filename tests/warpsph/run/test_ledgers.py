"""What is there at the end is what was there at the start, and what has come in; if not, it is said."""

import warnings

import numpy as np
import pytest

from warpsph.core.executor import Executor
from warpsph.files.results import ResultFile
from warpsph.run.simulation import Simulation
from warpsph.scenarios import (
    Drop,
    HeatGaussian,
    HeatSlab,
    MeltingBlock,
    MeltingRectangle,
    MeltingTriangle,
    RubberRings,
)

HEAT = {"spacing": 0.04, "duration": 2.0, "output_interval": 0.5}


def ledgers(simulation: Simulation, tamper=None) -> dict:
    """Those of a run of half a second, and half a second more after somebody has tampered with the state."""
    simulation.run(0.5, 0.5)
    if tamper:
        tamper(simulation.state)
    return {ledger.quantity: ledger for ledger in simulation.run(0.5, 0.5).ledgers}


def test_heat_and_mass_close_and_are_stored(tmp_path):
    """If it failed, a run could lose heat or particles, and nobody would see it in its file."""
    result = HeatSlab(duration=20.0).run("cpu", 1, output=tmp_path / "slab.vtkhdf")
    heat = next(ledger for ledger in result.ledgers if ledger.quantity == "heat")
    assert heat.end - heat.start == pytest.approx(heat.gains["walls"], rel=1e-4)
    assert heat.gains["walls"] > 0.05 * heat.start
    assert abs(heat.error) < 1e-7
    stored = ResultFile(tmp_path / "slab.vtkhdf").provenance["ledgers"]
    assert {row["quantity"]: row["error"] for row in stored} == {row.quantity: row.error for row in result.ledgers}
    assert "closes to" in result.summary["ledger of heat"]


def test_momentum_is_kept_where_it_should_be():
    """If it failed, forces that are not opposite in each pair would push a free body along."""
    case = RubberRings(layers=4, duration=0.01)
    found = {ledger.quantity: ledger for ledger in case.run("cpu", 1).ledgers}
    assert found["momentum along x"].closes
    assert found["momentum along y"].closes
    assert "heat" not in found


@pytest.mark.parametrize(
    "case",
    [
        Drop(rows=6, duration=0.1, output_interval=0.1),
        MeltingRectangle(gravity=0.0, duration=0.1),
        MeltingTriangle(gravity=0.0, duration=0.1, strengths=(0.9,), until=(0.1,)),
        MeltingBlock(gravity=0.0, columns=10, rows=10, duration=0.1, output_interval=0.1),
    ],
    ids=lambda case: case.name,
)
def test_momentum_is_not_asked_for_where_it_is_not_kept(case):
    """If it failed, a floor, a source, friction or a surface would be reported as a fault of the program."""
    assert [ledger.quantity for ledger in case.run("cpu", 1).ledgers if "momentum" in ledger.quantity] == []


def warm(state) -> None:
    state.enthalpy.assign(state.numpy("enthalpy") * 1.00001)


def exchange_masses(state) -> None:
    mass = state.numpy("mass")
    mass[:2] *= (1.5, 0.5)
    state.mass.assign(mass)


@pytest.mark.parametrize(("tamper", "quantity"), [(warm, "heat"), (exchange_masses, "mass")])
def test_what_does_not_close_is_said(tamper, quantity):
    """If it failed, heat from nowhere, or mass that passes from one particle to another, would go unnoticed."""
    simulation = HeatGaussian(**HEAT).build(Executor("cpu", 1))
    with pytest.warns(UserWarning, match=f"ledger of {quantity} does not close: .* off by"):
        assert not ledgers(simulation, tamper)[quantity].closes


def test_an_untouched_run_is_not_warned_of():
    """If it failed, each run would end in a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = ledgers(HeatGaussian(**HEAT).build(Executor("cpu", 1)))
    assert np.all([ledger.closes for ledger in found.values()])
