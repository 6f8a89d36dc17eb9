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
