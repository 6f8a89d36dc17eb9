"""What bonds bear besides their elastic force, so that no force jumps where bonds come and go."""

import warp as wp

from warpsph.kernels.neighbours.pairs import NeighbourList, precise_difference
from warpsph.kernels.solid.bonds import UNCHANGED, BondList, partner_of, place_of, turn_of
from warpsph.kernels.solid.elasticity import borne_force, force_of_bond
from warpsph.kernels.solid.strain import ElasticConstants

wp.set_module_options({"enable_backward": False})

# The largest eigenvalue of the correction at both ends, above which a bond bears little. It is 1 inside a body and 2 at
# a face. What is borne does not yield as a stress does, and turns with a deformation that such a particle measures by
# that much too large: it would throw thin rows apart that are strained by tens of per cent.
WELL_HELD = wp.constant(4.0)


@wp.func
def is_well_held(correction: wp.mat33) -> bool:
    _, stretch = wp.eig3(correction)
    return wp.max(stretch) < WELL_HELD


@wp.kernel
def fade_bond_forces(first: int, interval: float, fading_time: float, least_force: float, bonds: BondList):
    """Let what bonds bear fade over ``fading_time`` [s] in an ``interval`` [s], below ``least_force`` to 0."""
    i = wp.tid() + first
    if bonds.count[i] > 0:
        left = wp.exp(-interval / fading_time)
        for b in range(bonds.count[i]):
            place = place_of(bonds, i, b)
            force = left * bonds.borne[place]
            bonds.borne[place] = wp.where(wp.length_sq(force) > least_force * least_force, force, wp.vec3())


@wp.kernel
def find_bond_forces(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body_volume: wp.array[float],
    correction: wp.array[wp.mat33],
    deformation: wp.array[wp.mat33],
    stress: wp.array[wp.mat33],
    was_held: wp.array[int],
):
    """Write the whole force of every bond [N], in 2D [N/m], before bonds come and go, and which ends ``was_held`` (n,)
    well then."""
    i = wp.tid() + first
    was_held[i] = int(is_well_held(correction[i]))
    for b in range(bonds.count[i]):
        place = place_of(bonds, i, b)
        j = partner_of(bonds, place)
        F = deformation[i] + deformation[j]
        x = precise_difference(neighbours, position, position_carry, i, j)
        force = force_of_bond(
            elastic, bonds, place, x, body_volume[j], F * bonds.separation[place], stress[i] + stress[j]
        )
        bonds.whole[place] = force * body_volume[i] + borne_force(bonds, place, F, elastic.planar)


@wp.kernel
def keep_bond_forces(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body_volume: wp.array[float],
    little_force: float,
    rebonded: wp.array[int],
    froze: wp.array[int],
    was_held: wp.array[int],
    correction: wp.array[wp.mat33],
    deformation: wp.array[wp.mat33],
    stress: wp.array[wp.mat33],
):
    """Let every bond bear what its whole force has more than its elastic one, where bonds have come or gone.

    Strain is kept there, but not what it does: with other neighbours the divergence of the stress has other weights,
    and what joins a strained body would at once be pushed by the stress of that. Nor would what freezes bear the
    pressure that it had as a fluid: it would set off at p / (rho c), some 0.2 m/s in a mould. So a new bond begins with
    the force that the pair had before, and one that stays keeps its own, until it has faded. Where that is more than
    a ``little_force`` [N], in 2D [N/m], ends that are not well held bear what they bore, at first the force that the
    pair had in the fluid.
    """
    i = wp.tid() + first
    for b in range(bonds.count[i]):
        place = place_of(bonds, i, b)
        j = partner_of(bonds, place)
        if rebonded[i] != UNCHANGED or rebonded[j] != UNCHANGED:
            F = deformation[i] + deformation[j]
            x = precise_difference(neighbours, position, position_carry, i, j)
            force = force_of_bond(
                elastic, bonds, place, x, body_volume[j], F * bonds.separation[place], stress[i] + stress[j]
            )
            rest = bonds.whole[place] - force * body_volume[i]
            is_new = froze[i] != 0 or froze[j] != 0
            held_now = is_well_held(correction[i]) and is_well_held(correction[j])
            held_before = is_new or (was_held[i] != 0 and was_held[j] != 0)
            back = wp.transpose(turn_of(F, elastic.planar))
            if wp.length(rest) <= little_force or (held_now and held_before):
                bonds.borne[place] = back * rest
            elif is_new:
                bonds.borne[place] = back * bonds.whole[place]
