"""What is said, once, when it happens."""

from types import SimpleNamespace

import numpy as np
import pytest

from warpsph.run.events import Events
from warpsph.scenarios.casting.alarms import Alarms
from warpsph.scenarios.casting.casting import Casting

CASE = Casting()


@pytest.fixture
def events() -> Events:
    return Events()


def alarms(events: Events, missing: int = 0) -> Alarms:
    part = SimpleNamespace(missing=SimpleNamespace(numpy=lambda: np.array([missing])))
    return Alarms(CASE, SimpleNamespace(inlet=part, spray=part), events)


def test_a_steady_strand_is_no_alarm(events):
    """False alarms are not read."""
    look = alarms(events)
    for time in (0.0, 0.5, 10.0):
        look(time, 0.44, 0.03)
    assert events.all == []
    assert events.outcome == ""


def test_a_shell_that_jumps_is_said_once(events):
    """Jumps are no casting; those of the start, when the shell comes to bear the melt, are expected."""
    look = alarms(events)
    look(0.2, 0.44, 0.4)
    assert events.all == []
    look(5.0, 0.44, 1.9)
    look(6.0, 0.44, 2.9)
    assert [(time, text[:33]) for time, text in events.all] == [(5.0, "warning: the shell jumps at 1.9 m")]


def test_a_strand_that_is_lost_is_the_outcome_of_the_run(events):
    """It would end as complete, with nothing in it."""
    look = alarms(events)
    look(3.0, 0.2, 0.01)
    assert events.outcome == "strand lost"
    assert events.all == [
        (3.0, "warning: the strand is lost: its level has fallen to 0.200 m, out of the mould"),
    ]


def test_reservoirs_that_are_empty_are_said(events):
    """The machine would run dry in silence."""
    alarms(events, missing=1)(2.0, 0.44, 0.01)
    assert [text for _, text in events.all] == [
        "warning: the reservoir has run out of melt", "warning: the reservoir has run out of water",
    ]  # fmt: skip


def test_alarms_are_remembered(events):
    """A run that goes on from where it stopped would say everything twice."""
    look = alarms(events)
    look(5.0, 0.2, 1.9)
    told, other = Events(), None
    told.restore(events.memory())
    other = alarms(told)
    other.restore(look.memory())
    other(6.0, 0.2, 1.9)
    assert told.all == events.all
    assert told.outcome == "strand lost"
