"""What is refused before a run, and with which advice."""

import re

import pytest

from warpsph.core.executor import Executor
from warpsph.errors import InputError
from warpsph.scenarios.breakout.breakout import Breakout
from warpsph.scenarios.casting.casting import Casting
from warpsph.scenarios.casting.feasibility import refuse_what_cannot_hold

DEEP = {"density": 7000.0, "casting_speed": 0.02, "mould_bottom": 0.4, "mould_top": 1.3, "level": 1.2}
DEEP |= {"nozzle_mouth": 1.0, "roll_first": 0.38}


@pytest.mark.parametrize(
    ("given", "key"),
    [
        ({"sound_speed": 5.0}, "sound_speed"),
        (DEEP | {"viscosity": 30.0}, "sound_speed"),
        (DEEP | {"sound_speed": 20.0, "viscosity": 30.0}, "youngs_modulus"),
        ({"casting_speed": 0.04}, "casting_speed"),
        ({"youngs_modulus": 2e3}, "youngs_modulus"),
        ({"sound_speed": 100.0}, "sound_speed"),
        ({"spray_flux": 50.0}, "spray_particle"),
    ],
)
def test_the_advice_does(given, key):
    """A strand that is lost after a second of simulated time is minutes of somebody's life, and no word why."""
    with pytest.raises(InputError, match=f"{key} ") as refused:
        refuse_what_cannot_hold(Casting(**given))
    value = float(re.search(r"([\d.e+-]+) (m/s|Pa|kg) would do", str(refused.value))[1])
    try:
        refuse_what_cannot_hold(Casting(**given | {key: value}))
    except InputError as next_one:
        assert not str(next_one).startswith(key)  # noqa: PT017
    at_most = "at most" in str(refused.value) or key == "casting_speed"
    with pytest.raises(InputError, match=key):
        refuse_what_cannot_hold(Casting(**given | {key: value * (1.1 if at_most else 0.9)}))


@pytest.mark.parametrize(
    ("given", "key"),
    [
        ({"half_width": 0.02, "nozzle_width": 0.01}, None),
        ({"half_width": 0.02, "nozzle_width": 0.01, "spacing": 0.002}, "nozzle_width"),
        ({"half_width": 0.05, "nozzle_width": 0.025}, "nozzle_width"),
        ({"half_width": 0.05, "nozzle_width": 0.025, "dimension": 3}, "nozzle_width"),
        ({"half_width": 0.045, "nozzle_port": "side", "nozzle_reach": 0.0311, "nozzle_width": 0.006}, "nozzle_reach"),
    ],
)
def test_a_nozzle_in_the_shell_or_the_mould_is_refused(given, key):
    """Its walls would stand where the mould's particles are, or a gauge that nobody has asked for would be blamed."""
    case = Casting(**given)
    with pytest.raises(InputError, match=r"nozzle_(width|reach) = .* half_width") as refused:
        case.build(Executor("cpu"))
    advised = re.search(r"at most ([\d.]+) m would do", str(refused.value))
    assert (advised is None) == (key is None)
    if advised:
        low, high = case.model_copy(update={key: float(advised[1])}).beside_nozzle
        assert low == high - 1


def test_a_nozzle_on_which_the_shell_grows_is_refused():
    """The melt between the two would be squeezed, and the shell would jump."""
    narrow = {"half_width": 0.04, "nozzle_width": 0.006, "casting_speed": 0.004, "spray_flux": 0.1}
    with pytest.raises(InputError, match=r"nozzle_mouth = 0.36: the shell is 22.* half_width 0.04 m"):
        refuse_what_cannot_hold(Casting(**narrow))
    refuse_what_cannot_hold(Casting(**narrow, nozzle_mouth=0.42))


def test_what_holds_is_not_refused():
    """The presets are known to hold."""
    for case in (Casting(), Casting(spacing=0.002), Breakout(), Casting(casting_speed=0.012)):
        refuse_what_cannot_hold(case)


def test_water_that_takes_more_heat_than_there_is_is_refused():
    """If it failed, the strand of the start would be below 0 K, or a word of particles would not say why."""
    with pytest.raises(InputError, match=r"spray_flux = 1.2: the strand of the start would fall to -[\d.]+ K; less"):
        Casting(spray_flux=1.2).build(Executor("cpu"))


def test_it_is_refused_before_anything_is_made():
    """The scenario itself asks, whoever builds it."""
    with pytest.raises(InputError, match="sound_speed"):
        Casting(sound_speed=5.0).run(device="cpu")
