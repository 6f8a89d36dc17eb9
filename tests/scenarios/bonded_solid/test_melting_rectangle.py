"""The rectangle on a hot floor."""

import numpy as np
import pytest

from warpsph.cases.case import preset_layer, resolve
from warpsph.core.executor import Executor
from warpsph.errors import InputError
from warpsph.scenarios.bonded_solid.melting_rectangle import MeltingRectangle
from warpsph.scenarios.bonded_solid.outcome import Outcome
from warpsph.scenarios.bonded_solid.particle_solid import FOOT
from warpsph.scenarios.bonded_solid.tables import published


def outcome(case: MeltingRectangle, device: str = "cpu") -> Outcome:
    return Outcome(case.run(device=device), published("rectangle", corrected=True))


def all_pairs(table, duration: float) -> np.ndarray:
    """Places (n, 2) [ft] after the equations of the paper in its units, over all pairs, by NumPy."""
    x, v, dt = table.places.copy(), table.velocities.copy(), 1e-4
    for k in range(round(duration / dt)):
        d = x[:, None] - x[None]
        r = np.sqrt(np.sum(d**2, axis=2)) + np.diag(np.full(len(x), 1e9))
        acceleration = np.sum(np.where(r <= 1.5, (-2540.0 / r**7 + 2940.0 / r**10) / r, 0.0)[:, :, None] * d, axis=1)
        acceleration[:, 1] -= 32.0
        v += (0.5 * dt if k == 0 else dt) * acceleration
        x += dt * v
        below = x[:, 1] < 0.0
        share = np.where(np.abs(x[:, 0]) < 5.0, 1.5 - 0.025 * (x[:, 0] + 5.0), 0.1)
        x[below, 1] *= -1.0
        v[below, 0] = 0.0
        v[below, 1] *= -share[below]
    return x


def test_the_equations_are_those_of_the_paper(device):
    """If it failed, the unit of length, a sign or an exponent would not be that of the paper."""
    case = resolve(MeltingRectangle, [preset_layer(MeltingRectangle, "printed")])
    result = type(case)(**case.model_dump() | {"duration": 0.2}).run(device=device)
    places = result.fields["precise_position"][:, :2] / FOOT
    assert np.abs(places - all_pairs(published("rectangle"), 0.2)).max() < 1e-10


@pytest.mark.parametrize("changes", [{"hot": 0.1}, {"hot_slope": 0.2}, {"hot_half_width": 40.0}])
def test_a_floor_that_would_give_back_less_than_nothing_is_refused(changes):
    """If it failed, the message would name numbers in metres that nobody gave."""
    with pytest.raises(InputError, match=r"hot_slope = .* 1/ft: the right end of the hot floor") as caught:
        MeltingRectangle(**{"hot_half_width": 5.0} | changes)
    assert "\n" not in str(caught.value)


def test_a_floor_may_give_back_nothing_at_its_right_end():
    """If it failed, rounding between feet and metres would refuse 0.12 - 0.02 * 6."""
    MeltingRectangle(hot=0.12, hot_slope=0.02, hot_half_width=3.0).build(Executor("cpu", 1))


def test_without_heat_it_stays_solid_and_symmetric(device):
    """If it failed, the bond, the step or the floor would not be those of the published solid."""
    run = outcome(MeltingRectangle(duration=1.0), device)
    assert run.most_fluid == 0
    assert run.asymmetry < 1e-9


def test_on_the_hot_floor_it_melts_and_flows_apart(device):
    """If it failed, what the paper shows in figure 5.2 would not come out."""
    run = outcome(MeltingRectangle.member("printed", 0), device)
    assert 2.0 < run.first_fluid_time <= 2.6
    assert run.fluid_at_end >= 30
    assert run.flows_apart(5.0)
