"""The three moments of a breakout, on particles placed by hand."""

import numpy as np
import pytest

from warpsph.core.labels import Phase, Role
from warpsph.core.particles import lattice
from warpsph.run.measured import Values, value_of
from warpsph.scenarios.breakout.breakout import Breakout
from warpsph.scenarios.casting.watch import ShellWatch

DX = 0.004
STEEL = 0
CASE = Breakout(spray_zones=3, spray_failing=(2, 3), spray_failure=2.0)
HEIGHTS = (np.arange(22) + 0.5) * 0.02


def strand(shell: float = 0.012, gap: tuple[float, float] = (0.0, 0.0)) -> dict[str, np.ndarray]:
    """A strand of steel with a shell [m], without one between two heights [m]."""
    points = lattice((0.0, 0.0), (0.1, 0.44), DX)
    solid = (points[:, 0] > 0.1 - shell) & ~((points[:, 1] > gap[0]) & (points[:, 1] < gap[1]))
    return {
        "position": points,
        "material": np.full(len(points), STEEL),
        "role": np.full(len(points), int(Role.FREE)),
        "phase": np.where(solid, int(Phase.SOLID), int(Phase.LIQUID)),
    }


def plain(values: Values) -> dict[str, float]:
    """What was measured, without what it is called."""
    return {name: value_of(given) for name, given in values.items()}


@pytest.fixture
def events():
    return []


@pytest.fixture
def watch(events):
    return ShellWatch(CASE, STEEL, lambda time, text: events.append((time, text)))


def test_a_sound_shell_is_no_event(watch, events):
    """False alarms would make the control run fail."""
    for time in (0.0, 1.5):
        values = watch(strand(), time, HEIGHTS, np.full(22, 0.012))
    assert events == []
    assert plain(values) == {"hole_height": 0.0, "escaped_melt": 0.0}


def test_thinning_is_measured_against_the_shell_before_the_failure(watch, events):
    """A shell that is thin by nature, near the mould, must not count as thinning."""
    thickness = np.linspace(0.02, 0.01, 22)
    watch(strand(), 1.5, HEIGHTS, thickness)
    watch(strand(), 2.5, HEIGHTS, thickness)
    assert [text for _, text in events] == ["sprays fail in zone 2, 3"]
    thin = np.where(np.abs(HEIGHTS - 0.07) < 0.025, 0.5, 1.0) * thickness
    watch(strand(), 3.5, HEIGHTS, thin)
    watch(strand(), 4.5, HEIGHTS, thin)
    assert events[1:] == [(3.5, f"the shell thins: {1e3 * thin[3]:.1f} mm at 0.070 m, zone 3 (failed)")]


def test_thinning_where_water_flows_is_none(watch, events):
    """Zone 1 still has its water."""
    thickness = np.full(22, 0.012)
    watch(strand(), 1.5, HEIGHTS, thickness)
    watch(strand(), 3.0, HEIGHTS, np.where((HEIGHTS > 0.18) & (HEIGHTS < 0.24), 0.3, 1.0) * thickness)
    assert [text for _, text in events] == ["sprays fail in zone 2, 3"]


def test_a_hole_and_what_runs_out_of_it_have_their_places(watch, events):
    """The zone decides whether the failure caused it."""
    values = watch(strand(gap=(0.102, 0.122)), 5.0, HEIGHTS, np.full(22, 0.012))
    assert plain(values)["hole_height"] == pytest.approx(0.016)
    state = strand()
    state["position"][0] = [0.13, 0.2, 0.0]
    assert plain(watch(state, 6.0, HEIGHTS, np.full(22, 0.012)))["escaped_melt"] == 1.0
    assert events[1:] == [
        (5.0, "hole in the shell at 0.112 m, zone 2 (failed)"),
        (6.0, "melt runs out at 0.200 m, zone 1 (sprayed)"),
    ]


def test_melt_outside_a_closed_shell_came_through_a_hole(watch, events):
    """A crack that is narrower than two rows is a hole all the same."""
    state = strand()
    state["position"][0] = [0.108, 0.15, 0.0]
    assert plain(watch(state, 6.0, HEIGHTS, np.full(22, 0.012))) == {"hole_height": 0.0, "escaped_melt": 0.0}
    assert events[1:] == [(6.0, "hole in the shell at 0.150 m, zone 2 (failed)")]


def test_a_drop_of_shell_is_no_melt(watch):
    """Bits of shell that hang outside are no outflow."""
    state = strand()
    state["position"][-1] = [0.13, 0.2, 0.0]
    state["phase"][-1] = Phase.SOLID
    assert plain(watch(state, 6.0, HEIGHTS, np.full(22, 0.012)))["escaped_melt"] == 0.0


def test_a_zone_that_will_fail_has_not_failed_yet(watch, events):
    """A hole at the start would be put down to a failure that comes later."""
    watch(strand(gap=(0.102, 0.122)), 0.1, HEIGHTS, np.full(22, 0.012))
    assert events == [(0.1, "hole in the shell at 0.112 m, zone 2 (sprayed)")]


def test_melt_over_the_mould_is_no_hole(watch, events):
    """A hole at 1.9 m, in the mould, would send people looking for it there."""
    state = strand()
    state["position"][0] = [0.13, 1.9, 0.0]
    assert plain(watch(state, 6.0, HEIGHTS, np.full(22, 0.012))) == {"hole_height": 0.0, "escaped_melt": 0.0}
    assert [text for _, text in events[1:]] == ["melt spills over the mould: it is at 1.900 m outside of it"]
