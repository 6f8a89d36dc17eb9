"""Launching kernels by the names of their arguments."""

import numpy as np
import pytest
import warp as wp

from warpsph.core.executor import Executor
from warpsph.core.launch import Launch
from warpsph.kernels.basics.motion import drift
from warpsph.kernels.neighbours.reorder import invert


def launch_with(device: str, **names: object) -> Launch:
    return Launch(Executor(device, 1), 3, names)


def test_arguments_are_found_by_their_names(device):
    """If it failed, a kernel would get another array than the one its signature asks for."""
    order = wp.array([2, 0, 1], dtype=int, device=device)
    place = wp.zeros(3, dtype=int, device=device)
    launch_with(device, place=place, order=order)(invert)
    assert place.numpy().tolist() == [1, 2, 0]


def test_the_nearest_scope_and_what_is_given_come_first(device):
    """If it failed, a term's own constant would be overridden by one of the same name elsewhere."""
    arrays = [wp.zeros(3, dtype=int, device=device) for _ in range(3)]
    launch = launch_with(device, place=arrays[0], order=wp.array([1, 2, 0], dtype=int, device=device))
    own = launch.within({"place": arrays[1]})
    own(invert)
    own(invert, place=arrays[2])
    assert [int(array.numpy().sum()) for array in arrays] == [0, 3, 3]


def test_a_missing_name_is_named():
    """If it failed, a misspelt field would end in an error that does not say which."""
    launch = launch_with("cpu", plce=wp.zeros(3, dtype=int), order=wp.zeros(3, dtype=int))
    with pytest.raises(TypeError, match=r"kernel invert asks for 'place'.*did you mean 'plce'"):
        launch(invert)


def test_an_unknown_given_name_is_named():
    """If it failed, a constant under a misspelt name would silently be ignored."""
    launch = launch_with("cpu", place=wp.zeros(3, dtype=int), order=wp.zeros(3, dtype=int))
    with pytest.raises(TypeError, match=r"kernel invert takes no argument 'oder'; did you mean 'order'"):
        launch(invert, oder=wp.zeros(3, dtype=int))


def test_a_wrong_type_is_named():
    """If it failed, a kernel would read the bytes of an array as something that they are not."""
    names = {name: wp.zeros(3, dtype=wp.vec3) for name in ("velocity", "position", "position_carry")}
    launch = launch_with("cpu", dt=0.1, role=wp.zeros(3, dtype=float), **names)
    with pytest.raises(Exception, match="role"):
        launch(drift)
    assert np.all(names["position"].numpy() == 0.0)
