"""What bonds bear besides their elastic force, so that no force jumps where bonds come and go."""

import warp as wp

from warpsph.kernels.neighbours.pairs import NeighbourList, precise_difference
from warpsph.kernels.solid.bonds import SMALLEST_VOLUME, UNCHANGED, BondList, partner_of, place_of
from warpsph.kernels.solid.elasticity import force_of_bond
from warpsph.kernels.solid.strain import ElasticConstants

wp.set_module_options({"enable_backward": False})

# The largest eigenvalue of the correction at both ends, above which a bond bears the fluid's force only. It is 1 inside
# a body and 2 at a face. A force that is borne turns and stretches with a deformation that such a particle measures by
# that much too large, and does not yield as a stress does: it throws thin rows apart.
WELL_HELD = wp.constant(4.0)


@wp.func
def is_well_held(correction: wp.mat33) -> bool:
    _, stretch = wp.eig3(correction)
    return wp.max(stretch) < WELL_HELD


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
        bonds.whole[place] = force * body_volume[i] + F * (0.5 * bonds.borne[place])


@wp.kernel
def keep_bond_forces(
    first: int,
    elastic: ElasticConstants,
    bonds: BondList,
    neighbours: NeighbourList,
    position: wp.array[wp.vec3],
    position_carry: wp.array[wp.vec3],
    body_volume: wp.array[float],
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
    the force that the pair had before, and one that stays keeps its own.
    """
    i = wp.tid() + first
    for b in range(bonds.count[i]):
        place = place_of(bonds, i, b)
        j = partner_of(bonds, place)
        if rebonded[i] != UNCHANGED or rebonded[j] != UNCHANGED:
            F = deformation[i] + deformation[j]
            is_new = froze[i] != 0 or froze[j] != 0
            if wp.determinant(0.5 * F) <= SMALLEST_VOLUME:
                bonds.borne[place] = wp.vec3()
            elif (
                is_well_held(correction[i])
                and is_well_held(correction[j])
                and (is_new or (was_held[i] != 0 and was_held[j] != 0))
            ):
                x = precise_difference(neighbours, position, position_carry, i, j)
                force = force_of_bond(
                    elastic, bonds, place, x, body_volume[j], F * bonds.separation[place], stress[i] + stress[j]
                )
                bonds.borne[place] = wp.inverse(0.5 * F) * (bonds.whole[place] - force * body_volume[i])
            elif is_new:
                bonds.borne[place] = wp.inverse(0.5 * F) * bonds.whole[place]
