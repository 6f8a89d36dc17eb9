"""The triangle that a source of heat melts, or not."""

import numpy as np
import pytest
import warp as wp

from warpsph.cases.case import preset_layer, resolve
from warpsph.errors import InputError
from warpsph.scenarios.bonded_solid.melting_rectangle import MeltingRectangle
from warpsph.scenarios.bonded_solid.melting_triangle import MeltingTriangle
from warpsph.scenarios.bonded_solid.outcome import Outcome
from warpsph.scenarios.bonded_solid.tables import published

TRIANGLE = published("triangle")


def outcome(case: MeltingTriangle, device: str = "cpu") -> Outcome:
    return Outcome(case.run(device=device), TRIANGLE)


def preset(name: str) -> MeltingTriangle:
    return resolve(MeltingTriangle, [preset_layer(MeltingTriangle, name)])


def test_the_published_solids_are_symmetric():
    """If it failed, a table would have been copied wrong, or a misprint be unmarked."""
    for name, corrected, misfits in (("triangle", False, 0), ("rectangle", False, 8), ("rectangle", True, 0)):
        table = published(name, corrected)
        whole = np.column_stack([table.places, table.velocities])
        mirrored = whole[table.partners] * (-1.0, 1.0, -1.0, 1.0)
        assert np.sum(np.any(np.abs(whole - mirrored) > 1e-9, axis=1)) == misfits
    bonds = np.linalg.norm(TRIANGLE.places[:, None] - TRIANGLE.places[None], axis=2)[np.triu_indices(28, 1)]
    assert np.sum(bonds < 1.5) == 63
    assert bonds.min() == pytest.approx(1.012, abs=5e-4)
    assert np.sum(TRIANGLE.velocities**2) / 2 == pytest.approx(73.5, abs=0.05)


def test_without_heat_it_stays_solid_and_symmetric(device):
    """If it failed, the bond, the step or the floor would not be those of the published solid."""
    run = outcome(MeltingTriangle(duration=2.0), device)
    assert run.most_fluid == 0
    assert run.asymmetry < 1e-9
    assert run.kinetic_energy.max() < 78.0


def test_fast_heating_as_printed_does_not_melt(device):
    """If it failed, what the page says of the printed strength would be wrong."""
    assert outcome(preset("fast_printed"), device).most_fluid == 0


def test_fast_heating_melts_the_top_which_is_solid_again(device):
    """If it failed, what the paper shows in figure 4.2 would not come out with a strength a fifth larger."""
    run = outcome(preset("fast_adjusted"), device)
    assert run.first_fluid == [28]
    assert run.first_fluid_time == pytest.approx(0.2)
    assert run.fluid_at_end == 0
    assert run.place(28)[0] < -2.0


@pytest.mark.slow
@pytest.mark.parametrize("kind", [MeltingTriangle, MeltingRectangle])
def test_every_check_passes(kind):
    """Otherwise `warpsph verify` would fail."""
    failed = [check for check in kind.verify(lambda case: case.run(device="cpu"), True) if not check.passed]
    assert failed == []


@pytest.mark.parametrize("name", ["adjusted", "fast_adjusted"])
def test_both_backends_go_the_same_way(name):
    """If it failed, the CPU and the GPU would compute different equations."""
    if not wp.is_cuda_available():
        pytest.skip("this machine has no CUDA device to compare with")
    case = type(preset(name))(**preset(name).model_dump() | {"duration": 0.1, "output_interval": 0.1})
    here, there = (case.run(device=device).fields["precise_position"] for device in ("cpu", "cuda:0"))
    assert np.abs(here - there).max() < 1e-9


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"repulsion_exponent": 4}, "repulsion_exponent = 4: must be above attraction_exponent, 4"),
        ({"cutoff": 1.0}, "cutoff = 1.0 ft: must be above the length of a bond at rest, 1.077 ft"),
        ({"output_interval": 0.05}, "output_interval = 0.05 s: must be a multiple of 0.1 s, the 1000 steps"),
        ({"duration": 0.25}, "duration = 0.25 s: must be a multiple of 0.1 s"),
        ({"strengths": (0.01,)}, "until = .*: needs one time for each of 1 strengths"),
        ({"strengths": (0.01, 0.02), "until": (2.0, 1.0)}, "until = .*: must be positive times that rise"),
    ],
)
def test_wrong_input_is_refused_in_one_line(changes, words):
    """If it failed, particles would collapse, or phases never be found."""
    with pytest.raises(InputError, match=words) as caught:
        MeltingTriangle(**changes)
    assert "\n" not in str(caught.value)


def test_a_step_that_is_too_long_is_refused():
    """If it failed, bonds would tear because the step is longer than their vibration."""
    with pytest.raises(InputError, match=r"time step 0.01 s is too long; limits: vibration of bonds"):
        MeltingTriangle(step=0.01, averaged_steps=10).run(device="cpu")
