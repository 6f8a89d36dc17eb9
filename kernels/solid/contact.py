"""Contact of solids: bodies press on each other where their surfaces come close."""

import warp as wp

from warpsph.kernels.basics.labels import Role
from warpsph.kernels.basics.smoothing import NEAREST
from warpsph.kernels.neighbours.pairs import NeighbourList, entry_of, index_of, precise_difference

wp.set_module_options({"enable_backward": False})


@wp.struct
class ContactConstants:
    """Constants of the contact: ``reach`` [m] of a particle, and the force ``strength`` [N], [N/m] in 2D, of a pair."""

    reach: float
    strength: float


@wp.kernel
def add_contact_forces(
    first: int,
    contact: ContactConstants,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    role: wp.array[int],
    body: wp.array[int],
    mass: wp.array[float],
    acceleration: wp.array[wp.vec3],
):
    """Add the contact of particles of different bodies to ``acceleration`` (n,) [m/s^2].

    Two particles closer than the reach push each other apart with ``strength (1 - r / reach)^4``: the force has an
    energy, is equal and opposite, and fades so smoothly that surfaces made of particles slide over each other almost
    without friction. A body does not feel itself.
    """
    i = wp.tid() + first
    if role[i] == Role.FREE:
        force = wp.vec3()
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            if body[j] != body[i]:
                d = precise_difference(neighbours, position, position_carry, i, j)
                r = wp.max(wp.length(d), NEAREST * contact.reach)
                depth = wp.max(1.0 - r / contact.reach, 0.0)
                force += d * (contact.strength * depth * depth * depth * depth / r)
        acceleration[i] += force / mass[i]
