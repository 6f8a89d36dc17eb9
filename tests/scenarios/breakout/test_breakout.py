"""The breakout: its reckoning, its control run, and its checks on made-up events."""

from dataclasses import replace

import numpy as np
import pytest

from warpsph.run.result import Result
from warpsph.scenarios.breakout.breakout import Breakout
from warpsph.scenarios.breakout.reckoning import remelting_delay


def test_the_heat_suffices_only_with_the_hotter_melt():
    """With the casting's own melt no failure of sprays could melt the shell, and nobody would know why."""
    assert all(check.passed for check in Breakout().reckoning())
    assert remelting_delay(Breakout(pouring_temperature=1933.15)) == np.inf


def test_without_failing_zones_nothing_fails():
    """The control run must be the same machine with its water on."""
    case = Breakout(spray_failing=(), duration=0.2, output_interval=0.1)
    result = case.run(device="cpu")
    assert result.events == []
    assert [check.quantity for check in case.checks(result) if not check.passed] == []
    assert "control" in case.checks(result)[-1].quantity


@pytest.fixture
def result() -> Result:
    diagnostics = {"time": np.zeros(1), "ledger_error": np.zeros(1), "hole_height": np.zeros(1)}
    diagnostics |= {name: np.zeros(1) for name in ("particles_inside", "particles_in", "particles_out")}
    events = [
        (2.5, "sprays fail in zone 1"),
        (9.0, "the shell thins: 8.0 mm at 0.190 m, zone 2 (failed)"),
        (12.5, "hole in the shell at 0.150 m, zone 3 (failed)"),
        (12.6, "melt runs out at 0.150 m, zone 3 (failed)"),
    ]
    return Result(
        positions=np.zeros((1, 3)),
        fields={"id": np.zeros(1, int)},
        diagnostics=diagnostics,
        quantities={},
        events=events,
        time=18.0,
        steps=1,
        status="complete",
        wall_time=0.0,
    )


def test_the_published_course_passes(result):
    """The checks must know their events again."""
    assert all(check.passed for check in Breakout().checks(result))


@pytest.mark.parametrize(
    "events",
    [
        [],
        [(9.0, "the shell thins: 8 mm"), (12.5, "hole in the shell at 0.3 m, in the mould"), (12.6, "melt runs out")],
        [(9.0, "the shell thins: 8 mm"), (12.5, "hole in the shell at 0.1 m, zone 4 (failed)")],
    ],
    ids=["nothing happens", "the mould opens", "nothing runs out"],
)
def test_another_course_fails(result, events):
    """A check that cannot fail is none."""
    assert not all(check.passed for check in Breakout().checks(replace(result, events=events)))
