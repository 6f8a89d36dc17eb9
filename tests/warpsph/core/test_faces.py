"""Where the faces of a box are, seen from the walls around it, and how these move."""

import numpy as np
import pytest

from warpsph.core.faces import velocity_of_faces, way_to_box
from warpsph.core.particles import tank
from warpsph.errors import InputError

LID = {"+y": (1.0, 0.0, 0.0)}


def test_walls_know_the_way_to_their_face():
    """If it failed, a wall would act at another place than its face."""
    points = np.array([[0.5, -0.1, 0.0], [1.2, 0.5, 0.0], [1.2, 1.3, 0.0]])
    way = way_to_box(points, (0.0, 0.0, 0.0), (1.0, 1.0, 0.0))
    np.testing.assert_allclose(way, [[0.0, 0.1, 0.0], [-0.2, 0.0, 0.0], [-0.2, -0.3, 0.0]])


def test_a_corner_moves_with_the_mean_of_its_faces():
    """If it failed, a lid would drive the fluid into the corner where it meets a wall at rest, and out of the box."""
    points = np.array([[0.5, 1.1, 0.0], [1.1, 1.1, 0.0], [1.1, 0.5, 0.0], [-0.1, 1.1, -0.1], [0.5, -0.1, 0.0]])
    way = way_to_box(points, (0.0, 0.0, 0.0), (1.0, 1.0, 1.0))
    np.testing.assert_allclose(velocity_of_faces(way, LID)[:, 0], [1.0, 0.5, 0.0, 1.0 / 3.0, 0.0])
    both = velocity_of_faces(way, LID | {"+x": (0.0, 2.0, 0.0)})
    np.testing.assert_allclose(both[:3], [[1.0, 0.0, 0.0], [0.5, 1.0, 0.0], [0.0, 2.0, 0.0]])


@pytest.mark.parametrize(("velocities", "said"), [({"top": (1.0, 0.0, 0.0)}, "no face"), ({"+y": (1.0,)}, "three")])
def test_what_is_no_face_and_no_velocity_is_refused(velocities, said):
    """If it failed, a misspelt lid would rest."""
    with pytest.raises(InputError, match=said):
        velocity_of_faces(np.zeros((1, 3)), velocities)


def test_a_lid_closes_a_tank():
    """If it failed, a closed box would have holes, or rows of walls in the fluid."""
    closed = tank((0.0, 0.0), (1.0, 1.0), 0.1, lid=True)
    assert len(closed) == 16**2 - 10**2
    np.testing.assert_allclose(np.sort(closed[:, 1]), np.sort(1.0 - closed[:, 1]), atol=1e-12)
